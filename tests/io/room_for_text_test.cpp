#include "room_for_text.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::io_detail {
namespace {

Loop rectangle_of(const Vec2& a, const Vec2& b) {
  return {Segment{a, {b.x(), a.y()}}, Segment{{b.x(), a.y()}, b}, Segment{b, {a.x(), b.y()}},
          Segment{{a.x(), b.y()}, a}};
}

FlatPattern pattern_of(const Loop& outer, const std::vector<Loop>& openings = {}) {
  FlatPattern pattern;
  pattern.outer.loop = outer;
  for (const Loop& loop : openings)
    pattern.openings.push_back({loop, {}});
  return pattern;
}

TEST(RoomForText, IsInTheMiddleOfAStrip) {
  const RoomForText room = room_for_text(pattern_of(rectangle_of({10, 20}, {110, 60})));
  EXPECT_NEAR(room.radius, 20, 1e-9);
  EXPECT_NEAR(room.middle.y(), 40, 1e-9);
  EXPECT_GE(room.middle.x(), 30 - 1e-9);
  EXPECT_LE(room.middle.x(), 90 + 1e-9);
}

TEST(RoomForText, KeepsClearOfOpeningsAndOutOfThem) {
  const double pi = std::numbers::pi;
  const auto pattern = pattern_of(rectangle_of({0, 0}, {100, 40}),
                                  {{Arc{{30, 20}, 15, 0.0, -2 * pi}}});
  const RoomForText room = room_for_text(pattern);
  // Between the hole's edge at x = 45 and the right end a circle of radius 20 has room.
  EXPECT_GE(room.radius, 17);
  EXPECT_LE(room.radius, 20 + 1e-9);
  EXPECT_GE((room.middle - Vec2(30, 20)).norm(), 15 + room.radius - 0.5);
  EXPECT_GT(room.middle.x(), 45);
}

TEST(RoomForText, LooksWithinTheContourAndNotWithinItsBox) {
  // An L of legs 20 and 60 wide: most of its box is outside.
  const Loop corner{Segment{{0, 0}, {100, 0}},    Segment{{100, 0}, {100, 60}},
                    Segment{{100, 60}, {40, 60}}, Segment{{40, 60}, {40, 20}},
                    Segment{{40, 20}, {0, 20}},   Segment{{0, 20}, {0, 0}}};
  const RoomForText room = room_for_text(pattern_of(corner));
  EXPECT_GE(room.radius, 27);
  EXPECT_LE(room.radius, 30 + 1e-9);
  EXPECT_NEAR(room.middle.x(), 70, 5);
}

TEST(RoomForText, IsNoneInAThinRing) {
  const double pi = std::numbers::pi;
  const auto pattern = pattern_of({Arc{{50, 50}, 40, 0.0, 2 * pi}},
                                  {{Arc{{50, 50}, 39.9999, 0.0, -2 * pi}}});
  const RoomForText room = room_for_text(pattern);
  EXPECT_LE(room.radius, 0.5);
  if (room.radius == 0.0) {
    EXPECT_NEAR((room.middle - Vec2(50, 50)).norm(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace planish::io_detail
