#include "ring_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace inspect_detail;

std::vector<Vec2> square(double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

/// A plate with a window in its middle.
RingIndex plate() { return RingIndex({square(10), square(4)}); }

TEST(RingIndex, CountsRingsAroundAPoint) {
  const RingIndex rings = plate();
  EXPECT_TRUE(rings.odd({7, 0}));
  EXPECT_FALSE(rings.odd({0, 0}));
  EXPECT_FALSE(rings.odd({11, 0}));
  // At the height of corners, which count once.
  EXPECT_TRUE(rings.odd({-7, 4}));
  EXPECT_FALSE(rings.odd({-11, 4}));
}

TEST(RingIndex, WindsCounterClockwisePositive) {
  EXPECT_EQ(plate().winding({0, 0}), 2);
  std::vector<Vec2> back = square(4);
  std::ranges::reverse(back);
  const RingIndex rings({square(10), back});
  EXPECT_EQ(rings.winding({0, 0}), 0);
  EXPECT_EQ(rings.winding({7, 0}), 1);
  EXPECT_EQ(RingIndex({back}).winding({0, 0}), -1);
}

TEST(RingIndex, IsClearUpToTheNearestEdge) {
  EXPECT_TRUE(plate().clear({6.5, 1}, 2.5));
  EXPECT_FALSE(plate().clear({6.5, 1}, 2.51));
  EXPECT_TRUE(plate().clear({7, 7}, 3.0));  // √18 from the corner of the window
}

TEST(RingIndex, HitsTheFirstEdgeThatCounts) {
  const RingIndex rings = plate();
  const auto any = [](size_t) { return true; };
  const auto outer = [](size_t ring) { return ring == 0; };
  EXPECT_DOUBLE_EQ(rings.first_hit({-7, 1}, Vec2::UnitX(), 100.0, any), 3.0);
  EXPECT_DOUBLE_EQ(rings.first_hit({-7, 1}, Vec2::UnitX(), 100.0, outer), 17.0);
  EXPECT_TRUE(std::isinf(rings.first_hit({-7, 1}, Vec2::UnitX(), 2.9, any)));
  EXPECT_DOUBLE_EQ(rings.first_hit({-7, 1}, -Vec2::UnitX(), 100.0, any), 3.0);
}

}  // namespace
}  // namespace planish::test
