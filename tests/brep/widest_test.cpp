#include "widest.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

namespace planish::brep::test {
namespace {

/// A 2 mm plate whose upper rim is taken off, this deep and wide.
SolidModel chamfered(double depth, double width) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inset = rectangle_at({width, width}, {100 - width, 60 - width});
  return plate(2, {{{outer, outer, inset}, {0, 2 - depth, 2}}});
}

/// Where the blank must reach below the first border of the top's loop.
struct Reached {
  SpaceCurve from, to;
  bool same_run = false;
  bool is_own = false;
};
Reached reached_on_top(const SolidModel& model, int loop = 0) {
  const Recognised seen = recognised(model, 2, 1);
  const CoEdge border = seen.model.faces[1].loops.at(loop).front();
  const CoEdge widest = widest_edge(seen.model, seen.rim, 2, 1, border);
  const auto run = [&](const CoEdge& use) -> Vec3 {
    const SpaceCurve& curve = seen.model.edges[use.edge].curve;
    const Vec3 tangent = curve.tangent((curve.t0 + curve.t1) / 2);
    return use.forward ? tangent : Vec3(-tangent);
  };
  return {seen.model.edges[border.edge].curve, seen.model.edges[widest.edge].curve,
          run(border).dot(run(widest)) > 0, border.edge == widest.edge};
}

TEST(WidestEdge, OfAStraightCutIsTheBorderItself) {
  EXPECT_TRUE(reached_on_top(plate(2, {100, 60})).is_own);
}

TEST(WidestEdge, BelowAChamferIsItsLowerEdge) {
  const Reached reached = reached_on_top(chamfered(0.5, 0.5));
  EXPECT_NEAR(reached.to.start.z(), 1.5, 1e-12);
  EXPECT_NEAR(reached.to.length(), 100.0, 1e-9);
  EXPECT_TRUE(reached.same_run);
}

TEST(WidestEdge, BelowACountersinkIsItsBore) {
  const Reached reached = reached_on_top(
      plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}}}), 1);
  EXPECT_NEAR(reached.from.radius, 4.0, 1e-12);
  EXPECT_NEAR(reached.to.radius, 2.5, 1e-12);
  EXPECT_TRUE(reached.same_run);
}

TEST(WidestEdge, OfASlantedCutIsTheBorderItself) {
  const auto low = rectangle_at({0, 0}, {100, 60});
  const auto high = rectangle_at({0.5, 0.5}, {99.5, 59.5});
  EXPECT_TRUE(reached_on_top(plate(2, {{{low, high}, {0, 2}}})).is_own) << "from skin to skin";
}

TEST(WidestEdge, LeavesTheLastOfStripsThatTakeTheWholeThickness) {
  // Each strip is shallower than the plate; below the second hardly 0.5 µm of 2 mm is upright.
  const auto inset = [](double by) { return rectangle_at({by, by}, {100 - by, 60 - by}); };
  for (const double left : {0.0005, 0.5}) {
    const Reached reached = reached_on_top(
        plate(2, {{{inset(0), inset(0), inset(0.4), inset(1)}, {0, left, 1, 2}}}));
    EXPECT_NEAR(reached.to.start.z(), left < 0.1 ? 1.0 : left, 1e-12);
  }
}

TEST(WidestEdge, LeavesDraftAlone) {
  EXPECT_TRUE(reached_on_top(chamfered(1.0, 0.03)).is_own) << "1.7° are no chamfer";
  EXPECT_FALSE(reached_on_top(chamfered(1.0, 0.08)).is_own) << "4.6° are one";
}

TEST(WidestEdge, LeavesFlatStepsAlone) {
  EXPECT_TRUE(reached_on_top(chamfered(0.05, 5.0)).is_own) << "flatter than any chamfer";
}

}  // namespace
}  // namespace planish::brep::test
