#include "nearest_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish::test {
namespace {

using namespace slit_detail;

/// Points of the plane z = 0, 1 apart, from −half to half.
std::vector<Vec3> grid(int half) {
  std::vector<Vec3> points;
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j)
      points.emplace_back(i, j, 0);
  return points;
}

TEST(NearestPoints, AreThoseOfASearchThroughAll) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i)
    points.push_back(any());
  const NearestPoints cloud(points);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = 1.5 * any();
    const auto nearest = std::ranges::min_element(
        points, [&](const Vec3& a, const Vec3& b) { return (a - p).norm() < (b - p).norm(); });
    EXPECT_EQ(cloud.nearest(p), *nearest);
  }
}

TEST(ScannedSurface, IsThePlaneOfItsPoints) {
  const ScannedSurface surface(grid(25));
  for (const Vec3& p : {Vec3(0.3, -4.2, 0.5), Vec3(12.5, 7.1, -0.9), Vec3(-3, 3, 0)}) {
    const auto foot = surface.nearest(p);
    EXPECT_NEAR((foot.point - Vec3(p.x(), p.y(), 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((foot.derivative - Vec3(1, 1, 0).asDiagonal().toDenseMatrix()).norm(), 0.0, 1e-12);
  }
}

TEST(ScannedSurface, OfATracedEdgeIsItsLine) {
  std::vector<Vec3> points;
  const Vec3 along = Vec3(2, -1, 2).normalized();
  for (int i = -50; i <= 50; ++i)
    points.emplace_back(0.5 * i * along);
  const auto foot = ScannedSurface(points).nearest(3.1 * along + Vec3(0, 2, 1));
  // (0, 2, 1) is perpendicular to (2, −1, 2).
  EXPECT_NEAR((foot.point - 3.1 * along).norm(), 0.0, 1e-12);
  EXPECT_NEAR((foot.derivative - along * along.transpose()).norm(), 0.0, 1e-12);
}

TEST(ScannedSurface, EndsWithItsPoints) {
  // The dozen points nearest to one far beyond the middle of a side are those of the last row.
  const auto foot = ScannedSurface(grid(25)).nearest({1000, 0.2, 3});
  EXPECT_NEAR((foot.point - Vec3(25, 0.2, 0)).norm(), 0.0, 1e-12);
  // Far beyond the end of a row of points, the line through them ends, twice as long as they are.
  std::vector<Vec3> row;
  for (int i = -5; i <= 5; ++i)
    row.emplace_back(i, 0, 0);
  EXPECT_NEAR((ScannedSurface(row).nearest({1000, 0, 0}).point - Vec3(10, 0, 0)).norm(), 0.0,
              1e-12);
}

TEST(ScannedSurface, HasTheDerivativeOfItsFoot) {
  const ScannedSurface surface(grid(25));
  for (const Vec3& p : {Vec3(0.3, -4.2, 0.5), Vec3(60, 3.3, 2)}) {
    constexpr double kStep = 1e-5;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = kStep * Vec3::Unit(axis);
      const Vec3 slope = (surface.nearest(p + step).point - surface.nearest(p - step).point) /
                         (2 * kStep);
      EXPECT_NEAR((slope - surface.nearest(p).derivative.col(axis)).norm(), 0.0, 1e-8);
    }
  }
}

}  // namespace
}  // namespace planish::test
