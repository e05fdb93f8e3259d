#include "bent_fold.hpp"

#include "sample_strips.hpp"

#include <cmath>

// The material that is bent with a fold: its widths in closed form, their derivatives.

namespace planish::test {
namespace {

/// A wedge between lines through an apex, whose ridges lie square to one axis: all are bent on the
/// same width everywhere, whatever the strip's.
TEST(BentFold, OfAWedgeIsAsWideAsItsRidgesAreApart) {
  StripProblem problem = bare_problem(10);
  StripBase& base = problem.base;
  base.start = {0.0, 0.0};
  base.end = {400.0, 400.0};
  base.sides = {EdgeCurve({{0, 0}, {400, 80}}, 0.0, 400.0),
                EdgeCurve({{0, 200}, {400, 120}}, 0.0, 400.0)};
  EXPECT_NEAR(base.width(), 120.0, 1e-9);
  EXPECT_NEAR(base.area(), 400.0 * 120.0, 1e-6);
  const StripParameters p = flat_parameters(base);
  for (int ridge = 0; ridge <= 10; ++ridge)
    for (int side = 0; side < 2; ++side) {
      const BentFold fold = fold_at(problem, p, ridge);
      EXPECT_NEAR(fold.bent(side), ridge == 0 || ridge == 10 ? 20.0 : 40.0, 1e-9);
      EXPECT_NEAR(fold.along().norm(), 200.0 - 0.4 * 40.0 * ridge, 1e-9);
    }
}

TEST(BentFold, BelongsToTheLastRidgeWholeWhereTheEndIsHeld) {
  StripProblem problem = bare_problem(6);
  problem.base.start = {200.0, 200.0};
  const StripParameters p = flat_parameters(problem.base);
  EXPECT_NEAR(fold_at(problem, p, 5).bent(0), 60.0, 1e-9);
  problem.ends = {{EndCondition::Of::normal, Vec3::UnitX(), 0.0}};
  EXPECT_NEAR(fold_at(problem, p, 5).bent(0), 90.0, 1e-9);
  EXPECT_NEAR(fold_at(problem, p, 5).radius(0.2), 45.0 / std::tan(0.1), 1e-9);
}

TEST(BentFold, HasTheDerivativesOfItsDifferences) {
  for (const StripBase& base : both_bases(6)) {
    StripProblem problem = bare_problem(6);
    problem.base = base;
    const StripParameters p = random_parameters(base, 5, 0.5);
    for (const int ridge : {0, 1, 3, 5}) {
      const auto numbers = numbers_of_fold(base, ridge);
      const auto values = [&](const StripParameters& x) -> Eigen::VectorXd {
        const BentFold fold = fold_at(problem, x, ridge);
        return Vec3(fold.along().squaredNorm(), fold.swept(0), fold.swept(1));
      };
      const auto all = [&](const StripParameters& x) {
        const BentFold fold = fold_at(problem, x, ridge);
        return std::array<OfPlaces, 3>{fold.square_of_length(), fold.swept_by(0), fold.swept_by(1)};
      };
      const Eigen::MatrixXd expected = differences(values, p);
      for (int which = 0; which < 3; ++which) {
        const OfPlaces found = all(p)[which];
        EXPECT_NEAR(found.value, values(p)[which], 1e-9);
        const Eigen::MatrixXd second = differences(
            [&](const StripParameters& x) -> Eigen::VectorXd { return all(x)[which].gradient; }, p);
        for (int i = 1; i < kOfFold; ++i) {
          if (numbers[i] < 0) continue;
          EXPECT_NEAR(found.gradient[i] * base.unit(), expected(which, numbers[i]),
                      1e-5 * expected.cwiseAbs().maxCoeff());
          for (int j = 1; j < kOfFold; ++j) {
            if (numbers[j] < 0) continue;
            EXPECT_NEAR(found.hessian(j, i) * base.unit(), second(j, numbers[i]),
                        1e-5 * second.cwiseAbs().maxCoeff());
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace planish::test
