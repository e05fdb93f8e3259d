#include "hulls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish::nest_detail {
namespace {

cInt twice_area_of(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
  return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}

/// A square of 100 with a notch of this depth in its right side.
Path notched(cInt depth) {
  return {{0, 0}, {100, 0}, {100, 40}, {100 - depth, 50}, {100, 60}, {100, 100}, {0, 100}};
}

TEST(ConvexHull, HoldsEveryPointAndTurnsLeftAtEachCorner) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> place(-1000, 1000);
  for (int round = 0; round < 20; ++round) {
    Path points;
    for (int i = 0; i < 40; ++i)
      points.emplace_back(place(random), place(random));
    const Path hull = convex_hull(points);
    ASSERT_GE(hull.size(), 3u);
    for (size_t i = 0; i < hull.size(); ++i) {
      const IntPoint &a = hull[i], &b = hull[(i + 1) % hull.size()];
      EXPECT_GT(twice_area_of(a, b, hull[(i + 2) % hull.size()]), 0);
      EXPECT_TRUE(std::ranges::find(points, a) != points.end());
      for (const IntPoint& p : points)
        EXPECT_GE(twice_area_of(a, b, p), 0);
    }
  }
}

TEST(ConvexHull, LeavesOutCornersOnItsSides) {
  const Path hull = convex_hull({{0, 0}, {50, 0}, {100, 0}, {100, 100}, {50, 100}, {0, 100}});
  EXPECT_EQ(hull, (Path{{0, 0}, {100, 0}, {100, 100}, {0, 100}}));
}

TEST(WithHulls, FillsHollowsThatGainLittle) {
  // The notch is a triangle of 20 × depth / 2: a tenth of the rest at a depth of about 91.
  const auto shapes = with_hulls({{notched(90), 1}, {notched(92), 1}, {notched(5), 100}});
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[0].outline.size(), 4u);
  EXPECT_EQ(shapes[1].outline, notched(92));
  EXPECT_EQ(shapes[2].outline.size(), 4u);
  EXPECT_EQ(shapes[2].count, 100);
}

TEST(WithHulls, KeepsTheHollowsThatGainMost) {
  std::vector<Shape> shapes;
  for (int i = 0; i < static_cast<int>(kMostHollow) + 3; ++i)
    shapes.push_back({notched(95), i == 5 || i == 7 ? 1 : 2 + i % 3});
  shapes[9].count = 1;
  const auto kept = with_hulls(shapes);
  for (size_t i = 0; i < kept.size(); ++i)
    EXPECT_EQ(kept[i].outline.size(), i == 5 || i == 7 || i == 9 ? 4u : 7u) << i;
}

}  // namespace
}  // namespace planish::nest_detail
