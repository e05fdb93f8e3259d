#include "geometry/random_curves.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using test::any_motion;
using test::number_in;
using test::point_in;

constexpr double pi = std::numbers::pi;

std::vector<Vec2> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Vec2> moved(std::vector<Vec2> points, const Isometry2& motion) {
  for (Vec2& p : points)
    p = motion * p;
  return points;
}

Loop outline(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  }
  return loop;
}

/// A plate 100 by 60 with a round hole of radius 10 in its middle.
Region plate() { return {outline(box(0, 0, 100, 60)), {{Arc{{50, 30}, 10, 0, -2 * pi}}}}; }

double total_area(const std::vector<std::vector<Vec2>>& rings) {
  double sum = 0.0;
  for (const auto& ring : rings)
    sum += std::abs(ring_area(ring));
  return sum;
}

TEST(Area, OfAPlateLacksItsHole) { EXPECT_NEAR(area(plate()), 6000 - 100 * pi, 1e-10); }

TEST(Contains, TellsPlateHoleAndOutside) {
  const Region p = plate();
  EXPECT_TRUE(contains(p, {5, 5}));
  EXPECT_TRUE(contains(p, {39.9, 30}));
  EXPECT_FALSE(contains(p, {50, 30}));
  EXPECT_FALSE(contains(p, {40.1, 30}));
  EXPECT_FALSE(contains(p, {-1, 30}));
  EXPECT_FALSE(contains(p, {50, 61}));
}

TEST(Contains, IsNotMisledAtTheHeightOfJoints) {
  // A slot: arcs and segments meet at y = ±5 and the arcs are extremal at y = 0.
  const Region slot{{Segment{{-20, -5}, {20, -5}}, Arc{{20, 0}, 5, -pi / 2, pi},
                     Segment{{20, 5}, {-20, 5}}, Arc{{-20, 0}, 5, pi / 2, pi}},
                    {}};
  EXPECT_TRUE(contains(slot, {0, 0}));
  EXPECT_TRUE(contains(slot, {-24.9, 0}));
  for (const double y : {-5.0, 0.0, 5.0})
    EXPECT_FALSE(contains(slot, {-30, y})) << y;
  // A diamond, whose corners lie on the ray.
  const Region diamond{outline({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}), {}};
  EXPECT_TRUE(contains(diamond, {0, 0}));
  EXPECT_FALSE(contains(diamond, {-2, 0}));
  EXPECT_FALSE(contains(diamond, {-2, 1}));
}

TEST(Contains, FollowsSplines) {
  // Between y = x³ (as a spline) and the corner (−1, 1).
  const Region r{{CubicSpline{{{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}},
                  Segment{{1, 1}, {-1, 1}}, Segment{{-1, 1}, {-1, -1}}},
                 {}};
  for (int i = -9; i <= 9; ++i) {
    const double x = i / 10.0 + 0.01;
    EXPECT_TRUE(contains(r, {x, x * x * x + 1e-9})) << x;
    EXPECT_FALSE(contains(r, {x, x * x * x - 1e-9})) << x;
  }
}

RC_GTEST_PROP(Contains, AgreesWithADiscHoweverItIsCut, ()) {
  const Vec2 center = *point_in(-10, 10);
  const double r = *number_in(0.5, 10);
  const double start = *number_in(-7, 7);
  const int n = *rc::gen::inRange(1, 9);
  Loop loop;
  for (int i = 0; i < n; ++i)
    loop.push_back(Arc{center, r, start + 2 * pi * i / n, 2 * pi / n});
  const Vec2 p = *point_in(-20, 20);
  const double d = (p - center).norm();
  RC_PRE(std::abs(d - r) > 1e-9);
  RC_ASSERT(contains(Region{loop, {}}, p) == (d < r));
}

TEST(RingArea, IsSignedAndSurvivesDistance) {
  EXPECT_DOUBLE_EQ(ring_area(box(0, 0, 3, 2)), 6.0);
  EXPECT_DOUBLE_EQ(ring_area({{0, 0}, {0, 2}, {3, 2}, {3, 0}}), -6.0);
  EXPECT_DOUBLE_EQ(ring_area(box(1e8, 1e8, 1e8 + 3, 1e8 + 2)), 6.0);
  EXPECT_EQ(ring_area({}), 0.0);
  EXPECT_EQ(ring_area({{1, 1}, {2, 5}}), 0.0);
}

TEST(Inside, IsEvenOdd) {
  const std::vector<std::vector<Vec2>> rings{box(0, 0, 10, 10), box(3, 3, 7, 7)};
  EXPECT_TRUE(inside(rings, {1, 5}));
  EXPECT_FALSE(inside(rings, {5, 5}));
  EXPECT_FALSE(inside(rings, {11, 5}));
  EXPECT_FALSE(inside(rings, {-1, 3}));  // along edges of both rings
  EXPECT_FALSE(inside({}, {0, 0}));
}

TEST(PolygonOf, KeepsHolesAndComesNearTheArea) {
  const Polygon p = polygon_of(plate(), 0.001);
  ASSERT_EQ(p.holes.size(), 1u);
  EXPECT_DOUBLE_EQ(ring_area(p.outer), 6000.0);
  // Inscribed in the hole: smaller than it by at most chord × circumference.
  EXPECT_LT(ring_area(p.holes[0]), 0.0);
  EXPECT_NEAR(ring_area(p.holes[0]), -100 * pi, 0.001 * 20 * pi);
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
  if (!found.empty()) RC_ASSERT(std::abs(found[0].area - expected) <= 1e-9);
}

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

TEST(SmallestRectangle, OfATurnedRectangleIsItself) {
  const Isometry2 motion = Eigen::Translation2d(100, -50) * Eigen::Rotation2Dd(0.4);
  const EnclosingRectangle found = smallest_rectangle(moved(box(0, 0, 7, 3), motion));
  EXPECT_NEAR(found.size.x(), 7.0, 1e-12);
  EXPECT_NEAR(found.size.y(), 3.0, 1e-12);
  EXPECT_NEAR(found.angle, 0.4, 1e-12);
}

TEST(SmallestRectangle, OfFewOrCollinearPoints) {
  EXPECT_EQ(smallest_rectangle({}).size, Vec2(0, 0));
  EXPECT_EQ(smallest_rectangle({{3, 4}}).size, Vec2(0, 0));
  const EnclosingRectangle line = smallest_rectangle({{0, 0}, {3, 4}, {1.5, 2}, {0, 0}});
  EXPECT_DOUBLE_EQ(line.size.x(), 5.0);
  EXPECT_EQ(line.size.y(), 0.0);
  EXPECT_NEAR(line.angle, std::atan2(4, 3), 1e-15);
}

RC_GTEST_PROP(SmallestRectangle, IsTheLeastOfAllDirectionsOfTheHull, ()) {
  const int n = *rc::gen::inRange(3, 40);
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back(*point_in(-10, 10));
  const EnclosingRectangle found = smallest_rectangle(points);
  RC_ASSERT(found.size.x() >= found.size.y());
  RC_ASSERT(found.angle > -pi / 2 - 1e-15);
  RC_ASSERT(found.angle <= pi / 2);
  const auto extent_along = [&](double angle) {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (const Vec2& p : points) {
      const double x = p.dot(Vec2(std::cos(angle), std::sin(angle)));
      lo = std::min(lo, x);
      hi = std::max(hi, x);
    }
    return hi - lo;
  };
  // It encloses at its angle, and no pair of points spans a smaller one.
  RC_ASSERT(std::abs(extent_along(found.angle) - found.size.x()) <= 1e-11);
  RC_ASSERT(std::abs(extent_along(found.angle + pi / 2) - found.size.y()) <= 1e-11);
  const double least = found.size.x() * found.size.y();
  for (const Vec2& p : points) {
    for (const Vec2& q : points) {
      if ((q - p).norm() < 1e-9) continue;
      const double angle = std::atan2(q.y() - p.y(), q.x() - p.x());
      RC_ASSERT(extent_along(angle) * extent_along(angle + pi / 2) >= least - 1e-9);
    }
  }
}

}  // namespace
}  // namespace planish
