#include "body.hpp"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

Body body_around(const TopoDS_Shape& shape) {
  const TopoDS_Solid solid = TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current());
  return Body(std::make_shared<const Body::Shape>(
      Body::Shape{solid, "lid", 3, 6, "1.4301", "#ff0000", 7.9}));
}

gp_Ax2 tilted_axes() { return {gp_Pnt(1200, -700, 300), gp_Dir(1, 2, 2), gp_Dir(2, -1, 0)}; }

TEST(Body, SaysWhatItsFileSays) {
  const Body body = body_around(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  EXPECT_EQ(body.name(), "lid");
  EXPECT_EQ(body.quantity(), 3);
  EXPECT_EQ(body.face_count(), 6);
  EXPECT_EQ(body.material(), "1.4301");
  EXPECT_EQ(body.colour(), "#ff0000");
  EXPECT_EQ(body.density(), 7.9);
}

TEST(Body, HasTheVolumeOfTheSolidWhereverItLies) {
  const gp_Ax2 axes = tilted_axes();
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeBox(axes, 30, 20, 2).Shape()).volume(), 1200, 1e-7);
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeCylinder(axes, 5, 12).Shape()).volume(), 300 * pi, 1e-6);
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeCone(axes, 6, 2, 9).Shape()).volume(),
              pi * 9 * (36 + 12 + 4) / 3, 1e-6);
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeSphere(axes, 7).Shape()).volume(), 4 * pi * 343 / 3,
              1e-6);
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeTorus(axes, 9, 2).Shape()).volume(), 2 * pi * pi * 9 * 4,
              1e-6);
}

TEST(Body, HasAPositiveVolumeInsideOutToo) {
  EXPECT_NEAR(body_around(BRepPrimAPI_MakeBox(30, 20, 2).Shape().Reversed()).volume(), 1200, 1e-7);
}

TEST(Body, HasTheExtentsAlongTheAxesOfItsFile) {
  EXPECT_NEAR((body_around(BRepPrimAPI_MakeBox(gp_Pnt(5, -6, 7), 30, 20, 2).Shape()).size() -
               Vec3(30, 20, 2))
                  .norm(),
              0.0, 1e-5);
  // A disc of radius 5 about a direction n reaches 5 √(1 − nᵢ²) along each axis.
  const Vec3 n = Vec3(1, 2, 2) / 3;
  const Vec3 reach = 12 * n + 10 * (Vec3::Ones() - n.cwiseProduct(n)).cwiseSqrt();
  EXPECT_NEAR(
      (body_around(BRepPrimAPI_MakeCylinder(tilted_axes(), 5, 12).Shape()).size() - reach).norm(),
      0.0, 1e-4);
}

}  // namespace
}  // namespace planish::brep
