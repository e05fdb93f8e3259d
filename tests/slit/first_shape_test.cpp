#include "first_shape.hpp"

#include "sample_strips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
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
  problem.base.end = {300.0, 300.0};
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

TEST(FirstShapes, IsAnArcWhereAnArcLeadsThere) {
  // A quarter of a circle of length L ends 2 L / pi away.
  const StripProblem problem = up_to_plane(200.0 * 2.0 / std::numbers::pi);
  const StripParameters best = first_shapes(problem).front();
  const double sign = best[0] < 0.0 ? -1.0 : 1.0;
  for (int ridge = 1; ridge < 11; ++ridge)  // the last quad takes the angle of the end itself
    EXPECT_NEAR(sign * best[ridge], std::numbers::pi / 2 / 12, 0.03) << ridge;
  EXPECT_NEAR(best.head(12).sum(), sign * std::numbers::pi / 2, 1e-12);
}

TEST(FirstShapes, OnTheOtherSideOfThePlaneAreTheMirroredOnes) {
  for (const double distance : {60.0, 150.0}) {
    const StripProblem here = up_to_plane(distance);
    StripProblem there = up_to_plane(-distance);
    const StripParameters a = first_shapes(here).front(), b = first_shapes(there).front();
    EXPECT_LT((a.head(12) + b.head(12)).norm(), 1e-9) << "folds the other way";
    const Vec3 end = folded(there.base, b).end(0, 12);
    EXPECT_NEAR(end.x(), 0.0, 0.05 * 200);
  }
}

TEST(FirstShapes, OfAPanelThatLeansEndAtARightAngleToo) {
  for (const double lean : {-0.6, 0.4, 1.0}) {
    StripProblem problem = up_to_plane(110.0);
    const Vec3 up(std::sin(lean), std::cos(lean), 0.0);
    problem.base.facet = frame_from_axes({110.0 - 100.0 * up.x(), 0, 0},
                                         Vec3(std::cos(lean), -std::sin(lean), 0.0), up);
    const StripParameters best = first_shapes(problem).front();
    const StripFold fold = folded(problem.base, best);
    EXPECT_NEAR(std::abs(fold.quad(11).x.x()), 1.0, 1e-9) << lean;
    EXPECT_NEAR(fold.end(0, 12).x(), 0.0, 0.06 * 200) << lean;
  }
}

TEST(FirstShapes, RiseToTheSeatAsMuchAsItWeighs) {
  const double start = 100.0;
  const auto height = [&](double seat_height, double seat, double smooth, bool with_seat = true) {
    StripProblem problem = up_to_plane(110.0);
    problem.weights.seat = seat;
    problem.weights.smooth = smooth;
    if (with_seat) {
      problem.seat = std::make_shared<const BezierSearch>(
          BezierCurve{{{seat_height, -500}, {seat_height, 500}}});
      problem.seat_places = {Vec2(seat_height, 0), Vec2(seat_height, 40)};
    }
    const StripParameters best = first_shapes(problem).front();
    return folded(problem.base, best).end(0, 12).y();
  };
  for (const double wanted : {start + 60.0, start + 120.0, start + 150.0})
    EXPECT_NEAR(height(wanted, 1.0, 0.01), wanted, 0.05 * 200) << wanted;
  // What weighs a millionth of the smoothness changes nothing.
  const double free = height(0, 1.0, 1.0, false);
  for (const double wanted : {start + 20.0, start + 160.0})
    EXPECT_NEAR(height(wanted, 1e-6, 1.0), free, 2.0) << wanted;
}

/// A strip like that of `up_to_plane` whose end is to be at a place, or to run in a direction.
StripProblem to_place(const Vec3* place, const Vec3* direction) {
  StripProblem problem = up_to_plane(0.0);
  problem.mirrored = false;
  problem.ends.clear();
  if (place)
    for (int axis = 0; axis < 3; ++axis)
      problem.ends.push_back({EndCondition::Of::middle, Vec3::Unit(axis), (*place)[axis]});
  if (direction) {
    const Frame frame = frame_from_normal(Vec3::Zero(), direction->normalized());
    problem.ends.push_back({EndCondition::Of::along, frame.x, 0.0});
    problem.ends.push_back({EndCondition::Of::along, frame.y, 0.0});
  }
  return problem;
}

TEST(FirstShapes, EndNearThePlaceThatIsWanted) {
  for (const Vec3& place : {Vec3(90, 230, 20), Vec3(-90, 230, 20), Vec3(150, 150, 20),
                            Vec3(-60, 60, 20), Vec3(30, 280, 20)}) {
    const StripProblem problem = to_place(&place, nullptr);
    const StripParameters best = first_shapes(problem).front();
    EXPECT_TRUE(is_shape(problem.base, best));
    const StripFold fold = folded(problem.base, best);
    const Vec3 middle = 0.5 * (fold.end(0, 12) + fold.end(1, 12));
    EXPECT_LT((middle - place).norm(), 0.05 * 200) << place.transpose();
  }
}

TEST(FirstShapes, EndInTheDirectionThatIsWanted) {
  for (const double angle : {0.3, 1.2, 2.4, -0.8, -2.0}) {
    const Vec3 direction(std::sin(angle), std::cos(angle), 0.0);
    const StripProblem problem = to_place(nullptr, &direction);
    const StripFold fold = folded(problem.base, first_shapes(problem).front());
    EXPECT_LT((fold.quad(11).x - direction).norm(), 1e-9) << angle;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 place(side * 80, 200, 20);
      const StripProblem both = to_place(&place, &direction);
      const StripFold there = folded(both.base, first_shapes(both).front());
      EXPECT_LT((there.quad(11).x - direction).norm(), 1e-9) << angle;
    }
  }
}

/// Of all shapes that turn by an angle an arc bends least, with n equal folds. Curls are as smooth.
TEST(FirstShapes, BendNoMoreThanTheyMust) {
  for (const double angle : {0.3, 1.2, 2.4, -0.8, -2.0}) {
    const Vec3 direction(std::sin(angle), std::cos(angle), 0.0);
    const StripProblem problem = to_place(nullptr, &direction);
    const int quads = problem.base.quads;
    const double least = angle * angle / quads;
    EXPECT_LT(first_shapes(problem).front().head(quads).squaredNorm(), 2.0 * least) << angle;
  }
}

TEST(FirstShapes, TurnIntoThePanelAtTheirEnd) {
  // An arch over to a panel that points down again, 100 mm beside: half a turn in all.
  const Vec3 place(-100.0, 100.0, 20.0);
  StripProblem problem = to_place(&place, nullptr);
  problem.far_facet = frame_from_axes(place, -Vec3::UnitX(), -Vec3::UnitY());
  const StripParameters best = first_shapes(problem).front();
  const StripFold fold = folded(problem.base, best);
  const Vec3 middle = 0.5 * (fold.end(0, 12) + fold.end(1, 12));
  EXPECT_LT((middle - place).norm(), 0.05 * 200);
  const double into = fold_into(fold.quad(11), *problem.far_facet).radians();
  EXPECT_LT(std::abs(into), 0.6) << "no sharp fold at the panel";
  EXPECT_NEAR(std::abs(best.head(12).sum() + into), std::numbers::pi, 1e-9);
}

}  // namespace
}  // namespace planish::test
