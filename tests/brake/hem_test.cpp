#include "brake/hemming_tools.hpp"

#include <planish/brake/codes.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

Result<Plan> plan_of_hem(const Sheet& sheet, const BrakeTools& tools,
                         const PlanOptions& options = {}) {
  const auto flat = flat_sheet(sheet);
  EXPECT_TRUE(flat);
  return plan_bending(sheet, flat->layout, tools, options);
}

/// A hem is bent as far as the sharpest tools go, 180° − 30° − 2°, and then closed.
TEST(Hem, IsBentAndThenClosed) {
  PlanOptions options;
  options.springback = Angle::degrees(2);
  const auto plan = plan_of_hem(hem(), hemming_tools(), options);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->status, PlanStatus::optimal);
  ASSERT_EQ(plan->strokes.size(), 2u);
  EXPECT_FALSE(plan->strokes[0].flattening);
  EXPECT_NEAR(plan->strokes[0].angle.degrees(), 148.0, 1e-9);
  EXPECT_EQ(plan->strokes[0].punch, "P");
  EXPECT_TRUE(plan->strokes[1].flattening);
  EXPECT_NEAR(plan->strokes[1].angle.degrees(), 32.0, 1e-9);
  EXPECT_EQ(plan->strokes[1].punch, "F");
  EXPECT_EQ(plan->strokes[1].die, "F");
  EXPECT_EQ(plan->strokes[0].bends, plan->strokes[1].bends);
}

TEST(Hem, NeedsFlatTools) {
  BrakeTools tools = hemming_tools();
  tools.dies.pop_back();
  const auto plan = plan_of_hem(hem(), tools);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, code::no_tool);
  EXPECT_NE(plan.error().message.find("flat"), std::string::npos);
}

/// A wall beside a hem that is being closed. The punch stands over the middle of the return, which
/// lies from the tangent line of the hem to its length l = 15 from there; the wall's face is L + r
/// from the tangent line, and may be ε deep in the punch: L ≥ l/2 + 15 − ε − r. Closing first is
/// always possible.
TEST(Hem, IsClosedBesideAWallIfThePunchHasRoom) {
  const double radius = 1.0, nearest = 7.5 + kFlatPunch - 0.05 - radius;
  for (const double step : {-0.1, 0.1}) {
    const Sheet sheet = strip(
        {Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up}, Straight{nearest + step},
         Turn{Angle::degrees(90), radius, BendDirection::up}, Straight{40}},
        50, 1.0);
    const BrakeTools tools = hemming_tools();
    const auto flat = flat_sheet(sheet);
    auto work = brake_detail::workpiece_of(sheet, flat->layout,
                                           {1.0, brake_detail::angle_before_closing(tools, {})});
    ASSERT_TRUE(work);
    ASSERT_EQ(work->lines.size(), 3u);  // the hem, the wall, closing the hem
    const auto inputs = brake_detail::stroke_inputs(std::move(*work), tools, {});
    brake_detail::StageCache cache(inputs);
    for (const bool with_wall : {false, true}) {
      LineSet formed = brake_detail::no_lines(3);
      brake_detail::insert(formed, 0);
      if (with_wall) brake_detail::insert(formed, 1);
      bool closes = false;
      for (const StrokeChoice& choice : brake_detail::choices(cache, formed))
        if (brake_detail::holds(choice.lines, 2))
          closes |= brake_detail::check(cache, formed, choice).feasible;
      EXPECT_EQ(closes, !with_wall || step > 0.0) << step;
    }
  }
}

/// Where a closed hem lies: as it is drawn. (Of an open one the tools decide.)
TEST(Hem, LiesClosedAsItIsDrawn) {
  const Sheet sheet = strip(
      {Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up}, Straight{60},
       Turn{Angle::degrees(90), 1.0, BendDirection::up}, Straight{40}},
      50, 1.0);
  const auto flat = flat_sheet(sheet);
  const auto work = brake_detail::workpiece_of(sheet, flat->layout, {1.0, Angle::degrees(150)});
  ASSERT_TRUE(work);
  const brake_detail::PartTree tree(*work, 1);
  LineSet formed = brake_detail::no_lines(3);
  brake_detail::insert(formed, 0);
  brake_detail::insert(formed, 2);
  // From the wall's line: the return lies 2 r + T above the base's middle, its end 60 − 15 from the
  // wall's tangent line.
  const double half_zone = 0.5 * work->lines[1].bend.allowance;
  const int body = work->lines[0].bodies[0] == work->lines[1].bodies[0] ||
                           work->lines[0].bodies[0] == work->lines[1].bodies[1]
                       ? work->lines[0].bodies[1]
                       : work->lines[0].bodies[0];
  const Eigen::Isometry3d at = tree.place(tree.part_of_body(body), formed);
  double nearest = 1e9;
  for (const brake_detail::Convex& piece : work->bodies[body].pieces)
    for (const Vec2& p : piece) {
      const Vec3 placed = at * Vec3(p.x(), p.y(), 0.0);
      EXPECT_NEAR(placed.z(), -0.5 + 2.0, 1e-9);
      nearest = std::min(nearest, std::abs(placed.y()));
    }
  EXPECT_NEAR(nearest, half_zone + 45.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
