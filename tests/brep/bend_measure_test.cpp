#include "bend_measure.hpp"

#include <planish/sheet/builder.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;
constexpr double kThickness = 2.0;

/// The bend of one face, a rectangle in its (u, v), of a sheet 2 mm thick.
Bend measured(const Developable& surface, int sense, const Vec2& lo, const Vec2& hi) {
  SheetBuilder builder(kThickness);
  const BendId bend = builder.add_bend();
  Face face;
  face.surface = surface;
  face.sense = sense;
  face.part_of = bend;
  const Vec2 corners[] = {lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}};
  BorderLoop& loop = face.loops.emplace_back();
  for (int i = 0; i < 4; ++i)
    loop.emplace_back().curve = Segment{corners[i], corners[(i + 1) % 4]};
  builder.add_face(std::move(face));
  return measured_bend(builder.sheet(), bend);
}

TEST(MeasuredBend, OfACylinderTakesTheThicknessOffTheOutside) {
  const Bend bend = measured(Cylinder{Frame{}, 5}, 1, {0.3, 0}, {0.3 + pi / 2, 40});
  EXPECT_EQ(bend.kind, BendKind::cylinder);
  EXPECT_NEAR(bend.angle.radians(), pi / 2, 1e-12);
  EXPECT_NEAR(bend.inside_radius, 3.0, 1e-12);
  EXPECT_FALSE(bend.reference_inside);
}

TEST(MeasuredBend, OfACylinderSeenFromInsideHasItsRadius) {
  const Bend bend = measured(Cylinder{Frame{}, 3}, -1, {0, 0}, {3.5, 40});
  EXPECT_NEAR(bend.angle.radians(), 3.5, 1e-12) << "more than half a turn";
  EXPECT_NEAR(bend.inside_radius, 3.0, 1e-12);
  EXPECT_TRUE(bend.reference_inside);
}

TEST(MeasuredBend, OfAConeIsTheAngleBetweenItsEnds) {
  const double half_angle = 0.4;
  const double azimuth = 1.2;
  const Bend bend = measured(Cone{Frame{}, half_angle}, -1, {0, 20}, {azimuth, 60});
  const auto normal = [&](double u) {
    return Vec3(std::cos(half_angle) * std::cos(u), std::cos(half_angle) * std::sin(u),
                -std::sin(half_angle));
  };
  EXPECT_EQ(bend.kind, BendKind::cone);
  EXPECT_NEAR(bend.angle.radians(), std::acos(normal(0).dot(normal(azimuth))), 1e-12);
  EXPECT_NEAR(bend.inside_radius, 40 * std::tan(half_angle), 1e-12) << "at mid-length";
}

TEST(MeasuredBend, OfAConePastHalfATurnGoesTheLongWay) {
  const Bend bend = measured(Cone{Frame{}, 0.4}, 1, {0, 20}, {5.0, 60});
  const double c = std::cos(0.4), s = std::sin(0.4);
  EXPECT_NEAR(bend.angle.radians(), 2 * pi - std::acos(c * c * std::cos(5.0) + s * s), 1e-12);
  EXPECT_NEAR(bend.inside_radius, 40 * std::tan(0.4) - kThickness, 1e-12);
}

/// A circular cylinder about z, of this radius, given by knots of its directrix. Between knots h
/// apart the radius of curvature is off by h²/12 of itself.
Ruled rolled(double radius, double turn) {
  Ruled ruled;
  constexpr int kKnots = 512;
  for (int i = 0; i <= kKnots; ++i) {
    const double u = turn * i / kKnots;
    const Vec3 radial(std::cos(u), std::sin(u), 0), along(-std::sin(u), std::cos(u), 0);
    ruled.knots.push_back({u, radius * radial, radius * along, Vec3::UnitZ(), Vec3::Zero()});
  }
  return ruled;
}

TEST(MeasuredBend, OfAGeneralSurfaceFindsTurnAndRadius) {
  const Bend outside = measured(rolled(12, 1.1), 1, {0, 0}, {1.1, 30});
  EXPECT_EQ(outside.kind, BendKind::general);
  EXPECT_NEAR(outside.angle.radians(), 1.1, 1e-6);
  EXPECT_NEAR(outside.inside_radius, 10.0, 1e-4);
  EXPECT_FALSE(outside.reference_inside);
  const Bend inside = measured(rolled(12, 1.1), -1, {0, 0}, {1.1, 30});
  EXPECT_NEAR(inside.inside_radius, 12.0, 1e-4);
  EXPECT_TRUE(inside.reference_inside);
}

/// A cone given by knots, its ruling v = 0 at the distance 30 from the apex.
TEST(MeasuredBend, OfAGeneralSurfaceMeasuresAcrossItsRulings) {
  const Cone cone{Frame{}, 0.5};
  Ruled ruled;
  for (int i = 0; i <= 512; ++i) {
    const double u = 1.0 + 1.1 * i / 512, c = std::cos(u), s = std::sin(u);
    const double sine = std::sin(0.5), cosine = std::cos(0.5);
    const Vec3 g(sine * c, sine * s, cosine), g_prime(-sine * s, sine * c, 0);
    ruled.knots.push_back({u, 30 * g, 30 * g_prime, g, g_prime});
  }
  const Bend bend = measured(ruled, 1, {1.0, 0}, {2.1, 20});
  EXPECT_NEAR(bend.inside_radius, 40 * std::tan(0.5) - kThickness, 1e-3) << "40 from the apex";
  const Bend plain = measured(cone, 1, {1.0, 30}, {2.1, 50});
  EXPECT_NEAR(bend.angle.radians(), plain.angle.radians(), 1e-5);
}

TEST(MeasuredBend, OfAGeneralSurfacePastHalfATurnGoesTheLongWay) {
  EXPECT_NEAR(measured(rolled(12, 4.0), 1, {0, 0}, {4.0, 30}).angle.radians(), 4.0, 1e-6);
}

TEST(MeasuredBend, EndsAtTheTangentLineWhereItsOwnFaceDoes) {
  // A quarter turn from a flange on, cut along an edge below the skin that reaches 0.2 beyond it.
  SheetBuilder builder(kThickness);
  const FlangeId flange = builder.add_flange();
  Face plane;
  plane.surface = Frame{};
  plane.part_of = flange;
  const Vec2 square[] = {{0, 0}, {10, 0}, {10, 40}, {0, 40}};
  BorderLoop& outline = plane.loops.emplace_back();
  for (int i = 0; i < 4; ++i)
    outline.emplace_back().curve = Segment{square[i], square[(i + 1) % 4]};
  const FaceId first = builder.add_face(std::move(plane));
  const BendId bend = builder.add_bend();
  Face face;
  face.surface = Cylinder{Frame{}, 5};
  face.part_of = bend;
  const Vec2 corners[] = {{pi / 2, 0}, {pi / 2, 40}, {0, 40}, {0, 30}, {-0.2, 20}, {0, 10}, {0, 0}};
  BorderLoop& loop = face.loops.emplace_back();
  for (int i = 0; i < 7; ++i)
    loop.emplace_back().curve = Segment{corners[i], corners[(i + 1) % 7]};
  const FaceId second = builder.add_face(std::move(face));
  builder.join({first, 0, 1}, {second, 0, 2});
  const auto angle = [&](const Interval& own) {
    return measured_bend(builder.sheet(), bend, own).angle.radians();
  };
  EXPECT_NEAR(angle({0, pi / 2}), pi / 2, 1e-12);
  EXPECT_NEAR(angle({-0.2, pi / 2}), pi / 2 + 0.2, 1e-12) << "it goes on beside the flange";
}

}  // namespace
}  // namespace planish::brep
