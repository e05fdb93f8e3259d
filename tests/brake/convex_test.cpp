#include "convex.hpp"

#include <planish/geometry/interval.hpp>
#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

struct Plane {
  std::mt19937 random{11};
  double between(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  }
  std::vector<Vec2> points(int count, const Vec2& middle = Vec2::Zero()) {
    std::vector<Vec2> all;
    for (int i = 0; i < count; ++i)
      all.push_back(middle + Vec2(between(-5, 5), between(-5, 5)));
    return all;
  }
  Convex polygon(const Vec2& middle = Vec2::Zero()) { return hull_of(points(8, middle)); }
  Vec2 direction() {
    const double angle = between(-3.2, 3.2);
    return {std::cos(angle), std::sin(angle)};
  }
};

bool is_within(const Convex& polygon, const Vec2& p, double by = 1e-9) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (cross(side, p - polygon[i]) < -by * side.norm()) return false;
  }
  return true;
}

/// Of a direction: from where to where the polygon reaches.
Interval reach_along(const Convex& polygon, const Vec2& n) {
  Interval reach{1e9, -1e9};
  for (const Vec2& p : polygon)
    reach = {std::min(reach.lo, n.dot(p)), std::max(reach.hi, n.dot(p))};
  return reach;
}

TEST(Convex, HullIsMadeOfPointsAndHoldsAllOfThem) {
  Plane plane;
  for (int run = 0; run < 200; ++run) {
    const std::vector<Vec2> points = plane.points(3 + run % 10);
    const Convex hull = hull_of(points);
    for (const Vec2& corner : hull)
      EXPECT_NE(std::ranges::find(points, corner), points.end());
    for (const Vec2& p : points)
      EXPECT_TRUE(is_within(hull, p));
    for (std::size_t i = 0; i < hull.size(); ++i)
      EXPECT_GT(cross(hull[(i + 1) % hull.size()] - hull[i],
                      hull[(i + 2) % hull.size()] - hull[(i + 1) % hull.size()]),
                0.0);
  }
  EXPECT_EQ(hull_of({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 0}}).size(), 3u);
  EXPECT_EQ(hull_of({{1, 1}, {1, 1}}).size(), 1u);
}

/// Both sides of a cut are the whole, and each point is on its own side.
TEST(Convex, ClippingPartsAPolygon) {
  Plane plane;
  int both = 0;
  for (int run = 0; run < 300; ++run) {
    const Convex polygon = plane.polygon();
    const Vec2 normal = plane.direction();
    const double offset = plane.between(-4, 4);
    const Convex near = clipped(polygon, normal, offset), far = clipped(polygon, -normal, -offset);
    EXPECT_NEAR(ring_area(near) + ring_area(far), ring_area(polygon), 1e-9);
    for (const Vec2& p : near)
      EXPECT_LE(normal.dot(p), offset + 1e-9);
    for (const Vec2& p : far)
      EXPECT_GE(normal.dot(p), offset - 1e-9);
    both += !near.empty() && !far.empty() ? 1 : 0;
  }
  EXPECT_GT(both, 100);
  // A cut through a corner or along a side leaves whole what is on the near side.
  const Convex square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(clipped(square, {1, 0}, 1.0), square);
  EXPECT_TRUE(clipped(square, {1, 0}, 0.0).empty());
  EXPECT_NEAR(ring_area(clipped(square, {1, 1}, 1.0)), 0.5, 1e-12);
}

/// By all directions: polygons are apart by the widest gap seen along any of them.
TEST(Convex, SeparationAndDistanceAreThoseOfAllDirections) {
  Plane plane;
  int apart = 0, met = 0;
  for (int run = 0; run < 300; ++run) {
    const Convex a = plane.polygon(), b = plane.polygon({plane.between(-12, 12), 4.0});
    double widest = -1e9, at_sides = -1e9;
    const auto gap = [&](const Vec2& n) { return reach_along(b, n).lo - reach_along(a, n).hi; };
    for (int i = 0; i < 3600; ++i)
      widest = std::max(widest, gap({std::cos(i * std::numbers::pi / 1800.0),
                                     std::sin(i * std::numbers::pi / 1800.0)}));
    for (const auto& [polygon, sign] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}})
      for (std::size_t i = 0; i < polygon->size(); ++i) {
        const Vec2 side = ((*polygon)[(i + 1) % polygon->size()] - (*polygon)[i]).normalized();
        at_sides = std::max(at_sides, gap(sign * Vec2(side.y(), -side.x())));
      }
    EXPECT_NEAR(separation(a, b), at_sides, 1e-9);
    EXPECT_NEAR(separation(a, b), separation(b, a), 1e-9);
    if (widest > 0.05) {
      ++apart;
      // Directions are looked at in steps of 0.1°, of which 20 mm see 0.02.
      EXPECT_GE(distance(a, b), widest - 1e-9);
      EXPECT_LE(distance(a, b), widest + 0.02);
      EXPECT_LE(separation(a, b), distance(a, b) + 1e-9);
    } else if (widest < -0.05) {
      ++met;
      EXPECT_EQ(distance(a, b), 0.0);
      EXPECT_NEAR(separation(a, b), widest, 0.05);
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(met, 50);
}

TEST(Convex, IsThinWhereItIsNarrowInSomeDirection) {
  Plane plane;
  for (int run = 0; run < 200; ++run) {
    const Convex polygon = plane.polygon();
    double width = 1e9;
    for (int i = 0; i < 1800; ++i) {
      const Interval reach = reach_along(polygon, {std::cos(i * std::numbers::pi / 1800.0),
                                                   std::sin(i * std::numbers::pi / 1800.0)});
      width = std::min(width, reach.size());
    }
    EXPECT_TRUE(is_thin(polygon, width + 0.01));
    EXPECT_FALSE(is_thin(polygon, width - 0.05));
  }
  EXPECT_TRUE(is_thin({{0, 0}, {9, 0}}, 0.0));
}

TEST(Convex, MirrorTurnsXRound) {
  Plane plane;
  const Convex polygon = plane.polygon({3, 1}), mirror = mirrored(polygon);
  EXPECT_NEAR(ring_area(mirror), ring_area(polygon), 1e-12);
  for (const Vec2& p : polygon)
    EXPECT_NE(std::ranges::find(mirror, Vec2(-p.x(), p.y())), mirror.end());
  EXPECT_EQ(mirrored(mirror), polygon);
}

/// Star-shaped outlines: the pieces are convex, run counter-clockwise, cover what the outline does
/// and no place twice.
TEST(Convex, PiecesCoverAPolygonOnce) {
  Plane plane;
  for (int run = 0; run < 40; ++run) {
    Polygon polygon;
    const int corners = 5 + run % 8;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners, far = plane.between(3, 9);
      polygon.outer.emplace_back(far * std::cos(angle), far * std::sin(angle));
    }
    double area = ring_area(polygon.outer);
    if (run % 2) {
      polygon.holes = {{{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}};
      area -= 1.0;
    }
    if (run % 3 == 0) std::ranges::reverse(polygon.outer);
    double covered = 0.0;
    const std::vector<Convex> pieces = convex_pieces(polygon);
    for (const Convex& piece : pieces) {
      covered += ring_area(piece);
      for (std::size_t i = 0; i < piece.size(); ++i)
        EXPECT_TRUE(is_within(piece, piece[i]));
    }
    EXPECT_NEAR(covered, std::abs(area), 1e-6);
    EXPECT_LT(pieces.size(), static_cast<std::size_t>(corners) + 5u);
  }
  // A convex outline stays one piece; shrunk, it is smaller by the strip along its sides.
  EXPECT_EQ(convex_pieces({{{0, 0}, {0, 4}, {6, 4}, {6, 0}}, {}}).size(), 1u);
  double left = 0.0;
  for (const Convex& piece : convex_pieces({{{0, 0}, {6, 0}, {6, 4}, {0, 4}}, {}}, 0.5))
    left += ring_area(piece);
  EXPECT_NEAR(left, 5.0 * 3.0, 1e-6);
}

}  // namespace
}  // namespace planish::test
