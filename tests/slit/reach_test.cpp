#include "sample_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

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

/// A strip whose end is to be in the plane x = `value`.
StripProblem to_plane(int quads, double value) {
  StripProblem problem;
  problem.base = some_base(quads);
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), value},
                  {EndCondition::Of::right_end, Vec3::UnitX(), value}};
  return problem;
}

TEST(MeetEnds, ConvergesInAFewSteps) {
  int met = 0;
  for (const int quads : {5, 10, 20})
    for (unsigned seed = 0; seed < 10; ++seed) {
      const StripProblem problem = to_plane(quads, 60.0);
      const StripParameters from = random_parameters(problem.base, seed, 0.3);
      const Reach reach = meet_ends(problem, from);
      if (!reach.met()) continue;  // from some shapes no step leads there
      ++met;
      EXPECT_LE(reach.iterations, 20) << quads << ' ' << seed;
      EXPECT_TRUE(is_shape(problem.base, reach.p));
      const StripFold fold = folded(problem.base, reach.p);
      for (int side = 0; side < 2; ++side)
        EXPECT_NEAR(fold.end(side, quads).x(), 60.0, 1e-9 * problem.base.unit());
      // What is met already is left alone.
      const Reach again = meet_ends(problem, reach.p);
      EXPECT_LE(again.iterations, 1);
      EXPECT_LT((again.p - reach.p).norm(), 1e-9);
    }
  EXPECT_GE(met, 27);
}

TEST(MeetEnds, TurnsNoRidgeFarAndNarrowsNoQuadMuchInAStep) {
  for (const double value : {-700.0, 900.0})
    for (unsigned seed = 0; seed < 10; ++seed) {
      const StripProblem problem = to_plane(8, value);
      const StripParameters from = random_parameters(problem.base, seed, 0.4);
      const Reach reach = meet_ends(problem, from, 1);
      ASSERT_EQ(reach.iterations, 1);
      const double turned = (reach.p - from).head(8).cwiseAbs().maxCoeff();
      double kept = 1.0;
      for (int quad = 0; quad < 8; ++quad)
        for (int side = 0; side < 2; ++side) {
          const auto spacing = [&](const StripParameters& p) {
            return abscissa(problem.base, p, quad + 1, side) -
                   abscissa(problem.base, p, quad, side);
          };
          kept = std::min(kept, spacing(reach.p) / spacing(from));
        }
      EXPECT_LE(turned, 0.25 + 1e-12) << seed;
      EXPECT_GE(kept, 0.5 - 1e-12) << seed;
      if (turned > 0.0) {
        EXPECT_TRUE(turned > 0.25 - 1e-9 || kept < 0.5 + 1e-9) << "as far as it may: " << seed;
      }
    }
}

TEST(MeetEnds, RatherFoldsThanMovesRidges) {
  // Abscissae move a twentieth as readily as angles.
  const StripProblem problem = to_plane(10, 60.0);
  const StripParameters from = random_parameters(problem.base, 1, 0.3);
  const StripParameters moved = meet_ends(problem, from).p - from;
  EXPECT_LT(moved.tail(18).norm(), 0.1 * moved.head(10).norm());
  EXPECT_GT(moved.tail(18).norm(), 0.0);
}

TEST(MeetEnds, ComesNearerToWhatIsOutOfReach) {
  const StripProblem problem = to_plane(6, 2000.0);
  const StripParameters from = random_parameters(problem.base, 3, 0.2);
  const Reach reach = meet_ends(problem, from);
  EXPECT_FALSE(reach.met());
  EXPECT_NEAR(reach.violation,
              end_violation(problem, folded(problem.base, reach.p)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(reach.violation,
            end_violation(problem, folded(problem.base, from)).cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace planish::test
