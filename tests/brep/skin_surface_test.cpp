#include "border_curve.hpp"
#include "kernel_points.hpp"
#include "ruling_range.hpp"
#include "support/sheets.hpp"

#include <Geom2d_Line.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace planish::brep {
namespace {

using planish::test::as_ruled;
using planish::test::Straight;
using planish::test::strip;
using planish::test::Turn;

/// Every face of the sheet, at several depths: what is carried to the kernel's surface lies where
/// the face has it, and the surface's normal is that of the face's.
void expect_skins(const Sheet& sheet, double accuracy) {
  for (const Face& face : sheet.faces)
    for (const double depth : {0.0, sheet.thickness, -0.3}) {
      const SkinSurface skin = skin_surface(face, depth, 1e-7);
      const Box2 box = parameter_box(face);
      for (const BorderLoop& loop : face.loops)
        for (const Border& border : loop) {
          const BorderCurve curve = border_curve(face, border.curve, 1e-6);
          const auto carried = skin.carried(curve.uv, curve.length);
          for (const double share : {0.0, 0.35, 1.0}) {
            const double s = share * curve.length;
            const gp_Pnt2d uv = carried->Value(s);
            EXPECT_NEAR(uv.X(), curve.at(s).x(), 1e-9) << "u is the same";
            gp_Pnt p;
            gp_Vec du, dv;
            skin.surface->D1(uv.X(), uv.Y(), p, du, dv);
            EXPECT_NEAR((vector_of(p) - point_below(face, curve.at(s), depth)).norm(), 0.0,
                        accuracy);
            const Vec3 outward = face.sense * vector_of(du.Crossed(dv)).normalized();
            EXPECT_NEAR((outward - outward_normal(face, curve.at(s))).norm(), 0.0, 1e-3);
          }
        }
      EXPECT_FALSE(box.empty());
    }
}

TEST(SkinSurface, OfPlanesCylindersAndConesIsExact) {
  for (const Sheet& sheet :
       {planish::test::l_bracket(), planish::test::l_bracket_down(), planish::test::cone_joined(),
        planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5)})
    expect_skins(sheet, 1e-9);
}

TEST(SkinSurface, OfRuledFacesIsWithinTheTolerance) {
  expect_skins(as_ruled(planish::test::l_bracket(), Angle::degrees(10)), 1e-5);
  expect_skins(as_ruled(planish::test::cone_joined(), Angle::degrees(10)), 1e-5);
  expect_skins(planish::test::lofted_corner(), 1e-5);
}

TEST(SkinSurface, IsTheKernelsOwnKind) {
  const Sheet bracket = planish::test::l_bracket();  // inside radius 3, thickness 2
  const Face& bend = bracket[bracket.bends.front().faces.front()];
  const auto radius = [&](double depth) {
    return Handle(Geom_CylindricalSurface)::DownCast(skin_surface(bend, depth, 1e-7).surface)
        ->Radius();
  };
  EXPECT_NEAR(radius(0), 3, 1e-12);
  EXPECT_NEAR(radius(2), 5, 1e-12);
  EXPECT_FALSE(Handle(Geom_Plane)::DownCast(
                   skin_surface(bracket[bracket.flanges.front().faces.front()], 1, 1e-7).surface)
                   .IsNull());
  const Sheet cone = planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5);
  const auto kernel = Handle(Geom_ConicalSurface)::DownCast(
      skin_surface(cone.faces.front(), 0.5, 1e-7).surface);
  EXPECT_NEAR(kernel->SemiAngle(), std::atan2(20, 50), 1e-12);
  EXPECT_NEAR(kernel->RefRadius(), 20 - 0.5 * std::cos(std::atan2(20, 50)), 1e-9);
}

TEST(SmallestRadius, IsThatOfTheSkinAtItsDepth) {
  const auto of_bend = [](const Sheet& sheet, double depth) {
    return smallest_radius(sheet[sheet.bends.front().faces.front()], depth);
  };
  const Sheet up = planish::test::l_bracket(), down = planish::test::l_bracket_down();
  EXPECT_NEAR(of_bend(up, 0), 3, 1e-12);
  EXPECT_NEAR(of_bend(up, 2), 5, 1e-12);
  EXPECT_NEAR(of_bend(down, 0), 5, 1e-12);
  EXPECT_NEAR(of_bend(down, 2), 3, 1e-12);
  EXPECT_TRUE(std::isinf(smallest_radius(up[up.flanges.front().faces.front()], 2)));
  // Of a cone across the ruling at its nearer end: the radius there over the cosine.
  const Sheet cone = planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5);
  const double cosine = std::cos(std::atan2(20, 50));
  EXPECT_NEAR(of_bend(cone, 0), 20 / cosine, 1e-9);
  EXPECT_NEAR(of_bend(cone, 1.5), 20 / cosine - 1.5, 1e-9);
}

TEST(SmallestRadius, OfARuledFaceIsThatOfWhatItWasMadeFrom) {
  const Sheet cone = planish::test::truncated_cone(20, 40, 50, Angle::degrees(300), 1.5);
  const Sheet ruled = as_ruled(cone, Angle::degrees(1));
  for (const double depth : {0.0, 1.5})
    EXPECT_NEAR(smallest_radius(ruled.faces.front(), depth),
                smallest_radius(cone.faces.front(), depth), 1e-3);
  // Where the skin curves away from the material no offset folds over.
  const Sheet bracket = as_ruled(planish::test::l_bracket(), Angle::degrees(3));
  EXPECT_TRUE(std::isinf(smallest_radius(bracket[bracket.bends.front().faces.front()], 2)));
}

}  // namespace
}  // namespace planish::brep
