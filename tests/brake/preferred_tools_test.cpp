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

Result<Plan> plan_with(const Sheet& sheet, const BrakeTools& tools,
                       const PlanOptions& options = {}) {
  return plan_bending(sheet, flat_sheet(sheet)->layout, tools, options);
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

/// A tip that leaves the drawn radius, though another that may be taken is blunter.
TEST(PreferredTools, LeaveTheDrawnRadius) {
  BrakeTools tools = plain_tools();
  const double usual = tools.punches.front().angle.degrees();
  for (const double tip : {2.5, 3.5, 4.0}) {
    Punch punch = tools.punches.front();
    punch.id = std::to_string(std::lround(10.0 * tip));
    punch.tip_radius = tip;
    punch.angle = Angle::degrees(tip > 3.0 ? usual - 5.0 : usual);
    tools.punches.push_back(punch);
  }
  const Turn turn{Angle::degrees(90), 3.5, BendDirection::up};
  const auto plan = plan_with(strip({Straight{40}, turn, Straight{60}}, 80, 1.5), tools);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->strokes.at(0).punch, "35");
  // What the tip leaves is not said of the V.
  const Turn between{Angle::degrees(90), 3.0, BendDirection::up};
  const auto other = plan_with(strip({Straight{40}, between, Straight{60}}, 80, 1.5), tools);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->strokes.at(0).radius_made, 2.5);
  ASSERT_FALSE(other->remarks.empty());
  EXPECT_EQ(other->remarks[0].told.sentence,
            "the tip of 25 leaves an inside radius of 2.5 mm, not the 3 mm of bend B1");
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

/// An acute punch whose tip is nearer to the drawn radius is not preferred: what differs by less
/// than a tenth is not told either.
TEST(PreferredTools, AreNoKnifeForATenthOfTheRadius) {
  BrakeTools tools = plain_tools({.tip_radius = 0.8});
  tools.dies = plain_dies({12.0});
  tools.punches.push_back(punch({.angle = Angle::degrees(30), .tip_radius = 2.0}));
  tools.punches.back().id = "knife";
  for (int turn = 0; turn < 2; ++turn) {
    const auto plan = plan_with(strip({Straight{40}, kBent, Straight{60}}, 80, 1.5), tools);
    ASSERT_TRUE(plan);
    EXPECT_NE(plan->strokes.at(0).punch, "knife");
    std::ranges::rotate(tools.punches, tools.punches.begin() + 1);
  }
}

/// The same where two bends need punches of their own, side by side in one set-up.
TEST(PreferredTools, AreTheBluntestDieForTwoPunches) {
  const auto bent = [](double radius) {
    return Turn{Angle::degrees(90), radius, BendDirection::up};
  };
  const Sheet sheet = strip({Straight{40}, bent(1.5), Straight{60}, bent(3.0), Straight{30}}, 80,
                            1.5);
  BrakeTools tools = plain_tools({.tip_radius = 1.0});
  tools.punches.push_back(punch({.tip_radius = 3.0}));
  tools.punches.back().id = "round";
  for (const double angle : {70.0, 85.0, 60.0}) {
    tools.dies.push_back(die({.angle = Angle::degrees(angle)}));
    tools.dies.back().id = std::to_string(std::lround(angle));
  }
  PlanOptions options;
  options.radius = RadiusWanted::drawn;
  for (int turn = 0; turn < std::ssize(tools.dies); ++turn) {
    const auto plan = plan_with(sheet, tools, options);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->strokes.size(), 2u);
    EXPECT_EQ(plan->tool_changes, 0);
    EXPECT_NE(plan->strokes[0].punch, plan->strokes[1].punch);
    for (const Stroke& stroke : plan->strokes)
      EXPECT_EQ(stroke.die, "85") << "after " << turn << " places";
    std::ranges::rotate(tools.dies, tools.dies.begin() + 1);
  }
}

}  // namespace
}  // namespace planish::test
