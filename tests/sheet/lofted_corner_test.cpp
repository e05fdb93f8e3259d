#include "support/sheets.hpp"

#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

// Flat patterns of plates joined by an oblique cone, against math.md#general-cone and
// math.md#neutral-surface by quadrature.

namespace planish::test {
namespace {

double simpson(const std::function<double(double)>& f) {
  constexpr int halves = 1000;
  double sum = f(0) + f(1);
  for (int i = 1; i < 2 * halves; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * f(i / (2.0 * halves));
  return sum / (6 * halves);
}

/// The neutral surface lies `depth` below the reference skin. A strip of ruling of length L whose
/// normal turns by dn away from where its neighbour lies loses L·depth·dn there.
double area_below(const LoftedCorner& corner, double depth) {
  const SpaceCurve arc = corner.arc();
  const double k = corner.near;
  const auto on_skin = [&](double t) {
    const SpaceCurvePoint c = arc(t);
    return 0.5 * (1 - k * k) * (c.point - corner.apex).cross(c.derivative).norm();
  };
  const auto turning = [&](double t) {
    const SpaceCurvePoint c = arc(t);
    const Vec3 arm = c.point - corner.apex, normal = c.derivative.cross(arm);
    const Vec3 across = arm.cross(normal).normalized();
    return (1 - k) * arm.norm() * c.second.cross(arm).dot(across) / normal.norm();
  };
  const double lengths = (corner.p0 - corner.apex).norm() + (corner.p1 - corner.apex).norm();
  const double plates = 0.5 * (1 - k * k) * corner.width * lengths;
  return plates + simpson(on_skin) - depth * simpson(turning);
}

std::vector<LoftedCorner> corners() {
  LoftedCorner leaning;
  leaning.apex = {60, -10, 60};
  leaning.near = 0.2;
  return {LoftedCorner{}, other_side(LoftedCorner{}), leaning, other_side(leaning)};
}

TEST(LoftedCorner, HasTheFlatAreaOfItsNeutralSurface) {
  for (const LoftedCorner& corner : corners()) {
    const Sheet sheet = lofted_corner(corner);
    for (double k : {0.3, 0.5}) {
      const auto pattern = flatten(sheet, {.allowance = ConstantK{k, "test"}});
      ASSERT_TRUE(pattern) << pattern.error().message;
      const bool inside = sheet.bends.front().reference_inside;
      const double area = area_below(corner, corner.thickness * (inside ? k : 1 - k));
      EXPECT_NEAR(pattern->area, area, 1e-7 * area)
          << "k " << k << (inside ? " inside" : " outside");
    }
    EXPECT_NEAR(*sheet.volume, corner.thickness * area_below(corner, 0.5 * corner.thickness),
                1e-7 * *sheet.volume);
  }
}

TEST(LoftedCorner, KeepsEveryLengthOfTheNeutralSurface) {
  const LoftedCorner corner;
  const auto pattern = flatten(lofted_corner(corner), {.allowance = ConstantK{0.0, "test"}});
  ASSERT_TRUE(pattern);
  const double k = corner.near;
  const double r0 = (corner.p0 - corner.apex).norm(), r1 = (corner.p1 - corner.apex).norm();
  const double arc = simpson([&](double t) { return corner.arc()(t).derivative.norm(); });
  // Two plates: far side, near side, and the slanted one; the cone's two ends.
  const auto plate = [&](double r) {
    return (1 + k) * corner.width + (1 - k) * std::hypot(r, corner.width);
  };
  EXPECT_NEAR(pattern->perimeter, (1 + k) * arc + plate(r0) + plate(r1), 1e-4);
}

TEST(LoftedCorner, IsABendBetweenItsPlates) {
  for (const LoftedCorner& corner : corners()) {
    const Sheet sheet = lofted_corner(corner);
    const Vec3 n0 = (corner.tangent_point - corner.p0).cross(corner.p0 - corner.apex);
    const Vec3 n1 = (corner.p1 - corner.tangent_point).cross(corner.p1 - corner.apex);
    EXPECT_NEAR(sheet.bends.front().angle.radians(), std::atan2(n0.cross(n1).norm(), n0.dot(n1)),
                1e-9);
    EXPECT_NE(sheet.bends.front().reference_inside,
              lofted_corner(other_side(corner)).bends.front().reference_inside);
  }
}

}  // namespace
}  // namespace planish::test
