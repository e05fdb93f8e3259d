#include "geometry/rings.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

TEST(SelfCrossings, OfASimpleRingAreNone) {
  EXPECT_TRUE(self_crossings(box(0, 0, 1, 1)).empty());
  EXPECT_TRUE(self_crossings({{0, 0}, {1, 0}, {0, 1}}).empty());
  EXPECT_TRUE(self_crossings({}).empty());
}

TEST(SelfCrossings, OfABowTieIsItsMiddle) {
  const std::vector<Vec2> found = self_crossings({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR((found[0] - Vec2(1, 1)).norm(), 0.0, 1e-15);
}

TEST(SelfCrossings, OfAPentagramAreFive) {
  std::vector<Vec2> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5));
  const std::vector<Vec2> found = self_crossings(star);
  ASSERT_EQ(found.size(), 5u);
  // The inner pentagon lies at cos 72° / cos 36° of the radius.
  for (const Vec2& p : found)
    EXPECT_NEAR(p.norm(), std::cos(0.4 * pi) / std::cos(0.2 * pi), 1e-14);
}

TEST(SelfCrossings, LeaveTouchingAlone) {
  // A corner on an edge, an edge run through twice, a corner used twice.
  EXPECT_TRUE(self_crossings({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}).empty());
  EXPECT_TRUE(self_crossings({{0, 0}, {2, 0}, {2, 1}, {2, 0}, {4, 0}, {4, -1}, {0, -1}}).empty());
  EXPECT_TRUE(self_crossings({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}).empty());
}

TEST(SelfCrossings, LeaveTouchingAtASlantAlone) {
  // Points of one slanted line are on it only to rounding.
  const Vec2 u(std::cos(0.3), std::sin(0.3));
  const Vec2 v(-u.y(), u.x());
  EXPECT_TRUE(self_crossings({0 * u, 7 * u, 7 * u + 2 * v, 3.3 * u, 2 * v}).empty());
}

TEST(SelfCrossings, TakeALongRing) {
  // A strip wound up eight times with 20,000 corners crosses nowhere; pulled straight through, it
  // crosses each of the sixteen walls once but for the two it starts and ends on.
  std::vector<Vec2> strip;
  const int n = 10000;
  for (int i = 0; i <= n; ++i) {
    const double t = 16 * pi * i / n;
    strip.emplace_back((10 + t) * std::cos(t), (10 + t) * std::sin(t));
  }
  for (int i = n; i >= 0; --i) {
    const double t = 16 * pi * i / n;
    strip.emplace_back((12 + t) * std::cos(t), (12 + t) * std::sin(t));
  }
  EXPECT_TRUE(self_crossings(strip).empty());
}

}  // namespace
}  // namespace planish::test
