#include "general_fit.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using Corners = std::array<std::vector<Vec2>, 2>;

const Corners kApart{{{{100, 20}, {300, 60}}, {{100, 30}, {300, 90}}}};

const BendFrame kRightAngle{
    Vec3::Zero(), Vec3::UnitX(), {Vec3::UnitY(), Vec3::UnitZ()}, Vec3::Zero(), Angle::degrees(90)};

TEST(GeneralLines, RunAlongTheEdgesOfBothSides) {
  const auto lines = general_lines(kApart, EdgeKind::facing, std::nullopt);
  ASSERT_TRUE(lines);
  EXPECT_NEAR(lines->apex, 0.0, 1e-9);
  EXPECT_NEAR(lines->lines[0].slope, 0.2, 1e-12);
  EXPECT_NEAR(lines->lines[1].slope, 0.3, 1e-12);
  EXPECT_NEAR(lines->area, 0.0, 1e-6);
}

TEST(GeneralLines, OfAGivenApexAreTheSteepestThatLeaveThePlatesWhole) {
  // From x = −50 the nearer corners are seen at 20/150 and 30/150, the farther ones higher.
  const auto lines = general_lines(kApart, EdgeKind::facing, -50.0);
  ASSERT_TRUE(lines);
  EXPECT_NEAR(lines->lines[0].slope, 20.0 / 150, 1e-12);
  EXPECT_NEAR(lines->lines[1].slope, 30.0 / 150, 1e-12);
  // Triangles between edge and line: at the far end 60 − 46.67 and 90 − 70 high.
  EXPECT_NEAR(lines->area, 0.5 * 200 * (60 - 350 * 20.0 / 150 + 90 - 350 * 30.0 / 150), 1e-9);
}

TEST(GeneralLines, RefuseWhatNoGeneralBendCanBe) {
  EXPECT_EQ(general_lines(kApart, EdgeKind::averted, std::nullopt).error().where, "/surface");
  const auto within = general_lines(kApart, EdgeKind::facing, 200.0);
  ASSERT_FALSE(within);
  EXPECT_EQ(within.error().code, code::apex_in_span);
  EXPECT_EQ(within.error().where, "/apex");
  const Corners parallel{{{{0, 10}, {100, 10}}, {{0, 10}, {100, 10}}}};
  EXPECT_EQ(general_lines(parallel, EdgeKind::facing, std::nullopt).error().where, "/surface");
}

/// Edges of one slope on both sides: between their far ends runs a quarter of the circle of radius
/// 60 about (300, 60, 60), square to the line of the planes; the apex is the origin.
const Corners kEqual{{{{100, 20}, {300, 60}}, {{100, 20}, {300, 60}}}};

BendSurface cone_over_circle() {
  const auto lines = general_lines(kEqual, EdgeKind::facing, std::nullopt);
  const auto made = general_surface(kRightAngle, *lines, kEqual, std::nullopt, 300.0);
  EXPECT_TRUE(made);
  return *made;
}

/// Smallest radius of curvature of that cone along the circle (Meusnier, Euler).
double tightest_radius() {
  double smallest = 1e300;
  for (int i = 0; i <= 1000; ++i) {
    const double t = 0.5 * std::numbers::pi * i / 1000;
    const Vec3 out(0, -std::cos(t), -std::sin(t)), along(0, std::sin(t), -std::cos(t));
    const Vec3 g = (Vec3(300, 60, 60) + 60 * out).normalized(), n = along.cross(g).normalized();
    const double sine = along.cross(g).norm();
    smallest = std::min(smallest, sine * sine * 60 / std::abs(n.dot(out)));
  }
  return smallest;
}

TEST(GeneralSurface, OfEqualSlopesIsTheConeOverACircle) {
  const BendSurface made = cone_over_circle();
  for (const double u : {0.0, 0.2, 0.5, 1.0})
    for (const double v : {-100.0, 0.0}) {
      const Vec3 p = point_on(made.mid, {u, v});
      EXPECT_NEAR((300 / p.x() * p - Vec3(300, 60, 60)).norm(), 60.0, 1e-6);
    }
  EXPECT_NEAR(made.tightest, tightest_radius(), 1e-9);
}

TEST(GeneralSurface, TouchesBothPlatesAlongTheirLines) {
  const auto lines = general_lines(kApart, EdgeKind::facing, std::nullopt);
  const auto made = general_surface(kRightAngle, *lines, kApart, std::nullopt, 300.0);
  ASSERT_TRUE(made);
  for (int side = 0; side < 2; ++side) {
    const double u = made->azimuth(side);
    const Vec3 n = normal_on(made->mid, u);
    EXPECT_NEAR(n.dot(kRightAngle.d), 0.0, 1e-8);
    EXPECT_NEAR(n.dot(kRightAngle.e[side]), 0.0, 1e-8);
    const Vec2 xy = kRightAngle.local(side, point_on(made->mid, {u, -50.0}));
    EXPECT_NEAR(xy.y(), lines->lines[side].at(xy.x()), 1e-8);
  }
}

/// Where the tangent of a bend's arc at its first end meets the line of the planes.
double meets_at(const BendSurface& made) {
  const SpaceCurvePoint end = made.arc(0.0);
  const Vec3 out = Vec3(0, end.point.y(), end.point.z()).normalized();
  return end.point.x() - end.point.dot(out) / end.derivative.dot(out) * end.derivative.x();
}

TEST(GeneralSurface, HasACircularArcIfItsEndsAreEquallyFarFromAPlaceNearTheirFeet) {
  // Both edges run through the origin: to (300, 60, 0), and to (280, 0, far).
  const auto over = [](double far) {
    const Corners corners{{{{100, 20}, {300, 60}}, {{100, far / 2.8}, {280, far}}}};
    const auto lines = general_lines(corners, EdgeKind::facing, 0.0);
    EXPECT_TRUE(lines);
    return *general_surface(kRightAngle, *lines, corners, std::nullopt, 300.0);
  };
  // (300 - x)² + 60² = (280 - x)² + far², if that lies within half of 290 and twice of it.
  EXPECT_NEAR(meets_at(over(60.0)), 290.0, 1e-6);
  EXPECT_NEAR(meets_at(over(80.0)), (93600.0 - 84800.0) / 40, 1e-6);
  EXPECT_NEAR(meets_at(over(110.0)), 290.0, 1e-6) << "at 77.5 otherwise";
  EXPECT_NEAR(meets_at(over(150.0)), 290.0, 1e-6) << "below the apex otherwise";
}

TEST(GeneralSurface, MeetsAboveTheFootOfItsEndsWhereTheyHaveOneButForRounding) {
  const auto lines = general_lines(kEqual, EdgeKind::facing, 0.0);
  ASSERT_TRUE(lines);
  for (int i = 1; i <= 40; ++i) {
    Corners corners = kEqual;
    corners[1].back() = {300 - 1e-13, 60 - i * 2e-14};
    const auto made = general_surface(kRightAngle, *lines, corners, std::nullopt, 300.0);
    ASSERT_TRUE(made);
    EXPECT_NEAR(meets_at(*made), 300.0, 1e-6) << i;
  }
}

TEST(GeneralSurface, WantsItsTangentPointOnTheLineOfThePlanes) {
  const auto lines = general_lines(kApart, EdgeKind::facing, std::nullopt);
  const auto surface = [&](const Vec3& point) {
    return general_surface(kRightAngle, *lines, kApart, point, 300.0);
  };
  EXPECT_TRUE(surface({280, 0, 0}));
  EXPECT_EQ(surface({280, 1, 0}).error().where, "/tangent_point");
  EXPECT_EQ(surface({0, 0, 0}).error().code, code::no_bend_fits) << "the apex";
}

TEST(OffsetSurface, LiesAtItsDistanceAlongTheNormal) {
  const auto lines = general_lines(kApart, EdgeKind::facing, std::nullopt);
  const auto made = general_surface(kRightAngle, *lines, kApart, std::nullopt, 300.0);
  ASSERT_TRUE(made);
  for (const double offset : {-1.5, 1.5}) {
    const Developable skin = offset_surface(*made, offset);
    for (const double u : {0.0, 0.13, 0.5, 0.77, 1.0})
      for (const double v : {-120.0, 0.0})
        EXPECT_LT((point_on(skin, {u, v}) - point_on(made->mid, {u, v}, offset)).norm(), 1e-7);
  }
}

TEST(MiddleRadius, IsTheSmallestHalfwayBetweenBothBoundaries) {
  const BendSurface made = cone_over_circle();
  const Curve2 low = made.at_level(0.4, 1e-9), high = made.at_level(1.0, 1e-9);
  EXPECT_NEAR(middle_radius(made, low, high), 0.7 * tightest_radius(), 1e-6);
  // Also at an end of the bend, on either side.
  const Curve2 nearer = made.at_level(0.6, 1e-9);
  const Segment up{start_of(nearer), end_of(high)}, down{start_of(high), end_of(nearer)};
  for (const Segment& slanted : {up, down})
    EXPECT_NEAR(middle_radius(made, low, slanted), 0.5 * tightest_radius(), 1e-6);
}

}  // namespace
}  // namespace planish::test
