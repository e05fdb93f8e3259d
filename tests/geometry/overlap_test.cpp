#include "geometry/random_curves.hpp"
#include "geometry/rings.hpp"

#include <planish/geometry/region.hpp>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace planish::test {
namespace {

double total_area(const std::vector<std::vector<Vec2>>& rings) {
  double sum = 0.0;
  for (const auto& ring : rings)
    sum += std::abs(ring_area(ring));
  return sum;
}

TEST(Overlaps, FindsTheCommonSquare) {
  const std::vector<Overlap> found = overlaps({{box(0, 0, 10, 10), {}}, {box(8, 7, 20, 20), {}}}, 0,
                                              1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_NEAR(found[0].area, 6.0, 1e-12);
  EXPECT_NEAR(total_area(found[0].outline), 6.0, 1e-12);
}

TEST(Overlaps, IgnoresNeighboursAlongAnEdge) {
  EXPECT_TRUE(overlaps({{box(0, 0, 10, 10), {}}, {box(10, 0, 20, 10), {}}}, 0, 1e-9).empty());
}

TEST(Overlaps, ShrinksBothByTheClearance) {
  const std::vector<Polygon> two{{box(0, 0, 10, 10), {}}, {box(9, 0, 20, 10), {}}};
  // One millimetre in common, of which each side gives up the clearance.
  ASSERT_EQ(overlaps(two, 0.2, 1e-9).size(), 1u);
  EXPECT_NEAR(overlaps(two, 0.2, 1e-9)[0].area, 0.6 * 9.6, 1e-9);
  EXPECT_TRUE(overlaps(two, 0.5, 1e-9).empty());
  EXPECT_TRUE(overlaps(two, 100, 1e-9).empty());
}

TEST(Overlaps, RespectsTheSmallestArea) {
  const std::vector<Polygon> two{{box(0, 0, 10, 10), {}}, {box(9, 9, 20, 20), {}}};
  EXPECT_EQ(overlaps(two, 0, 0.99).size(), 1u);
  EXPECT_TRUE(overlaps(two, 0, 1.01).empty());
}

TEST(Overlaps, RespectsHoles) {
  const Polygon frame{box(0, 0, 30, 30), {box(5, 5, 25, 25)}};
  EXPECT_TRUE(overlaps({frame, {box(10, 10, 20, 20), {}}}, 0, 1e-9).empty());
  const std::vector<Overlap> found = overlaps({frame, {box(10, 10, 28, 20), {}}}, 0, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 30.0, 1e-12);
}

TEST(Overlaps, TakesCrossedAndDegenerateRings) {
  // A bow tie: two triangles of area 25 between x = 0 … 10, crossing at (5, 5).
  const Polygon bow{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}};
  const std::vector<Overlap> found = overlaps({bow, {box(-1, -1, 5, 11), {}}}, 0, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 25.0, 1e-9);
  EXPECT_TRUE(
      overlaps({bow, {{{1, 1}, {2, 2}}, {}}, {{}, {}}, {{{0, 0}, {5, 5}, {10, 10}}, {}}}, 0, 1e-9)
          .empty());
  EXPECT_TRUE(overlaps({}, 0, 1e-9).empty());
}

TEST(Overlaps, FindsEveryPairOfAPile) {
  std::vector<Polygon> pile;
  for (int i = 0; i < 5; ++i)
    pile.push_back({box(i, i, i + 10, i + 10), {}});
  const std::vector<Overlap> found = overlaps(pile, 0, 1e-9);
  ASSERT_EQ(found.size(), 10u);
  for (const Overlap& o : found) {
    const double side = 10 - (o.second - o.first);
    EXPECT_NEAR(o.area, side * side, 1e-9);
  }
}

TEST(Overlaps, IsQuickWhenLittleOverlaps) {
  std::vector<Polygon> tiles;
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k < 100; ++k)
      tiles.push_back({box(2 * i, 2 * k, 2 * i + 1, 2 * k + 1), {}});
  }
  tiles.push_back({box(0.5, 0.5, 1.5, 1.5), {}});
  const std::vector<Overlap> found = overlaps(tiles, 0, 1e-9);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].area, 0.25, 1e-12);
}

/// A polygon about a point, and again with places along its sides, turned there and back: the same
/// to within rounding.
std::array<Polygon, 2> drawn_twice(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int corners = 3 + static_cast<int>(between(0, 6));
  const Vec2 centre(between(-300, 300), between(-300, 300));
  const double size = between(20, 400), first = between(0, 6);
  const Eigen::Rotation2Dd turn(between(0, 6));
  Polygon one, again;
  for (int i = 0; i < corners; ++i) {
    const double at = first + 2 * std::numbers::pi * (i + between(-0.3, 0.3)) / corners;
    one.outer.push_back(centre + size * between(0.5, 1.0) * Vec2(std::cos(at), std::sin(at)));
  }
  for (int i = 0; i < corners; ++i) {
    const Vec2 &from = one.outer[i], &to = one.outer[(i + 1) % corners];
    again.outer.push_back(turn.inverse() * (turn * from));
    if (between(0, 1) < 0.5)
      again.outer.push_back(turn.inverse() * (turn * (from + between(0.1, 0.9) * (to - from))));
  }
  return {one, again};
}

TEST(Overlaps, FindsWhatIsDrawnTwice) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 4000; ++i) {
    const auto [one, again] = drawn_twice(random);
    for (const double clearance : {0.0, 1e-3}) {
      const auto found = overlaps({one, again}, clearance, 1e-6);
      ASSERT_EQ(found.size(), 1u) << i << ", clearance " << clearance;
      EXPECT_NEAR(found[0].area, ring_area(one.outer), 1e-2 * ring_area(one.outer));
    }
  }
}

RC_GTEST_PROP(Overlaps, DoNotDependOnWhereTheyAre, ()) {
  const Isometry2 motion = *any_motion();
  const double x = *number_in(-12, 12);
  const double y = *number_in(-12, 12);
  const std::vector<Overlap> found = overlaps(
      {{moved(box(0, 0, 10, 10), motion), {}}, {moved(box(x, y, x + 10, y + 10), motion), {}}}, 0,
      1e-6);
  const double expected = std::max(0.0, 10 - std::abs(x)) * std::max(0.0, 10 - std::abs(y));
  RC_PRE(std::abs(expected - 1e-6) > 1e-9);
  RC_ASSERT(found.size() == (expected > 1e-6 ? 1u : 0u));
  // Corners lie on a grid of 1e-13 of the largest coordinate.
  if (!found.empty()) RC_ASSERT(std::abs(found[0].area - expected) <= 1e-8);
}

}  // namespace
}  // namespace planish::test
