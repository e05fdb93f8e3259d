#include "end_curvature.hpp"

#include "sample_strips.hpp"

// Second derivatives of what moves with a strip against differences of the first.

namespace planish::test {
namespace {

TEST(EndCurvature, IsThatOfDifferences) {
  Eigen::VectorXd multipliers(6);
  multipliers << 1.0, -2.0, 0.5, 3.0, -1.5, 0.7;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const StripProblem problem = problem_with_everything(both_bases(6)[seed % 2]);
    const StripParameters p = random_parameters(problem.base, seed, 0.9);
    const StripFold fold = folded(problem.base, p);
    const Eigen::MatrixXd second = second_derivatives(
        problem.base, p, fold, weighed_conditions(problem, fold, multipliers));
    const auto expected = differences(
        [&](const StripParameters& x) -> Eigen::VectorXd {
          return end_derivative(problem, folded(problem.base, x)).transpose() * multipliers;
        },
        p);
    EXPECT_LE((second - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
  }
}

/// Ends of ridges in the middle slide along their quads' edges, too.
TEST(EndCurvature, OfRidgeEndsIsThatOfDifferences) {
  const Vec3 weight(0.3, -1.2, 0.7);
  for (const int ridge : {1, 3, 6})
    for (const int number : {0, 1, 2, 3}) {
      const StripBase base = both_bases(6)[number / 2];
      const int side = number % 2;
      const StripParameters p = random_parameters(base, 3, 0.9);
      const StripFold fold = folded(base, p);
      const Eigen::MatrixXd second = second_derivatives(
          base, p, fold, {{ridge, true, fold.end(side, ridge), weight, side}});
      const auto expected = differences(
          [&](const StripParameters& x) -> Eigen::VectorXd {
            const StripFold at = folded(base, x);
            return end_derivative(base, at, twists(base, at), side, ridge).transpose() * weight;
          },
          p);
      EXPECT_LE((second - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff())
          << ridge << " " << side;
    }
}

/// The wishes' derivative is what they pull by.
TEST(Pulls, AreTheDerivativeOfWishes) {
  StripProblem problem = problem_with_everything(6);
  problem.objective = SlitObjective::energy;
  std::erase_if(problem.inequalities, [](const Inequality& one) {
    return std::holds_alternative<RadiusLimit>(one.what);
  });
  problem.weights.spacing = 0.0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    const StripFold fold = folded(problem.base, p);
    Eigen::VectorXd residuals(problem.residuals());
    RowMatrix full(problem.residuals(), problem.parameters());
    Eigen::Ref<RowMatrix> jacobian(full);
    ASSERT_TRUE(evaluate(problem, p, residuals, &jacobian));
    residuals.head(problem.base.quads - 1).setZero();  // middles are no wish
    Eigen::VectorXd pulled = Eigen::VectorXd::Zero(p.size());
    for (const Pull& pull : pulls(problem, fold))
      pulled += end_derivative(problem.base, fold, twists(problem.base, fold), pull.side,
                               pull.ridge)
                    .transpose() *
                pull.gradient;
    const Eigen::VectorXd expected = full.transpose() * residuals;
    EXPECT_LE((pulled - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace planish::test
