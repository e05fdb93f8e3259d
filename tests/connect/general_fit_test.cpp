#include "general_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_EQ(within.error().code, ErrorCode::apex_in_span);
  EXPECT_EQ(within.error().where, "/apex");
  const Corners parallel{{{{0, 10}, {100, 10}}, {{0, 10}, {100, 10}}}};
  EXPECT_EQ(general_lines(parallel, EdgeKind::facing, std::nullopt).error().where, "/surface");
}

TEST(GeneralSurface, OfEqualSlopesIsTheRightCone) {
  const Corners corners{{{{100, 20}, {300, 60}}, {{100, 20}, {300, 60}}}};
  const auto lines = general_lines(corners, EdgeKind::facing, std::nullopt);
  const auto made = general_surface(kRightAngle, *lines, corners, std::nullopt, 300.0);
  ASSERT_TRUE(made);
  const BendSurface right = tangent_surface(kRightAngle, EdgeKind::facing, {0.2, 0.0});
  const Cone& cone = std::get<Cone>(right.mid);
  for (const double u : {0.0, 0.2, 0.5, 1.0})
    for (const double v : {-100.0, 0.0}) {
      const Vec3 arm = point_on(made->mid, {u, v}) - cone.frame.origin;
      EXPECT_NEAR(std::acos(arm.normalized().dot(cone.frame.z)), cone.half_angle, 1e-8);
    }
  EXPECT_NEAR(made->tightest / std::hypot(300, 60), right.tan_half_angle, 1e-3);
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

TEST(GeneralSurface, WantsItsTangentPointOnTheLineOfThePlanes) {
  const auto lines = general_lines(kApart, EdgeKind::facing, std::nullopt);
  const auto surface = [&](const Vec3& point) {
    return general_surface(kRightAngle, *lines, kApart, point, 300.0);
  };
  EXPECT_TRUE(surface({280, 0, 0}));
  EXPECT_EQ(surface({280, 1, 0}).error().where, "/tangent_point");
  EXPECT_EQ(surface({0, 0, 0}).error().code, ErrorCode::no_bend_fits) << "the apex";
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

TEST(MiddleRadius, IsThatOfARightConeBetweenTwoCircles) {
  const Corners corners{{{{100, 20}, {300, 60}}, {{100, 20}, {300, 60}}}};
  const auto lines = general_lines(corners, EdgeKind::facing, std::nullopt);
  const auto made = general_surface(kRightAngle, *lines, corners, std::nullopt, 300.0);
  ASSERT_TRUE(made);
  const double far = std::hypot(300, 60);
  const Curve2 low = made->at_level(0.4, 1e-9), high = made->at_level(1.0, 1e-9);
  const double tangent = tangent_surface(kRightAngle, EdgeKind::facing, {0.2, 0.0}).tan_half_angle;
  EXPECT_NEAR(middle_radius(*made, low, high), 0.7 * far * tangent, 1e-6);
}

}  // namespace
}  // namespace planish::test
