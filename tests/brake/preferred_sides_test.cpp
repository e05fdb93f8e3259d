#include "preferred_sides.hpp"

#include "brake/gauged_parts.hpp"

#include <planish/brake/plan.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

/// A web of 200 whose far edge slopes but for 28 mm, and a flange of 25; turned in its plane.
Sheet sloped_web(double turned) {
  SheetBuilder builder(1.5);
  Frame frame;
  frame.x = Vec3(std::cos(turned), std::sin(turned), 0.0);
  frame.y = Vec3(-std::sin(turned), std::cos(turned), 0.0);
  const FaceId web = builder.flange(frame,
                                    {polygon({{0, 0}, {200, 0}, {200, 80}, {172, 80}, {0, 50}})});
  builder.flange_behind(
      builder.bend(builder.rim(web, 0), {Angle::degrees(90), 2, BendDirection::up}),
      {rectangle(200, 25)});
  return builder.finish();
}

/// The straight edge goes to the gauge, however the part lies in space.
TEST(PreferredSides, HoldTheSheetSquare) {
  for (const double turned : {0.0, 3.0}) {
    const Sheet sheet = sloped_web(turned);
    const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, gauged_tools());
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->strokes.size(), 1u);
    EXPECT_EQ(plan->strokes[0].to_gauge, FlangeId(1)) << turned;
    ASSERT_TRUE(plan->strokes[0].gauge);
    EXPECT_TRUE(plan->strokes[0].gauge->is_square());
    EXPECT_EQ(std::ranges::count(plan->remarks, "short_gauge", &Remark::code), 0);
    Room room(sheet, gauged_tools());
    const LineSet flat = room.lines({});
    for (const StrokeChoice& choice : choices(room.cache(), flat)) {
      const StrokeChoice taken = with_square_gauges(room.cache(), {choice}).at(0);
      EXPECT_EQ(describe(room.cache(), flat, taken).to_gauge, FlangeId(1));
    }
  }
}

/// A hem on a panel: the return is at the gauge, not the panel, also of the mirrored part.
TEST(PreferredSides, LeaveTheLargerPartToTheOperator) {
  for (const bool mirrored : {false, true}) {
    const Turn turn{Angle::degrees(90), 2, BendDirection::up};
    const Sheet sheet = mirrored ? strip({Straight{20}, turn, Straight{150}}, 80, 1.5)
                                 : strip({Straight{150}, turn, Straight{20}}, 80, 1.5);
    Room room(sheet, gauged_tools());
    const LineSet flat = room.lines({});
    for (const StrokeChoice& choice : room.ways(1, {})) {
      const StrokeChoice taken = with_little_behind(room.cache(), {choice}).at(0);
      EXPECT_NEAR(describe(room.cache(), flat, taken).gauge->distance, 20.0 + kHalfZone, 1e-9);
    }
    const auto plan = plan_bending(sheet, room.layout(), gauged_tools());
    ASSERT_TRUE(plan);
    EXPECT_NEAR(plan->strokes.at(0).gauge->distance, 20.0 + kHalfZone, 1e-9);
  }
}

/// Where the shorter flange is nearer than the gauge goes, the panel is at the gauge.
TEST(PreferredSides, DoNotLoseTheGaugeForIt) {
  BrakeTools tools = gauged_tools();
  tools.machine.gauge->from = 30.0;
  const Turn turn{Angle::degrees(90), 2, BendDirection::up};
  const Sheet sheet = strip({Straight{150}, turn, Straight{20}}, 80, 1.5);
  const auto plan = plan_bending(sheet, flat_sheet(sheet)->layout, tools);
  ASSERT_TRUE(plan);
  ASSERT_TRUE(plan->strokes.at(0).gauge);
  EXPECT_NEAR(plan->strokes[0].gauge->distance, 150.0 + kHalfZone, 1e-9);
}

/// Both ways of the strokes are offered; the one that is held askew is turned about, and stays as
/// it is where the other side is out of the gauge's reach: it is told.
TEST(PreferredSides, StayWhereTheOtherSideIsNotGauged) {
  BrakeTools tools = gauged_tools();
  tools.machine.gauge->from = 40.0;
  const Sheet sheet = sloped_web(0.0);
  Room room(sheet, tools);
  for (const StrokeChoice& choice : choices(room.cache(), room.lines({}))) {
    if (!choice.gauged) continue;
    EXPECT_EQ(with_square_gauges(room.cache(), {choice}).at(0).direction, choice.direction);
  }
  const auto plan = plan_bending(sheet, room.layout(), tools);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->strokes.at(0).to_gauge, FlangeId(0));
  EXPECT_EQ(std::ranges::count(plan->remarks, "short_gauge", &Remark::code), 1);
}

}  // namespace
}  // namespace planish::test
