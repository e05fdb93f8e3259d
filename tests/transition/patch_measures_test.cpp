#include "ruled_patch.hpp"
#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

const double kSlant = std::hypot(80.0, 30.0);

TEST(PatchArea, IsThatOfAFrustum) {
  const Ring ring = frustum();
  EXPECT_NEAR(ring.patch(0).area(0.0, 1.0), kPi * 70 * kSlant, 1e-8);
  EXPECT_NEAR(ring.patch(0).area(0.2, 0.3), 0.1 * kPi * 70 * kSlant, 1e-9);
}

TEST(PatchArea, IsThatOfTrapeziaAndObliqueCones) {
  double area = 0.0;
  for (const RuledPatch& patch : pyramid().patches)
    area += patch.area(0.0, 1.0);
  EXPECT_NEAR(area, 4 * 80 * std::hypot(80, 20), 1e-9);
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).area(0.0, 1.0),
              circle_cone_area({50, 50, 0}, {0, 0, 80}, 30, 0.0, kPi / 2), 1e-7);
}

TEST(PatchBorderLength, IsTheArcOrZeroWhereASideStands) {
  EXPECT_NEAR(frustum().patch(0).border_length(0, 0.0, 0.25), 0.5 * kPi * 50, 1e-11);
  const Ring ring = square_to_circle();
  EXPECT_EQ(first_cone(ring).border_length(0, 0.0, 1.0), 0.0);
  EXPECT_NEAR(first_cone(ring).border_length(1, 0.0, 1.0), 0.5 * kPi * 30, 1e-9);
}

TEST(PatchTurn, OfAConeIsItsAzimuthTimesTheCosineOfItsHalfAngle) {
  EXPECT_NEAR(frustum().patch(0).turn(0.0, 1.0), 2 * kPi * 80 / kSlant, 1e-11);
  EXPECT_EQ(pyramid().patch(0).turn(0.0, 1.0), 0.0);
}

TEST(PatchTurned, IsBetweenTheNormalsTheLongWayRoundBeyondAHalf) {
  const Ring ring = frustum();
  // Normals of a quarter turn apart, both 30/80 upwards.
  const double quarter = std::acos(30 * 30 / (kSlant * kSlant));
  EXPECT_NEAR(ring.patch(0).turned(0.1, 0.35), quarter, 1e-12);
  EXPECT_NEAR(ring.patch(0).turned(0.1, 0.85), 2 * kPi - quarter, 1e-12);
}

TEST(PatchRadii, OfAConeGrowWithTheDistanceFromItsAxis) {
  const RuledPatch::Radii radii = frustum().patch(0).smallest_radii(0.0, 1.0);
  EXPECT_NEAR(radii.end, 20 * kSlant / 80, 1e-10);
  EXPECT_NEAR(radii.middle, 35 * kSlant / 80, 1e-10);
}

/// Radius of curvature of the cone over the circle at the circle (Meusnier, Euler).
double radius_at_circle(const Vec3& apex, const Vec3& centre, double radius, double t) {
  const Vec3 out(std::cos(t), std::sin(t), 0.0), along(-std::sin(t), std::cos(t), 0.0);
  const Vec3 g = (centre + radius * out - apex).normalized(), n = along.cross(g).normalized();
  const double sine = along.cross(g).norm();
  return sine * sine * radius / std::abs(n.dot(out));
}

TEST(PatchDistanceOfRadius, IsWhereTheTightestRulingOfAnObliqueConeIsWideEnough) {
  const Vec3 apex(50, 50, 0), centre(0, 0, 80);
  double expected = 0.0;
  for (int i = 0; i <= 10000; ++i) {
    const double t = 0.5 * kPi * i / 10000;
    const double length = (centre + 30 * Vec3(std::cos(t), std::sin(t), 0) - apex).norm();
    expected = std::max(expected, 2.5 * length / radius_at_circle(apex, centre, 30, t));
  }
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).distance_of_radius(2.5), expected, 1e-4 * expected);
}

TEST(PatchTipArea, OfAConeIsASectorOfItsDevelopment) {
  const Vec3 apex(50, 50, 0), centre(0, 0, 80);
  const auto arm = [&](int i) -> Vec3 {
    const double t = 0.5 * kPi * i / 20000;
    return (centre + 30 * Vec3(std::cos(t), std::sin(t), 0) - apex).normalized();
  };
  double angle = 0.0;
  for (int i = 0; i < 20000; ++i)
    angle += (arm(i + 1) - arm(i)).norm();
  const Ring ring = square_to_circle();
  EXPECT_NEAR(first_cone(ring).tip_area(0.0, 1.0, {.at_from = {3.0, 0.0}, .at_to = {3.0, 0.0}}),
              0.5 * 9.0 * angle, 1e-6);
}

TEST(PatchTipArea, OfAPlaneAreTrianglesInItsCorners) {
  const RuledPatch patch = pyramid().patch(0);
  const auto [p0, q0] = patch.ruling(0.0);
  const Vec3 p1 = patch.ruling(1.0)[0];
  const double sine = (p1 - p0).normalized().cross((q0 - p0).normalized()).norm();
  EXPECT_NEAR(patch.tip_area(0.0, 1.0, {.at_from = {2.0, 0.0}, .at_to = {3.0, 0.0}}),
              0.5 * (4.0 + 9.0) * sine, 1e-12);
}

}  // namespace
}  // namespace planish::test
