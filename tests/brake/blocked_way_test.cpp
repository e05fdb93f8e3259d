#include "blocked_way.hpp"

#include "brake/right_angles.hpp"
#include "brake/stroke_room.hpp"
#include "one_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

Sheet channel(double leg) {
  return strip({Straight{leg}, kUp, Straight{60}, kUp, Straight{40}}, 80, 1.5);
}

/// check_test.cpp: a leg `beyond` the longest comes s · beyond deeper than the ε that may be
/// penetrated. So it is for every punch, and the one that is hit least counts.
TEST(BlockedWay, TellsHowDeepTheLegIsInTheThinnestPunch) {
  BrakeTools tools = plain_tools();
  for (const double half_width : {14.0, 8.0, 11.0}) {
    tools.punches.push_back(punch({Angle::degrees(80), half_width}));
    tools.punches.back().id = std::to_string(static_cast<int>(half_width));
  }
  const double longest = 60.0 + 2.0 - (8.0 - 0.05) / kSin45;
  for (const double beyond : {1.0, 2.5}) {
    Room room(channel(longest + beyond), tools);
    const BlockedWay way = blocked_way(room.cache(), room.lines({1}), room.lines({2}));
    EXPECT_EQ(way.bend.hits, (ToolName{ToolKind::punch, "8"}));
    EXPECT_NEAR(way.bend.depth, 0.05 + beyond * kSin45, 0.01);
    EXPECT_EQ(way.bend.with, FlangeId(0));
    EXPECT_FALSE(way.bend.through);
    EXPECT_EQ(way.bend.bend, BendId(1));
    ASSERT_TRUE(way.bend.at_turn);
    EXPECT_NEAR(way.bend.at_turn->degrees(), 90.0, 0.5);
    EXPECT_EQ(way.choice.punch, 2);
    EXPECT_EQ(way.choice.lines, room.lines({2}));
    EXPECT_FALSE(check(room.cache(), room.lines({1}), way.choice).feasible);
    // The same again, and of the line alone.
    EXPECT_EQ(blocked(room.cache(), room.lines({1}), room.line_of(2)).depth, way.bend.depth);
  }
}

/// A leg whose end is in the punch, 16 wide, or beyond it: at 90° it comes s of its length nearer.
TEST(BlockedWay, TellsOfALegThatGoesThroughThePunch) {
  const BrakeTools tools = plain_tools({.half_width = 8.0});
  const double longest = 60.0 + 2.0 - 8.0 / kSin45;
  for (const double step : {-2.0, 2.0}) {
    Room room(channel(longest + 16.0 / kSin45 + 1.5 + step), tools);
    EXPECT_EQ(blocked(room.cache(), room.lines({1}), room.line_of(2)).through, step > 0.0) << step;
  }
}

/// A leg that rises into the upper beam: by how much its highest corner is above the beam's edge.
TEST(BlockedWay, TellsHowDeepALegIsInTheUpperBeam) {
  PlainPunch plain;
  plain.height = 100.0;
  BrakeTools tools = plain_tools(plain);
  tools.machine.upper_beam = {{-200, 100}, {200, 100}, {200, 300}, {-200, 300}};
  const double lower = plain.tip_radius / std::sin(0.5 * plain.angle.radians()) - plain.tip_radius;
  const double leg = 60.0;
  Room room(strip({Straight{leg}, kUp, Straight{90}, kUp, Straight{40}}, 80, 1.5), tools);
  const double height = 2.0 * (1.0 - kSin45) + kSin45 * (90.0 + 2.0 + 1.5) + kSin45 * (2.0 + leg);
  const BlockedBend told = blocked(room.cache(), room.lines({1}), room.line_of(2));
  EXPECT_EQ(told.hits, ToolName{ToolKind::upper_beam});
  EXPECT_NEAR(told.depth, height - (100.0 - lower), 0.02);
}

/// The V that would take a side is reckoned for the bend's angle: a side that is just long enough
/// for it is too short for one wider, and never is it wider than the one that is refused.
TEST(BlockedWay, TellsTheVThatWouldTakeASide) {
  constexpr double kT = 1.5;
  for (const double degrees : {30.0, 90.0, 140.0}) {
    const Turn turn{Angle::degrees(degrees), 1.0};
    const auto room_with = [&](double opening) {
      BrakeTools tools = plain_tools({.angle = Angle::degrees(30)});
      tools.dies = {die({.opening = opening, .angle = Angle::degrees(36)})};
      return tools;
    };
    const Sheet sheet = strip({Straight{60}, turn, Straight{4.5}}, 50, kT);
    const BrakeTools tools = room_with(14.0);
    Room room(sheet, tools);
    const BlockedBend told = blocked(room.cache(), room.lines({}), room.line_of(1));
    ASSERT_TRUE(told.why) << degrees;
    const auto& numbers = told.why->told.numbers;
    const auto opening = std::ranges::find(numbers, "opening", &NamedQuantity::name);
    ASSERT_NE(opening, numbers.end()) << told.why->told.sentence;
    EXPECT_LT(opening->quantity.value, 14.0);
    for (const double step : {-0.05, 0.05}) {
      const BrakeTools other = room_with(opening->quantity.value + step);
      Room near(sheet, other);
      EXPECT_EQ(near.can_press(1, {}), step < 0.0) << degrees << " " << step;
    }
  }
}

/// Where a side is too short nothing is hit, and the reason is told.
TEST(BlockedWay, TellsThatASideIsTooShort) {
  Room room(strip({Straight{60}, kUp, Straight{3}}, 50, 1.5), plain_tools());
  const BlockedBend told = blocked(room.cache(), room.lines({}), room.line_of(1));
  EXPECT_FALSE(told.hits);
  EXPECT_EQ(told.depth, 0.0);
  EXPECT_FALSE(told.at_turn);
  ASSERT_TRUE(told.why);
  EXPECT_EQ(told.why->code, "short_side");
  // The flat rest of the side, and half of the zone.
  const double half_zone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);
  const std::vector<NamedQuantity>& numbers = told.why->told.numbers;
  const auto is = std::ranges::find(numbers, "is", &NamedQuantity::name);
  const auto needed = std::ranges::find(numbers, "needed", &NamedQuantity::name);
  ASSERT_TRUE(is != numbers.end() && needed != numbers.end());
  EXPECT_NEAR(is->quantity.value, 3.0 + half_zone, 1e-6);
  EXPECT_GT(needed->quantity.value, is->quantity.value);
}

/// A time that is over leaves the first way at least, and is not remembered.
TEST(BlockedWay, LooksAtOneWayEvenIfTheTimeIsOver) {
  BrakeTools tools = plain_tools();
  tools.punches.push_back(punch({Angle::degrees(80), 8.0}));
  tools.punches.back().id = "thin";
  Room room(channel(60.0), tools);
  const BlockedWay hasty = blocked_way(room.cache(), room.lines({1}), room.lines({2}),
                                       Clock::time_point::min());
  EXPECT_EQ(hasty.bend.hits, (ToolName{ToolKind::punch, "P"}));
  EXPECT_EQ(blocked_way(room.cache(), room.lines({1}), room.lines({2})).bend.hits,
            (ToolName{ToolKind::punch, "thin"}));
}

}  // namespace
}  // namespace planish::test
