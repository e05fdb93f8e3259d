#include "sheet_corners.hpp"

#include "support/error_data.hpp"
#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using planish::test::Crease;
using planish::test::Straight;

Sheet folded_sharply(double degrees, BendDirection direction, double thickness = 2) {
  return planish::test::strip(
      {Straight{30}, Crease{Angle::degrees(degrees), direction}, Straight{20}}, 25, thickness);
}

TEST(SheetCorners, AreUnitedByJoints) {
  for (const auto& [sheet, count] : {std::pair{planish::test::l_bracket(), 8},
                                     {planish::test::u_channel(), 12},
                                     {planish::test::box(), 12 + 4 * (2 + 2)},
                                     {folded_sharply(60, BendDirection::up), 6}}) {
    const SheetCorners corners(sheet);
    EXPECT_EQ(corners.count(), count);
    for (const BorderId border : corners.topology().borders())
      EXPECT_EQ(corners.at_end(border), corners.at_start(corners.topology().next(border)));
  }
}

TEST(SheetCorners, LetOneBorderOfEachJointLead) {
  const Sheet sheet = planish::test::u_channel();
  const SheetCorners corners(sheet);
  for (const BorderId border : corners.topology().borders()) {
    const auto twin = corners.topology().twin(border);
    if (!twin) {
      EXPECT_TRUE(corners.leads(border));
      continue;
    }
    EXPECT_NE(corners.leads(border), corners.leads(*twin));
    EXPECT_EQ(corners.leader(border), corners.leader(*twin));
    EXPECT_EQ(corners.at_start(border), corners.at_end(*twin));
    EXPECT_EQ(corners.at_end(border), corners.at_start(*twin));
  }
  for (const Joint& joint : sheet.joints)
    EXPECT_TRUE(corners.leads(corners.topology().id_of(joint.a)));
}

TEST(SheetCorners, AreSharpAtTheEndsOfSharpJointsOnly) {
  const SheetCorners smooth(planish::test::l_bracket());
  for (int c = 0; c < smooth.count(); ++c)
    EXPECT_FALSE(smooth.is_sharp(c));
  const SheetCorners folded(folded_sharply(60, BendDirection::up));
  int sharp = 0;
  for (int c = 0; c < folded.count(); ++c)
    sharp += folded.is_sharp(c);
  EXPECT_EQ(sharp, 2);
}

TEST(CornerPoints, LieTheThicknessApart) {
  const Sheet sheet = planish::test::l_bracket();
  const SheetCorners corners(sheet);
  const auto points = corner_points(sheet, corners);
  ASSERT_TRUE(points);
  for (const BorderId border : corners.topology().borders()) {
    const BorderRef& ref = corners.topology()[border];
    const Vec2 uv = start_of(sheet[ref].curve);
    const CornerPoints& at = (*points)[corners.at_start(border)];
    EXPECT_NEAR((at.reference - skin_point(sheet[ref.face], uv)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((at.other - at.reference + 2 * outward_normal(sheet[ref.face], uv)).norm(), 0.0,
                1e-9);
  }
}

TEST(CornerPoints, AreMitredAtSharpFolds) {
  for (const double degrees : {25.0, 60.0, 120.0})
    for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
      const Sheet sheet = folded_sharply(degrees, direction);
      const SheetCorners corners(sheet);
      const auto points = corner_points(sheet, corners);
      ASSERT_TRUE(points);
      for (int c = 0; c < corners.count(); ++c) {
        const Vec3 step = (*points)[c].other - (*points)[c].reference;
        const double expected = corners.is_sharp(c) ? 2 / std::cos(degrees / 360 * std::numbers::pi)
                                                    : 2;
        EXPECT_NEAR(step.norm(), expected, 1e-9);
      }
      // The mitre lies the thickness below both planes.
      for (const BorderId border : corners.topology().borders()) {
        const BorderRef& ref = corners.topology()[border];
        const Vec3 normal = outward_normal(sheet[ref.face], start_of(sheet[ref].curve));
        const CornerPoints& at = (*points)[corners.at_start(border)];
        EXPECT_NEAR((at.other - at.reference).dot(normal), -2, 1e-9);
      }
    }
}

TEST(CornerPoints, KeepTheirDepthsBesideASurfaceBetweenTheSkins) {
  Sheet sheet = folded_sharply(60, BendDirection::up);
  const auto whole = corner_points(sheet, SheetCorners(sheet)).value();
  sheet.reference_depth = 0.5;
  const SheetCorners corners(sheet);
  const auto points = corner_points(sheet, corners).value();
  // The reference surface is where the skin was: skins lie 0.5 above and 1.5 below it.
  for (int c = 0; c < corners.count(); ++c) {
    const Vec3 step = whole[c].other - whole[c].reference;
    EXPECT_NEAR((points[c].reference - (whole[c].reference - 0.25 * step)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((points[c].other - (whole[c].reference + 0.75 * step)).norm(), 0.0, 1e-9);
  }
}

TEST(CornerPoints, RefuseAMitreOfTenThicknesses) {
  // 1 / cos(α/2) is 10 at 168.52°.
  for (const auto& [degrees, fits] : {std::pair{168.0, true}, {169.0, false}}) {
    const Sheet sheet = folded_sharply(degrees, BendDirection::up);
    const auto points = corner_points(sheet, SheetCorners(sheet));
    EXPECT_EQ(points.has_value(), fits);
    if (points) continue;
    EXPECT_EQ(points.error().code, code::unsupported_shape);
    EXPECT_NEAR(planish::test::at_in(points.error(), PlaceKind::point).at(0), 30, 1e-9);
  }
}

}  // namespace
}  // namespace planish::brep
