#include "preferred_tools.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace planish::test {
namespace {

using namespace brake_detail;

const Turn kBent{Angle::degrees(90), 2.0, BendDirection::up};

Result<Plan> plan_with(const Sheet& sheet, const BrakeTools& tools) {
  return plan_bending(sheet, flat_sheet(sheet)->layout, tools);
}

/// Of tools that cost the same: the least acute, then the largest tip that is not larger than the
/// inside radius, but none that the part does not allow.
TEST(PreferredTools, MarkTheSheetLeast) {
  BrakeTools tools = plain_tools();
  const auto add = [&](const char* id, double angle, double tip) {
    Punch punch = tools.punches.front();
    punch.id = id;
    punch.angle = Angle::degrees(angle);
    punch.tip_radius = tip;
    tools.punches.push_back(punch);
  };
  const double usual = tools.punches.front().angle.degrees();
  add("acute", usual - 30.0, 1.5);
  add("round", usual, 1.5);
  add("too round", usual, 2.5);
  const Sheet sheet = strip({Straight{40}, kBent, Straight{60}, kBent, Straight{30}}, 80, 1.5);
  const auto plan = plan_with(sheet, tools), plain = plan_with(sheet, plain_tools());
  ASSERT_TRUE(plan && plain);
  EXPECT_EQ(plan->cost, plain->cost);
  ASSERT_EQ(plan->strokes.size(), 2u);
  for (const Stroke& stroke : plan->strokes)
    EXPECT_EQ(stroke.punch, "round");
}

/// A die that is no more acute than it must be, whichever stands first.
TEST(PreferredTools, OfDiesOfOneOpeningAreThoseOfTheLargestAngle) {
  const Sheet sheet = strip({Straight{40}, kBent, Straight{60}, kBent, Straight{30}}, 80, 1.5);
  BrakeTools tools = plain_tools();
  for (const double angle : {70.0, 85.0, 60.0}) {
    PlainDie other;
    other.angle = Angle::degrees(angle);
    tools.dies.push_back(die(other));
    tools.dies.back().id = std::to_string(std::lround(angle));
  }
  for (int turn = 0; turn < std::ssize(tools.dies); ++turn) {
    const auto plan = plan_with(sheet, tools);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->strokes.size(), 2u);
    for (const Stroke& stroke : plan->strokes)
      EXPECT_EQ(stroke.die, "85") << "after " << turn << " places";
    std::ranges::rotate(tools.dies, tools.dies.begin() + 1);
  }
}

}  // namespace
}  // namespace planish::test
