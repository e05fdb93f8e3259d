#include "geometry/random_curves.hpp"
#include "geometry/rings.hpp"

#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

/// A plate 100 by 60 with a round hole of radius 10 in its middle.
Region plate() { return {outline(box(0, 0, 100, 60)), {{Arc{{50, 30}, 10, 0, -2 * pi}}}}; }

TEST(Overlaps, OfARingThatRunsThereAndBackIsThatOfItsArea) {
  // A square with a bow tie and a spur: made valid, it has lines beside its areas.
  const Polygon spurred{{{0, 0}, {10, 0}, {10, 5}, {15, 5}, {10, 5}, {10, 10}, {0, 10}}, {}};
  const Polygon crossed{{{0, 0}, {10, 0}, {10, 10}, {12, 10}, {10, 10}, {0, 10}, {5, 5}, {0, 0}},
                        {}};
  const Polygon square{{{8, 2}, {20, 2}, {20, 8}, {8, 8}}, {}};
  for (const Polygon& polygon : {spurred, crossed}) {
    const auto found = overlaps({polygon, square}, 0.0, 0.0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].area, 2 * 6, 1e-9);
  }
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
}  // namespace planish::test
