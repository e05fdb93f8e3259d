#include "bend_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using std::numbers::pi;

BendFrame frame_at_angle(double beta) {
  const Angle angle = Angle::degrees(beta);
  return {{10, 20, 30},
          Vec3::UnitX(),
          {Vec3::UnitY(), Vec3(0, std::cos(angle.radians()), std::sin(angle.radians()))},
          Vec3::Zero(),
          angle};
}

/// On both sides the surface runs along the tangent line and lies in the plate's plane there.
void expect_tangent(const BendSurface& surface, const BendFrame& frame, const TangentLine& line) {
  for (int side = 0; side < 2; ++side) {
    const double u = surface.azimuth(side);
    const Vec3 n = normal_on(surface.mid, u);
    EXPECT_NEAR(n.dot(frame.d), 0.0, 1e-12);
    EXPECT_NEAR(n.dot(frame.e[side]), 0.0, 1e-12);
    for (const double v : {50.0, 90.0}) {
      const Vec3 p = point_on(surface.mid, {u, v});
      const Vec2 xy = frame.local(side, p);
      EXPECT_NEAR(xy.y(), line.at(xy.x()), 1e-10);
      EXPECT_LT((surface.local(side, p) - Vec2(v, 0)).norm(), 1e-10);
      EXPECT_LT((surface.point(side, {v, 0}) - p).norm(), 1e-10);
    }
  }
}

/// Whether the material of a plate beyond its tangent line lies at h > 0.
double away(const BendSurface& surface, const BendFrame& frame, int side, double y) {
  const Vec3 beyond = surface.point(side, {70, 0}) + y * frame.e[side];
  return surface.local(side, beyond).y();
}

TEST(TangentSurface, OfALevelLineIsACylinder) {
  for (const double beta : {30.0, 90.0, 150.0})
    for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted}) {
      const BendFrame frame = frame_at_angle(beta);
      const TangentLine line{0.0, -14.0};
      const BendSurface surface = tangent_surface(frame, kind, line);
      EXPECT_EQ(surface.kind, BendKind::cylinder);
      EXPECT_NEAR(std::get<Cylinder>(surface.mid).radius, 14 * std::tan(beta * pi / 360), 1e-12);
      const double turn = pi - beta * pi / 180;
      const bool facing = kind == EdgeKind::facing;
      EXPECT_NEAR(surface.sweep, facing ? turn : 2 * pi - turn, 1e-12);
      EXPECT_NEAR(surface.turned().radians(), surface.sweep, 1e-12);
      expect_tangent(surface, frame, line);
      for (int side = 0; side < 2; ++side)
        EXPECT_NEAR(away(surface, frame, side, facing ? 5 : -5), 5.0, 1e-10);
    }
}

TEST(TangentSurface, OfASlopeIsAConeWithItsApexOnTheLineOfThePlanes) {
  for (const double slope : {0.2, -0.2})
    for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted}) {
      const BendFrame frame = frame_at_angle(70.0);
      const TangentLine line{slope, slope * 40.0};
      const BendSurface surface = tangent_surface(frame, kind, line);
      EXPECT_EQ(surface.kind, BendKind::cone);
      const Cone& cone = std::get<Cone>(surface.mid);
      EXPECT_LT((cone.frame.origin - (frame.origin + 40 * frame.d)).norm(), 1e-11);
      // math.md#tangent-cone: sin φ · tan(β/2) is the tangent of the half-angle.
      const double sine = std::sin(std::atan(std::abs(slope)));
      EXPECT_NEAR(std::tan(cone.half_angle), sine * std::tan(35 * pi / 180), 1e-12);
      expect_tangent(surface, frame, line);
    }
}

TEST(TangentSurface, OfAConeTurnsByTheAngleBetweenThePlates) {
  const BendFrame frame = frame_at_angle(70.0);
  EXPECT_NEAR(tangent_surface(frame, EdgeKind::facing, {0.2, 8.0}).turned().degrees(), 110.0, 1e-9);
  EXPECT_NEAR(tangent_surface(frame, EdgeKind::averted, {0.2, 8.0}).turned().degrees(), 250.0,
              1e-9);
}

TEST(HalfTurn, IsHalfACylinderBetweenBothPlanes) {
  BendFrame frame{{10, 20, 30}, Vec3::UnitX(), {Vec3::UnitY(), Vec3::UnitY()}, {0, 0, 40}, {}};
  const BendSurface surface = half_turn(frame, {0.0, -25.0});
  EXPECT_NEAR(std::get<Cylinder>(surface.mid).radius, 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(surface.sweep, pi);
  for (int side = 0; side < 2; ++side) {
    const double u = surface.azimuth(side);
    EXPECT_NEAR(std::abs(normal_on(surface.mid, u).z()), 1.0, 1e-12);
    const Vec2 xy = frame.local(side, point_on(surface.mid, {u, 5.0}));
    EXPECT_NEAR(xy.y(), 25.0, 1e-12);
    EXPECT_NEAR(point_on(surface.mid, {u, 5.0}).z(), side == 0 ? 30.0 : 70.0, 1e-12);
  }
  // It bulges beyond the tangent lines.
  EXPECT_NEAR(point_on(surface.mid, {0.5 * pi, 0.0}).y(), 20 + 25 + 20, 1e-12);
}

TEST(BendSurfaceRadius, GrowsAlongACone) {
  const BendSurface cone = tangent_surface(frame_at_angle(90), EdgeKind::facing, {0.2, 0.0});
  EXPECT_NEAR(cone.radius(60.0), 60.0 * cone.tan_half_angle, 1e-12);
  EXPECT_EQ(tangent_surface(frame_at_angle(90), EdgeKind::facing, {0.0, -9.0}).radius(60.0),
            9.0 * std::tan(pi / 4));
}

}  // namespace
}  // namespace planish::test
