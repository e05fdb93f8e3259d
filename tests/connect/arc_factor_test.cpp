#include "bend_surface.hpp"

#include <planish/connect/edge_search.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

BendFrame frame_of(double beta) {
  const Angle angle = Angle::degrees(beta);
  return {Vec3::Zero(),
          Vec3::UnitX(),
          {Vec3::UnitY(), Vec3(0, std::cos(angle.radians()), std::sin(angle.radians()))},
          Vec3::Zero(),
          angle};
}

TEST(ArcFactor, OfACylinderIsItsArcOverItsTangentLength) {
  // Radius = tan(β / 2) at the height 1; the arc turns by π − β, averted by the rest of the turn.
  for (const double beta : {30.0, 90.0, 140.0}) {
    const double radius = std::tan(beta * pi / 360), turn = pi - beta * pi / 180;
    EXPECT_NEAR(arc_factor(Angle::degrees(beta), EdgeKind::facing, 0.0), radius * turn, 1e-12);
    EXPECT_NEAR(arc_factor(Angle::degrees(beta), EdgeKind::averted, 0.0), radius * (2 * pi - turn),
                1e-12);
  }
}

TEST(ArcFactor, OfAConeIsTheArcOfTheTangentSurface) {
  for (const double beta : {40.0, 90.0, 150.0})
    for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted})
      for (const double slope : {0.05, 0.3, 1.2}) {
        const auto bend = connect_detail::tangent_surface(frame_of(beta), kind, {slope, 0.0});
        // At a distance of 1 from the apex, along the ruling.
        const double arc = std::sin(std::get<Cone>(bend.mid).half_angle) * bend.sweep;
        const double height = std::sin(std::atan(slope));
        EXPECT_NEAR(arc_factor(Angle::degrees(beta), kind, slope), arc / height, 1e-10);
        EXPECT_EQ(arc_factor(Angle::degrees(beta), kind, -slope),
                  arc_factor(Angle::degrees(beta), kind, slope));
      }
}

TEST(ArcFactor, OfAFlatConeIsNearlyThatOfACylinder) {
  for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted})
    EXPECT_NEAR(arc_factor(Angle::degrees(70), kind, 1e-7),
                arc_factor(Angle::degrees(70), kind, 0.0), 1e-9);
}

}  // namespace
}  // namespace planish::test
