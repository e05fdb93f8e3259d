#include "plane_side.hpp"

#include "brake/right_angles.hpp"
#include "brake/stroke_room.hpp"
#include "one_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace planish::test {
namespace {

using namespace brake_detail;

Turn bent(double radius) { return {Angle::degrees(90), radius, BendDirection::up}; }

// The ends of what a die bears, derived in the plane as in check_test.cpp.

/// The flange, from the bend line to the border or to the next formed bend, is at least
/// V/2 + shoulder radius.
TEST(PlaneSide, ShortestFlangeOnADie) {
  const double radius = 1.0, t = 1.0, k = 0.44;
  const double half_zone = 0.25 * std::numbers::pi * (radius + k * t);
  PlainDie lower;
  lower.opening = 16.0;
  lower.shoulder_radius = 2.5;
  const double shortest = 0.5 * lower.opening + lower.shoulder_radius - half_zone;
  for (const double step : {-kStep, kStep}) {
    Room room(strip({Straight{60}, bent(radius), Straight{shortest + step}}, 50, t),
              plain_tools({}, lower));
    EXPECT_EQ(room.can_press(1, {}), step > 0.0) << step;
    // To the next bend, once that is formed. The punch is so thin that the flange there passes.
    PlainPunch thin;
    thin.half_width = 1.5;
    Room jog(
        strip({Straight{60}, bent(radius), Straight{shortest + step}, bent(radius), Straight{6}},
              50, t),
        plain_tools(thin, lower));
    EXPECT_TRUE(jog.can_press(1, {})) << step;
    EXPECT_EQ(jog.can_press(1, {2}), step > 0.0) << step;
  }
}

/// As the sides rise the shoulders touch them farther out. A shoulder of radius q in the corner of
/// a V of angle A has its middle V/2 + q / tan(45° + A/4) from the middle of the V; it touches a
/// side at 45° s·(…)/… beyond the tangent point: with W that distance, (W − s (r + T + q)) / s.
TEST(PlaneSide, ShoulderStaysOnTheFlange) {
  const double radius = 1.0, t = 1.0, k = 0.44;
  PlainDie lower;
  lower.opening = 40.0;
  lower.shoulder_radius = 2.0;
  lower.half_width = 40.0;
  const double reach = 20.0 + 2.0 / std::tan(std::numbers::pi / 4 + 0.25 * lower.angle.radians());
  const double touched = (reach - kSin45 * (radius + t + 2.0)) / kSin45;
  const double half_zone = 0.25 * std::numbers::pi * (radius + k * t);
  ASSERT_GT(touched + half_zone, 22.0);  // more than V/2 + the shoulder's radius
  for (const double step : {-kStep, kStep}) {
    Room room(strip({Straight{90}, bent(radius), Straight{touched + step}}, 50, t),
              plain_tools({}, lower));
    EXPECT_EQ(room.can_press(1, {}), step > 0.0) << step;
  }
}

/// The shoulders never touch the bend itself: BA/2 ≤ W at the start, for a radius that the V is
/// too narrow for.
TEST(PlaneSide, ShouldersTouchPlaneSidesOnly) {
  const double t = 1.0, k = 0.44;
  PlainDie lower;
  lower.opening = 8.0;
  lower.shoulder_radius = 1.0;
  const double reach = 4.0 + 1.0 / std::tan(std::numbers::pi / 4 + 0.25 * lower.angle.radians());
  // At the end: s (r + T + q) ≤ W is the stricter of the two for this die.
  const double widest = std::min(reach / kSin45 - t - 1.0, 4.0 * reach / std::numbers::pi - k * t);
  for (const double step : {-kStep, kStep}) {
    Room room(strip({Straight{60}, bent(widest + step), Straight{60}}, 50, t),
              plain_tools({}, lower));
    EXPECT_EQ(room.can_press(1, {}), step < 0.0) << step;
  }
}

/// A side counts as it is along half of the line: a border cut back over less than half of its
/// width does not shorten it.
TEST(PlaneSide, CountsAsItIsAlongHalfOfTheLine) {
  for (const double cut : {30.0, 50.0}) {
    SheetBuilder builder(1.0);
    const FaceId base = builder.flange(Frame{}, {rectangle(80, 60)});
    const Rim rim = builder.bend(builder.rim(base, 0), bent(1.0));
    builder.flange_behind(rim, {polygon({{0, 0}, {80, 0}, {80, 40}, {cut, 40}, {cut, 3}, {0, 3}})});
    Room room(builder.finish(), plain_tools());
    const LineSet flat = room.lines({});
    const Setting at{&flat, room.lines({1}), 0};
    const double half_zone = 0.5 * room.work().lines[0].bend.allowance;
    const double short_side = std::min(reach(room.cache(), at, false),
                                       reach(room.cache(), at, true));
    EXPECT_NEAR(short_side, (cut < 40.0 ? 40.0 : 3.0) + half_zone, 1e-6);
    EXPECT_NEAR(std::max(reach(room.cache(), at, false), reach(room.cache(), at, true)),
                60.0 + half_zone, 1e-6);
    EXPECT_EQ(room.can_press(1, {}), cut < 40.0);
  }
}

/// Of lines pressed together each is borne by its own sides, whatever is formed on the way from one
/// to the other, and whatever was asked before.
TEST(PlaneSide, BearsEachOfTheLinesPressedTogether) {
  for (const bool formed_first : {false, true}) {
    Room room(tabs_with_lips(20.0, 20.0), plain_tools());
    const LineSet stages[] = {room.lines({}), room.lines({1, 3})};
    for (const int i : {formed_first ? 1 : 0, formed_first ? 0 : 1}) {
      const Setting at{&stages[i], room.lines({2, 4}), room.line_of(2)};
      ASSERT_EQ(together(room.cache(), room.line_of(2), stages[i]).size(), 2u);
      EXPECT_FALSE(too_short(room.cache(), at)) << i;
    }
  }
}

/// A lip too short for the die is not borne by the longer one beside it.
TEST(PlaneSide, OfAShortLineIsNotThatOfALongOne) {
  for (const auto& [first, second, shorter] :
       {std::tuple{3.0, 40.0, 2}, std::tuple{40.0, 3.0, 4}}) {
    Room room(tabs_with_lips(first, second), plain_tools());
    const LineSet flat = room.lines({});
    const auto found = too_short(room.cache(), {&flat, room.lines({2, 4}), room.line_of(2)});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->lack.is, 3.0 + 0.5 * room.work().lines[room.line_of(shorter)].bend.allowance,
                1e-6);
    const auto& part = room.cache().tree(room.line_of(2)).parts()[found->part];
    EXPECT_FALSE(part.is_zone);
    const auto& bodies = room.work().lines[room.line_of(shorter)].bodies;
    EXPECT_TRUE(std::ranges::count(bodies, part.index));
  }
}

/// Where the shoulder touches wanders between its places of all turns.
TEST(PlaneSide, KnowsAllContactsOfTheShoulder) {
  PlainDie lower;
  lower.opening = 30.0;
  lower.half_width = 30.0;
  Room room(l_bracket(), plain_tools({}, lower));
  const PressMotion motion(room.work().lines[0].bend, shoulder_of(room.tools().dies[0]));
  Interval dense{1e9, -1e9};
  for (int i = 0; i <= 2000; ++i) {
    const double at = motion.contact(most_turn(room.inputs(), 0) * i / 2000);
    dense = {std::min(dense.lo, at), std::max(dense.hi, at)};
  }
  const Interval range = contact_range(room.cache(), 0, 0);
  EXPECT_NEAR(range.lo, dense.lo, 2e-3);
  EXPECT_NEAR(range.hi, dense.hi, 2e-3);
}

}  // namespace
}  // namespace planish::test
