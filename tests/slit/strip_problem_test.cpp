#include "sample_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace planish::test {
namespace {

TEST(StripDerivatives, OfTheObjectiveAreDifferences) {
  const StripProblem problem = problem_with_everything(7);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    Eigen::VectorXd residuals(problem.residuals());
    RowMatrix full(problem.residuals(), problem.parameters());
    Eigen::Ref<RowMatrix> jacobian(full);
    ASSERT_TRUE(evaluate(problem, p, residuals, &jacobian));
    const auto expected = differences(
        [&](const StripParameters& x) {
          Eigen::VectorXd r(problem.residuals());
          EXPECT_TRUE(evaluate(problem, x, r, nullptr));
          return r;
        },
        p);
    EXPECT_LE((full - expected).cwiseAbs().maxCoeff(), 1e-6 * full.cwiseAbs().maxCoeff()) << seed;
    EXPECT_TRUE(residuals.allFinite());
  }
}

TEST(StripDerivatives, OfEndConditionsAreDifferences) {
  const StripProblem problem = problem_with_everything(6);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 1.0);
    const auto expected = differences(
        [&](const StripParameters& x) { return end_violation(problem, folded(problem.base, x)); },
        p);
    EXPECT_LE((end_derivative(problem, folded(problem.base, p)) - expected).cwiseAbs().maxCoeff(),
              1e-7);
  }
}

TEST(StripObjective, KeepsItsSmoothnessUnderSubdivision) {
  // Of κ(s) = a s² the sum of squared second differences tends to ∫ κ″² ds.
  StripProblem problem;
  double values[2];
  for (const int level : {0, 1}) {
    const int quads = 200 << level;
    problem.base = some_base(quads);
    problem.weights = {.smooth = 1.0, .spacing = 0.0};
    StripParameters p = flat_parameters(problem.base);
    for (int i = 0; i < quads; ++i)
      p[i] = (i + 0.5) * (i + 0.5) / std::pow(quads, 3.0);
    Eigen::VectorXd residuals(problem.residuals());
    ASSERT_TRUE(evaluate(problem, p, residuals, nullptr));
    values[level] = residuals.squaredNorm();
  }
  EXPECT_NEAR(values[1] / values[0], 1.0, 0.02);
}

TEST(StripObjective, TakesTheBarrierOfSpacingsUpToAConstant) {
  StripProblem problem;
  problem.base = some_base(6);
  problem.weights = {.smooth = 0.0, .spacing = 1.0};
  const auto difference = [&](unsigned seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.0);
    Eigen::VectorXd residuals(problem.residuals());
    EXPECT_TRUE(evaluate(problem, p, residuals, nullptr));
    double barrier = 0.0;
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 6; ++i)
        barrier += (problem.base.end - problem.base.start[side]) / 6 /
                   (abscissa(problem.base, p, i + 1, side) - abscissa(problem.base, p, i, side));
    return residuals.squaredNorm() - barrier / 6;
  };
  EXPECT_NEAR(difference(1), difference(2), 1e-12);
  EXPECT_NEAR(difference(1), -2.0, 1e-12);
}

}  // namespace
}  // namespace planish::test
