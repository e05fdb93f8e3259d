#include "profile_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::job {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vec3> points_of(Profile profile, const Frame& frame = {}, const Mesh& mesh = {}) {
  return profile_points({std::move(profile), frame}, mesh);
}

double length_around(const std::vector<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  return length;
}

double area_within(const std::vector<Vec3>& points) {
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 &a = points[i], &b = points[(i + 1) % points.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

TEST(ProfilePoints, OfAPolygonAreItsCornersInSpace) {
  const Frame frame = frame_from_axes({10, 20, 30}, Vec3::UnitX(), Vec3::UnitY());
  const auto points = points_of(PolygonProfile{{{0, 0}, {5, 0}, {0, 7}}}, frame);
  EXPECT_EQ(points, (std::vector<Vec3>{{10, 20, 30}, {10, 25, 30}, {10, 20, 37}}));
}

TEST(ProfilePoints, OfAnEllipseLieOnItEvenly) {
  const auto points = points_of(EllipseProfile{40, 30});
  ASSERT_EQ(points.size(), 96u);
  for (const Vec3& p : points)
    EXPECT_NEAR(std::pow(p.x() / 40, 2) + std::pow(p.y() / 30, 2), 1.0, 1e-12);
  EXPECT_LT((points[0] - Vec3(40, 0, 0)).norm(), 1e-12);
  EXPECT_LT((points[24] - Vec3(0, 30, 0)).norm(), 1e-12);
  // A polygon inscribed in 96 equal parts of the parameter.
  EXPECT_NEAR(area_within(points), 0.5 * 96 * 40 * 30 * std::sin(2 * kPi / 96), 1e-9);
}

TEST(ProfilePoints, OfARoundedRectangleKeepItsSizeAndItsRadius) {
  const auto points = points_of(RoundedRectangleProfile{100, 60, 10});
  // Chords of 3.75° on four quarters, and the straight sides.
  const double chords = 96 * 2 * 10 * std::sin(kPi / 96);
  EXPECT_NEAR(length_around(points), chords + 2 * (80 + 40), 1e-9);
  EXPECT_NEAR(area_within(points), 100 * 60 - 400 + 0.5 * 96 * 100 * std::sin(2 * kPi / 96), 1e-9);
  for (const Vec3& p : points) {
    EXPECT_LE(std::abs(p.x()), 50.0 + 1e-12);
    EXPECT_LE(std::abs(p.y()), 30.0 + 1e-12);
    const Vec2 beyond(std::max(0.0, std::abs(p.x()) - 40), std::max(0.0, std::abs(p.y()) - 20));
    EXPECT_NEAR(beyond.norm(), 10.0, 1e-9);
  }
}

TEST(ProfilePoints, OfAnObroundAreTwoHalfCircles) {
  const auto points = points_of(ObroundProfile{100, 40});
  EXPECT_NEAR(length_around(points), 96 * 2 * 20 * std::sin(kPi / 96) + 2 * 60, 1e-9);
  EXPECT_NEAR(area_within(points), 60 * 40 + 0.5 * 96 * 400 * std::sin(2 * kPi / 96), 1e-9);
  for (const Vec3& p : points)
    EXPECT_NEAR(std::hypot(std::max(0.0, std::abs(p.x()) - 30), p.y()), 20.0, 1e-9);
}

/// Two rings of four points between which eight triangles run, the first ring at z = 0.
Mesh tube() {
  Mesh mesh;
  for (const double z : {0.0, 50.0})
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
      mesh.points.emplace_back(10 * x, 10 * y, z);
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    mesh.triangles.push_back({i, next, 4 + i});
    mesh.triangles.push_back({next, 4 + next, 4 + i});
  }
  return mesh;
}

TEST(ProfilePoints, OfASplineAreTheBorderOfTheMeshInItsPlane) {
  const SplineProfile spline{{{10, 0}, {0, 10}, {-10, 0}}};
  EXPECT_EQ(points_of(spline).size(), 3u) << "without a mesh its points";
  for (const double z : {0.0, 50.0}) {
    const auto points = points_of(spline, frame_from_axes({0, 0, z}, Vec3::UnitZ(), Vec3::UnitX()),
                                  tube());
    ASSERT_EQ(points.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(points[i].z(), z);
      EXPECT_NEAR((points[(i + 1) % 4] - points[i]).norm(), std::sqrt(200.0), 1e-12)
          << "one after the other";
    }
  }
  EXPECT_EQ(points_of(PolygonProfile{{{0, 0}, {5, 0}, {0, 7}}}, {}, tube()).size(), 3u);
}

}  // namespace
}  // namespace planish::job
