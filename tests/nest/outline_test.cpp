#include "outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::nest_detail {
namespace {

using std::numbers::pi;

Loop polygon(const std::vector<Vec2>& corners) {
  Loop loop;
  for (size_t i = 0; i < corners.size(); ++i)
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  return loop;
}

Loop rectangle_loop(double length, double width) {
  return polygon({{0, 0}, {length, 0}, {length, width}, {0, width}});
}

std::vector<Vec2> in_mm(const Path& path) {
  std::vector<Vec2> points;
  for (const IntPoint& p : path)
    points.emplace_back(kUnit * static_cast<double>(p.X), kUnit * static_cast<double>(p.Y));
  return points;
}

/// How far inside a polygon, counter-clockwise and convex at p's nearest side, a point lies;
/// negative outside.
double depth_in(const std::vector<Vec2>& ring, const Vec2& p) {
  double nearest = HUGE_VAL;
  double turned = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - p, b = ring[(i + 1) % ring.size()] - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    const Vec2 along = b - a;
    const double t = std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * along).norm());
  }
  return turned > pi ? nearest : -nearest;
}

TEST(InUnits, RoundsToTheNearest) {
  EXPECT_EQ(in_units(1.0), 10000);
  EXPECT_EQ(in_units(-0.00016), -2);
  EXPECT_EQ(in_units(0.00004), 0);
}

TEST(OutlineAround, OfARectangleIsThatRectangleGrown) {
  for (const double reach : {0.0, 2.5}) {
    const auto ring = in_mm(outline_around(rectangle_loop(100, 60), reach));
    ASSERT_EQ(ring.size(), 4u);
    Box2 box;
    for (const Vec2& p : ring)
      box.add(p);
    EXPECT_NEAR((box.lo - Vec2(-reach, -reach)).norm(), 0.0, 2e-4);
    EXPECT_NEAR((box.hi - Vec2(100 + reach, 60 + reach)).norm(), 0.0, 2e-4);
  }
}

TEST(OutlineAround, ContainsTheContourAndItsReachWithinItsBox) {
  const Loop round{Arc{{50, 30}, 40, 0.0, 2 * pi}};
  const Loop kidney{Arc{{0, 0}, 50, 0.0, pi}, Arc{{-35, 0}, 15, pi, pi}, Arc{{0, 0}, 20, pi, -pi},
                    Arc{{35, 0}, 15, pi, pi}};
  std::vector<Vec2> star;
  for (int i = 0; i < 40; ++i)
    star.push_back((i % 2 ? 60.0 : 52.0) * Vec2(std::cos(pi * i / 20), std::sin(pi * i / 20)));
  for (const Loop& contour : {round, kidney, polygon(star), rectangle_loop(30, 1000)})
    for (const double reach : {0.0, 2.5, 10.0}) {
      const Path path = outline_around(contour, reach);
      EXPECT_LE(path.size(), kMostCorners);
      EXPECT_GT(ClipperLib::Area(path), 0.0) << "counter-clockwise";
      const auto ring = in_mm(path);
      const Box2 box = bounds(contour);
      for (const Vec2& p : ring) {
        EXPECT_GE(p.x(), box.lo.x() - reach - 2e-4);
        EXPECT_GE(p.y(), box.lo.y() - reach - 2e-4);
        EXPECT_LE(p.x(), box.hi.x() + reach + 2e-4);
        EXPECT_LE(p.y(), box.hi.y() + reach + 2e-4);
      }
      for (const Vec2& p : sampled(contour, 0.01))
        EXPECT_GE(depth_in(ring, p), reach - 1e-3);
    }
}

TEST(OutlineAround, LiesCloseToSimpleContours) {
  // An angle of two legs of 100 × 20, rounded on the outside: a disc's quarter is missing.
  const Loop rounded{Arc{{20, 20}, 20, pi, pi / 2}, Segment{{20, 0}, {100, 0}},
                     Segment{{100, 0}, {100, 20}},  Segment{{100, 20}, {20, 20}},
                     Segment{{20, 20}, {20, 100}},  Segment{{20, 100}, {0, 100}},
                     Segment{{0, 100}, {0, 20}}};
  const double exact = 3600 - (1 - pi / 4) * 400;
  const double area = ClipperLib::Area(outline_around(rounded, 0.0)) * kUnit * kUnit;
  EXPECT_GE(area, exact - 1e-3);
  EXPECT_LT(area, 1.06 * exact);
  const Path corner = outline_around(
      polygon({{0, 0}, {100, 0}, {100, 10}, {10, 10}, {10, 100}, {0, 100}}), 1.0);
  EXPECT_NEAR(ClipperLib::Area(corner) * kUnit * kUnit, 102 * 12 + 90 * 12, 0.1);
}

}  // namespace
}  // namespace planish::nest_detail
