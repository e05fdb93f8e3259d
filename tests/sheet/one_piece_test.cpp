#include "support/sheets.hpp"

#include <planish/sheet/one_piece.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

constexpr double kTouch = 0.01;

/// A plate of 100 × 60 with a round hole of radius 5 at (30, 30) and one at (70, 30).
bool stays_whole(const std::vector<Curve2>& slits) {
  FlatPattern pattern;
  pattern.outer.loop = rectangle(100, 60);
  pattern.openings.push_back({circular_opening({30, 30}, 5), {}});
  pattern.openings.push_back({circular_opening({70, 30}, 5), {}});
  pattern.slits = slits;
  return is_one_piece(pattern, kTouch);
}

Segment line(double ax, double ay, double bx, double by) { return {{ax, ay}, {bx, by}}; }

TEST(OnePiece, IsParted) {
  EXPECT_FALSE(stays_whole({line(50, 0, 50, 60)})) << "from side to side";
  EXPECT_FALSE(stays_whole({line(50, 0, 50, 30), line(50, 30, 50, 60)})) << "in two stretches";
  EXPECT_FALSE(stays_whole({line(0, 30, 25, 30), line(35, 30, 65, 30), line(75, 30, 100, 30)}))
      << "by way of both holes";
  EXPECT_FALSE(stays_whole({line(30, 25, 50, 10), line(50, 10, 70, 25), line(35, 30, 65, 30)}))
      << "a ring around a part";
  EXPECT_FALSE(stays_whole({line(45, 10, 55, 10), line(55, 10, 50, 20), line(50, 20, 45, 10)}))
      << "a triangle cut out";
  EXPECT_FALSE(stays_whole({line(50, 0, 50, 40), line(0, 40, 50.005, 40)})) << "a corner cut off";
}

TEST(OnePiece, IsWhole) {
  EXPECT_TRUE(stays_whole({}));
  EXPECT_TRUE(stays_whole({line(50, 0, 50, 59.9)})) << "ends short of the side";
  EXPECT_TRUE(stays_whole({line(50, 10, 50, 50)})) << "touches nothing";
  EXPECT_TRUE(stays_whole({line(0, 30, 25, 30), line(35, 30, 65, 30)})) << "not to the other side";
  EXPECT_TRUE(stays_whole({line(35, 30, 65, 30)})) << "between two holes";
  EXPECT_TRUE(stays_whole({line(50, 0, 50, 20), line(50, 20, 40, 10), line(50, 20, 60, 10)}))
      << "a fork";
  EXPECT_TRUE(stays_whole({line(50, 0, 50, 40), line(10, 40, 49.9, 40)})) << "does not reach it";
}

}  // namespace
}  // namespace planish::test
