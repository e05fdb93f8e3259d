#include "clearance.hpp"

#include "brake/right_angles.hpp"
#include "brake/stroke_room.hpp"
#include "standing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

double told(Room& room, int bend, const std::vector<int>& formed) {
  const auto ways = room.ways(bend, formed);
  EXPECT_FALSE(ways.empty());
  return describe(room.cache(), room.lines(formed), ways.front()).clearance;
}

/// Sides that are bent touch the tools that bend them, and that does not count: an L has nothing
/// else, up to what is told apart.
TEST(Clearance, OfAnLIsFarAway) {
  Room room(l_bracket(), plain_tools());
  EXPECT_EQ(told(room, 1, {}), 1000.0);
}

/// check_test.cpp: in the end the inner corner of a U's first leg is at y = r s + s (web + r) −
/// s (r + leg), which is web·s − leg·s + r s, and the punch ends at b.
TEST(Clearance, OfAUIsThatOfTheLegFromThePunch) {
  for (const double leg : {30.0, 40.0}) {
    Room room(strip({Straight{leg}, kUp, Straight{60}, kUp, Straight{40}}, 80, 1.5), plain_tools());
    EXPECT_NEAR(told(room, 2, {1}), kSin45 * (60.0 + 2.0 - leg) - 10.0, 0.002) << leg;
  }
}

/// An upper beam above the leg's highest corner counts as long as the machine is.
TEST(Clearance, CountsBeams) {
  PlainPunch plain;
  plain.height = 100.0;
  BrakeTools tools = plain_tools(plain);
  tools.machine.upper_beam = {{-200, 100}, {200, 100}, {200, 300}, {-200, 300}};
  const double lower = plain.tip_radius / std::sin(0.5 * plain.angle.radians()) - plain.tip_radius;
  Room room(strip({Straight{40}, kUp, Straight{90}, kUp, Straight{40}}, 80, 1.5), tools);
  // The outer corner, a = web + r + T beyond the tangent point and h = r + leg above the skin.
  const double height = 2.0 * (1.0 - kSin45) + kSin45 * (90.0 + 2.0 + 1.5) + kSin45 * (2.0 + 40.0);
  EXPECT_NEAR(told(room, 2, {1}), 100.0 - lower - height, 0.002);
}

/// A leg on the base's far side that stands beside the row and not in front of it does not count;
/// a segment that reaches it does.
TEST(Clearance, CountsRowsAsFarAsTheyReach) {
  SheetBuilder builder(1.5);
  const FaceId base = builder.flange(
      Frame{}, {polygon({{0, 0}, {100, 0}, {100, 62}, {40, 62}, {40, 60}, {0, 60}})});
  const Rim leg = builder.bend(builder.rim(base, 4), kUp);  // over x from 0 to 40
  builder.flange_behind(leg, {rectangle(leg.length, 30)});
  SheetBuilder whole = builder;
  const Rim rim = builder.bend(builder.rim(base, 0), kUp);  // over x from 0 to 100
  builder.flange_behind(rim, {rectangle(rim.length, 40)});
  Room room(builder.finish(), plain_tools());
  const LineSet formed = room.lines({1});
  Setting at{&formed, room.lines({2}), room.line_of(2)};
  PressRows rows;
  const auto clear_of = [&](double from, double length) {
    rows.punch = {{from, {length}}};
    return clearance(room.cache(), at, rows);
  };
  // Along the line's frame the leg is at one end of the line, over 40 of its 100 mm.
  double lo = 1e9, hi = -1e9;
  for (const PlacedPart* part : room.cache().parts(at)) {
    if (part->flat || part->blocks.empty()) continue;
    lo = std::min(lo, part->along.lo);
    hi = std::max(hi, part->along.hi);
  }
  EXPECT_NEAR(hi - lo, 40.0, 1e-6);
  const double near = kSin45 * (60.0 + 2.0 - 30.0) - 10.0;
  EXPECT_NEAR(clear_of(lo - 10.0, 60.0), near, 0.002);
  EXPECT_NEAR(clear_of(lo + 5.0, 10.0), near, 0.002);
  EXPECT_NEAR(clear_of(hi - 1.0, 50.0), near, 0.002);
  EXPECT_NEAR(clear_of(lo - 49.0, 50.0), near, 0.002);
  EXPECT_EQ(clear_of(hi + 1.0, 50.0), 1000.0);
  EXPECT_EQ(clear_of(lo - 51.0, 50.0), 1000.0);
  rows.punch.push_back({lo, {5.0}});
  EXPECT_NEAR(clearance(room.cache(), at, rows), near, 0.002);
}

}  // namespace
}  // namespace planish::test
