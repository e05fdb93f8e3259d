#include "solid_check.hpp"

#include "step_out.hpp"

#include <planish/brep/codes.hpp>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

SolidCheck check_of(const TopoDS_Shape& shape) {
  return check_step_solid(step_text(shape, "lid").value()).value();
}

TEST(SolidCheck, MeasuresABox) {
  const SolidCheck box = check_of(BRepPrimAPI_MakeBox(gp_Pnt(5, -6, 7), 30, 20, 2).Shape());
  EXPECT_EQ(box.solids, 1);
  EXPECT_EQ(box.shells, 1);
  EXPECT_EQ(box.faces, 6);
  EXPECT_EQ(box.planes, 6);
  EXPECT_EQ(box.free_edges, 0);
  EXPECT_TRUE(box.valid);
  EXPECT_TRUE(box.closed);
  EXPECT_NEAR(box.volume, 1200, 1e-6);
  EXPECT_NEAR(box.area, 2 * (600 + 60 + 40), 1e-6);
  EXPECT_NEAR((box.lo - Vec3(5, -6, 7)).norm(), 0.0, 2e-6);
  EXPECT_NEAR((box.hi - Vec3(35, 14, 9)).norm(), 0.0, 2e-6);
  EXPECT_GT(box.largest_tolerance, 0.0);
  EXPECT_LT(box.largest_tolerance, 1e-5);
  EXPECT_EQ(box.product, "lid");
}

TEST(SolidCheck, CountsSurfacesByTheirKind) {
  const SolidCheck cylinder = check_of(BRepPrimAPI_MakeCylinder(5, 8).Shape());
  EXPECT_EQ(cylinder.cylinders, 1);
  EXPECT_EQ(cylinder.planes, 2);
  EXPECT_TRUE(cylinder.closed) << "its seam is run twice";
  EXPECT_NEAR(cylinder.volume, 200 * pi, 1e-5);
  const SolidCheck cone = check_of(BRepPrimAPI_MakeCone(5, 2, 4).Shape());
  EXPECT_EQ(cone.cones, 1);
  EXPECT_NEAR(cone.area, 25 * pi + 4 * pi + 7 * pi * 5, 1e-5);
  const SolidCheck ball = check_of(BRepPrimAPI_MakeSphere(5).Shape());
  EXPECT_EQ(ball.other_surfaces, 1);
  EXPECT_EQ(ball.planes + ball.cylinders + ball.cones + ball.extrusions + ball.splines, 0);
  EXPECT_TRUE(ball.closed) << "its poles are no edges";
}

TEST(SolidCheck, SeesOpenShells) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  int left = 5;
  for (TopExp_Explorer faces(BRepPrimAPI_MakeBox(30, 20, 2).Shape(), TopAbs_FACE); faces.More();
       faces.Next())
    if (left-- > 0) builder.Add(shell, faces.Current());
  const SolidCheck open = check_of(shell);
  EXPECT_EQ(open.solids, 0);
  EXPECT_EQ(open.shells, 1);
  EXPECT_EQ(open.faces, 5);
  EXPECT_EQ(open.free_edges, 4);
  EXPECT_FALSE(open.closed);
}

TEST(SolidCheck, CountsAllSolids) {
  BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(1, 2, 3).Solid());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(9, 9, 9), 1, 1, 1).Solid());
  const SolidCheck check = check_of(both);
  EXPECT_EQ(check.solids, 2);
  EXPECT_EQ(check.faces, 12);
  EXPECT_NEAR(check.volume, 7, 1e-6);
}

TEST(SolidCheck, RefusesOtherTexts) {
  const auto check = check_step_solid("solid ascii");
  ASSERT_FALSE(check);
  EXPECT_EQ(check.error().code, code::not_step);
}

}  // namespace
}  // namespace planish::brep
