#include "patch_volume.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

double sum_of_patches(const TopoDS_Shape& shape, const Vec3& centre, double error = 1e-8) {
  double sum = 0.0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    sum += patch_volume(TopoDS::Face(faces.Current()), centre, error);
  return sum;
}

gp_Ax2 slanted_axes() { return {gp_Pnt(20, -7, 3), gp_Dir(1, 2, 2), gp_Dir(2, -1, 0)}; }

TEST(PatchVolume, OfAPlaneIsAThirdOfItsAreaTimesItsDistance) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 2).Shape();
  for (TopExp_Explorer faces(box, TopAbs_FACE); faces.More(); faces.Next())
    EXPECT_NEAR(patch_volume(TopoDS::Face(faces.Current()), {15, 10, 1}, 1e-9), 1200 / 6.0, 1e-9);
  double at_corner = 0.0;
  for (TopExp_Explorer faces(box, TopAbs_FACE); faces.More(); faces.Next()) {
    const double part = patch_volume(TopoDS::Face(faces.Current()), Vec3::Zero(), 1e-9);
    EXPECT_TRUE(std::abs(part) < 1e-9 || std::abs(part - 400) < 1e-9) << part;
    at_corner += part;
  }
  EXPECT_NEAR(at_corner, 1200, 1e-9);
}

TEST(PatchArea, OfRoundFacesIsThatOfClosedForms) {
  const auto area_of = [](const TopoDS_Shape& shape) {
    double sum = 0.0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
      sum += patch_area(TopoDS::Face(faces.Current()), 1e-8);
    return sum;
  };
  EXPECT_NEAR(area_of(BRepPrimAPI_MakeSphere(7).Shape()), 4 * pi * 49, 1e-6);
  EXPECT_NEAR(area_of(BRepPrimAPI_MakeTorus(9, 2).Shape()), 4 * pi * pi * 18, 1e-6);
  EXPECT_NEAR(area_of(BRepPrimAPI_MakeBox(30, 20, 2).Shape().Reversed()), 1400, 1e-6);
}

TEST(PatchVolume, TurnsItsSignWithTheFace) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(7).Shape();
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(ball, TopAbs_FACE).Current());
  const double whole = patch_volume(face, Vec3::Zero(), 1e-9);
  EXPECT_NEAR(whole, 4 * pi * 343 / 3, 1e-6);
  EXPECT_NEAR(patch_volume(TopoDS::Face(face.Reversed()), Vec3::Zero(), 1e-9), -whole, 1e-9);
}

TEST(PatchVolume, AddsUpToTheVolumeFromAnyCentre) {
  const gp_Ax2 axes = slanted_axes();
  const std::vector<std::pair<TopoDS_Shape, double>> solids{
      {BRepPrimAPI_MakeCylinder(axes, 5, 12).Shape(), 300 * pi},
      {BRepPrimAPI_MakeCone(axes, 6, 2, 9).Shape(), pi * 9 * 52 / 3},
      {BRepPrimAPI_MakeCone(axes, 6, 0, 9).Shape(), pi * 108},
      {BRepPrimAPI_MakeSphere(axes, 7).Shape(), 4 * pi * 343 / 3},
      {BRepPrimAPI_MakeTorus(axes, 9, 2).Shape(), 72 * pi * pi},
      {BRepPrimAPI_MakeCylinder(axes, 5, 12, 1.2).Shape(), 0.6 * 25 * 12}};
  for (const auto& [solid, volume] : solids)
    for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(25, 5, 10)}) {
      EXPECT_NEAR(sum_of_patches(solid, centre), volume, 1e-5);
      const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(solid, true).Shape();
      // Across a span of a rational spline one Gauss rule has to do.
      EXPECT_NEAR(sum_of_patches(splines, centre), volume, 4e-6 * volume) << "as splines";
    }
}

TEST(PatchVolume, TakesOffTheLoopsInside) {
  const gp_Ax2 axis(gp_Pnt(10, 10, -1), gp::DZ());
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(30, 20, 2).Shape(),
                                               BRepPrimAPI_MakeCylinder(axis, 4, 5).Shape());
  EXPECT_NEAR(sum_of_patches(drilled, {1, 2, 3}), 1200 - 32 * pi, 1e-6);
  // A hole across a cylinder: borders that cross its parameters anywhere. Two cylinders of equal
  // radius have 16 r³/3 in common.
  const TopoDS_Shape crossed = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -20), gp::DZ()), 5, 40).Shape(),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-20, 0, 0), gp::DX()), 5, 40).Shape());
  EXPECT_NEAR(sum_of_patches(crossed, Vec3::Zero(), 1e-6), 1000 * pi - 16 * 125 / 3.0, 1e-2);
}

}  // namespace
}  // namespace planish::brep
