#include "sample_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace planish::test {
namespace {

TEST(StripDerivatives, InCoordinatesOfShapesThatMeetTheirEndsAreDifferences) {
  StripProblem problem = problem_with_everything(9);
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::right_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::normal, Vec3::UnitX(), 0}};
  const Reach reach = meet_ends(problem, random_parameters(problem.base, 5, 0.3));
  ASSERT_TRUE(reach.met()) << reach.violation;
  const EndChart chart(problem, reach.p);
  const Eigen::VectorXd at = Eigen::VectorXd::Constant(chart.dimensions(), 0.01);
  const auto shape = chart.shape(at);
  ASSERT_TRUE(shape);
  EXPECT_LE(end_violation(problem, folded(problem.base, *shape)).cwiseAbs().maxCoeff(), kEndsMet);
  const auto residuals_at = [&](const Eigen::VectorXd& xi) {
    Eigen::VectorXd r(problem.residuals());
    EXPECT_TRUE(evaluate(problem, *chart.shape(xi), r, nullptr));
    return r;
  };
  Eigen::VectorXd residuals(problem.residuals());
  RowMatrix full(problem.residuals(), problem.parameters());
  Eigen::Ref<RowMatrix> jacobian(full);
  ASSERT_TRUE(evaluate(problem, *shape, residuals, &jacobian));
  const auto expected = differences(residuals_at, at);
  EXPECT_LE((chart.derivative(*shape, full) - expected).cwiseAbs().maxCoeff(),
            1e-6 * expected.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace planish::test
