#include "closing.hpp"

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
TEST(ClosingHems, IsBentAndThenClosed) {
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

/// Two sides of thickness T at the distance 2 R of each other: the punch stops at 2 T + 2 R. Below
/// a tenth of T a hem is shut.
TEST(ClosingHems, SaysWhereThePunchStopsForAnOpenHem) {
  for (const double radius : {0.04, 0.06, 0.5, 2.0}) {
    const Sheet sheet = strip(
        {Straight{60}, Turn{Angle::degrees(180), radius, BendDirection::up}, Straight{12}}, 50,
        1.0);
    const auto plan = plan_of_hem(sheet, hemming_tools());
    ASSERT_TRUE(plan) << plan.error().message;
    ASSERT_EQ(plan->strokes.size(), 2u);
    EXPECT_FALSE(plan->strokes[0].open_hem);
    const auto& open = plan->strokes[1].open_hem;
    const auto said = std::ranges::count(plan->remarks, "open_hem", &Remark::code);
    ASSERT_EQ(open.has_value(), radius > 0.05);
    EXPECT_EQ(said, open ? 1 : 0);
    if (!open) continue;
    EXPECT_NEAR(open->gap, 2.0 * radius, 1e-9);
    EXPECT_NEAR(open->height, 2.0 + 2.0 * radius, 1e-9);
  }
}

TEST(ClosingHems, NeedsFlatTools) {
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
TEST(ClosingHems, IsClosedBesideAWallIfThePunchHasRoom) {
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

}  // namespace
}  // namespace planish::test
