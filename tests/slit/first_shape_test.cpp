#include "first_shape.hpp"

#include "sample_strips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

/// A strip 200 long and 40 wide that leaves an upright panel at x = distance, its end to lie in the
/// plane x = 0.
StripProblem up_to_plane(double distance) {
  StripProblem problem;
  problem.base.facet = frame_from_axes({distance, 0, 0}, Vec3::UnitX(), Vec3::UnitY());
  problem.base.sides = {0.0, 40.0};
  problem.base.start = {100.0, 100.0};
  problem.base.end = 300.0;
  problem.base.quads = 12;
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), 0.0},
                  {EndCondition::Of::right_end, Vec3::UnitX(), 0.0},
                  {EndCondition::Of::normal, Vec3::UnitX(), 0.0}};
  problem.mirrored = true;
  return problem;
}

TEST(FirstShapes, WithoutEndConditionsAreTheFlatOneAlone) {
  StripProblem problem;
  problem.base = some_base(9);
  const auto shapes = first_shapes(problem);
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_EQ(shapes[0], flat_parameters(problem.base));
}

TEST(FirstShapes, EndAtARightAngleToThePlaneAndNearIt) {
  for (const double distance : {60.0, 110.0, 180.0}) {
    const StripProblem problem = up_to_plane(distance);
    const auto shapes = first_shapes(problem);
    ASSERT_GT(shapes.size(), 1u);
    EXPECT_EQ(shapes.back(), flat_parameters(problem.base));
    const StripParameters& best = shapes.front();
    EXPECT_TRUE(is_shape(problem.base, best));
    EXPECT_NEAR(std::abs(best.head(problem.base.quads).sum()), std::numbers::pi / 2, 1e-12);
    const StripFold fold = folded(problem.base, best);
    for (int side = 0; side < 2; ++side)
      EXPECT_NEAR(fold.end(side, problem.base.quads).x(), 0.0, 0.05 * problem.base.unit())
          << distance;
  }
}

TEST(FirstShapes, AreBentInOnePlane) {
  const StripProblem problem = up_to_plane(110.0);
  for (const StripParameters& shape : first_shapes(problem)) {
    const StripFold fold = folded(problem.base, shape);
    for (int ridge = 0; ridge <= problem.base.quads; ++ridge) {
      const Vec3 across = fold.end(1, ridge) - fold.end(0, ridge);
      EXPECT_NEAR((across - 40.0 * problem.base.facet.y).norm(), 0.0, 1e-10);
    }
  }
}

}  // namespace
}  // namespace planish::test
