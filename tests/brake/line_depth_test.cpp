#include "line_depth.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Along a strip of n bends the i-th has i on one side and n − 1 − i on the other.
TEST(LineDepth, GrowsTowardsTheMiddleOfAStrip) {
  for (const int steps : {1, 2, 3}) {
    Room room(staircase(steps), plain_tools());
    const std::vector<int> depths = line_depths(room.work());
    const int bends = 2 * steps;
    for (int bend = 0; bend < bends; ++bend)
      EXPECT_EQ(depths[room.line_of(bend + 1)], std::min(bend, bends - 1 - bend)) << steps;
  }
}

TEST(LineDepth, OfTheWallsOfABoxIsNone) {
  Room room(box(), plain_tools());
  EXPECT_EQ(line_depths(room.work()), std::vector<int>(4, 0));
}

}  // namespace
}  // namespace planish::test
