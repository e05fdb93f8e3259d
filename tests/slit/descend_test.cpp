#include "descend.hpp"

#include "reach.hpp"
#include "sample_strips.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(Descend, FindsEqualSpacing) {
  // Without folds to smooth and ends to meet, the barrier is least at equal spacing.
  StripProblem problem;
  problem.base = some_base(6);
  problem.weights = {.smooth = 0.0, .spacing = 1.0};
  const Descent descent = descend(problem, random_parameters(problem.base, 4, 0.0),
                                  {.function_tolerance = 1e-14});
  EXPECT_TRUE(descent.converged);
  EXPECT_NEAR(descent.objective, 0.0, 1e-12);
  EXPECT_NEAR((descent.p - flat_parameters(problem.base)).norm(), 0.0, 1e-6);
}

TEST(Descend, StaysOnTheEndConditions) {
  StripProblem problem;
  problem.base = some_base(8);
  problem.weights = {.smooth = 1.0, .spacing = 0.1};
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::right_end, Vec3::UnitX(), 60}};
  const Reach start = meet_ends(problem, random_parameters(problem.base, 2, 0.3));
  ASSERT_TRUE(start.met());
  Eigen::VectorXd residuals(problem.residuals());
  ASSERT_TRUE(evaluate(problem, start.p, residuals, nullptr));
  const Descent descent = descend(problem, start.p, {});
  EXPECT_LT(descent.objective, 0.1 * 0.5 * residuals.squaredNorm());
  EXPECT_LE(end_violation(problem, folded(problem.base, descent.p)).cwiseAbs().maxCoeff(),
            kEndsMet);
}

TEST(Descend, StopsWhenAsked) {
  StripProblem problem;
  problem.base = some_base(8);
  const Descent descent = descend(problem, random_parameters(problem.base, 2, 0.3),
                                  {.stop = [] { return true; }});
  EXPECT_FALSE(descent.converged);
  EXPECT_LE(descent.iterations, 1);
}

}  // namespace
}  // namespace planish::test
