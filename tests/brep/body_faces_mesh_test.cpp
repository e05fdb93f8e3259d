#include "body.hpp"
#include "support/error_data.hpp"
#include "support/sheets.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

Body body_to_mesh(const TopoDS_Shape& shape) {
  const TopoDS_Solid solid = TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current());
  return Body(std::make_shared<const Body::Shape>(Body::Shape{solid, "part", 1, 0}));
}

/// By the divergence theorem, and of one face alone its area vector.
double enclosed_by(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  return sum;
}

Vec3 area_vector(const MeshOfFaces& surface, int face) {
  Vec3 sum = Vec3::Zero();
  for (size_t i = 0; i < surface.face.size(); ++i) {
    if (surface.face[i] != face) continue;
    const auto& t = surface.mesh.triangles[i];
    const Vec3& a = surface.mesh.points[t[0]];
    sum += (surface.mesh.points[t[1]] - a).cross(surface.mesh.points[t[2]] - a) / 2;
  }
  return sum;
}

TEST(BodyFacesMesh, GivesEachFaceOfABoxTwoTrianglesAndPointsOfItsOwn) {
  const auto surface = body_faces_mesh(
      body_to_mesh(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 30, 20, 2).Shape()), 0.1);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->mesh.points.size(), 24u);
  ASSERT_EQ(surface->mesh.triangles.size(), 12u);
  EXPECT_EQ(surface->face, (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
  EXPECT_NEAR(enclosed_by(surface->mesh), 1200, 1e-9);
  std::vector<Vec3> corners;
  for (const Vec3& p : surface->mesh.points)
    if (std::ranges::none_of(corners, [&](const Vec3& q) { return (p - q).norm() < 1e-9; }))
      corners.push_back(p);
  EXPECT_EQ(corners.size(), 8u);
}

TEST(BodyFacesMesh, LooksOutwardsOnEveryFaceOfAPlacedSolid) {
  gp_Trsf motion;
  motion.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), pi / 2);
  motion.SetTranslationPart(gp_Vec(100, 50, -20));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 2).Shape().Moved(TopLoc_Location(motion));
  const auto surface = body_faces_mesh(body_to_mesh(box), 0.1);
  ASSERT_TRUE(surface);
  const Vec3 middle = Vec3(100 - 10, 50 + 15, -20 + 1);
  for (int face = 0; face < 6; ++face) {
    const Vec3 outward = area_vector(*surface, face);
    for (size_t i = 0; i < surface->face.size(); ++i) {
      if (surface->face[i] != face) continue;
      const Vec3& p = surface->mesh.points[surface->mesh.triangles[i][0]];
      const double depth = (p - middle).dot(outward.normalized());
      EXPECT_NEAR(2 * depth * outward.norm(), 1200, 1e-6) << "its distance times its area";
    }
  }
}

TEST(BodyFacesMesh, StaysWithinTheChordOfACylinder) {
  for (const double chord : {0.5, 0.02}) {
    const auto surface = body_faces_mesh(body_to_mesh(BRepPrimAPI_MakeCylinder(10, 20).Shape()),
                                         chord);
    ASSERT_TRUE(surface);
    const double missing = 100 * pi * 20 - enclosed_by(surface->mesh);
    EXPECT_GT(missing, 0.0);
    EXPECT_LT(missing, 2 * pi * 10 * 20 * chord);
    for (const Vec3& p : surface->mesh.points)
      EXPECT_TRUE(std::abs(std::hypot(p.x(), p.y()) - 10) < 1e-6 || std::abs(p.z()) < 1e-9 ||
                  std::abs(p.z() - 20) < 1e-9);
  }
}

TEST(BodyFacesMesh, NeedsFewTrianglesBetweenRulings) {
  for (const Sheet& sheet :
       {planish::test::cone_joined(), planish::test::lofted_corner(),
        planish::test::as_ruled(planish::test::truncated_cone(30, 60, 80, Angle::degrees(300), 2),
                                Angle::degrees(3)),
        planish::test::as_ruled(planish::test::hole_in_bend(6, 0.44), Angle::degrees(3))}) {
    const auto body = folded_body(sheet, "part");
    ASSERT_TRUE(body) << body.error().message;
    constexpr double kChord = 0.01;
    const auto surface = body_faces_mesh(*body, kChord);
    ASSERT_TRUE(surface) << surface.error().message;
    double area = 0.0;
    for (const auto& t : surface->mesh.triangles) {
      const Vec3& a = surface->mesh.points[t[0]];
      area += (surface->mesh.points[t[1]] - a).cross(surface->mesh.points[t[2]] - a).norm() / 2;
    }
    EXPECT_NEAR(enclosed_by(surface->mesh), body->volume(), kChord * area);
    EXPECT_LT(surface->mesh.triangles.size(), 5000u);
  }
}

TEST(BodyFacesMesh, RefusesASolidWhoseFacesDoNotClose) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid open;
  builder.MakeShell(shell);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 2).Shape();
  for (TopExp_Explorer faces(box, TopAbs_FACE); faces.More(); faces.Next())
    builder.Add(shell, faces.Current());
  TopExp_Explorer first(box, TopAbs_FACE);  // at x = 0: 20 × 2
  builder.Remove(shell, first.Current());
  builder.MakeSolid(open);
  builder.Add(open, shell);
  const auto surface = body_faces_mesh(body_to_mesh(open), 0.1);
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().code, code::internal);
  EXPECT_NEAR(planish::test::number_in(surface.error(), "area"), 40, 1e-9);
}

TEST(BodyFacesMesh, RefusesAChordThatIsNotPositive) {
  const Body body = body_to_mesh(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  for (const double chord : {0.0, -1.0, std::nan("")}) {
    const auto surface = body_faces_mesh(body, chord);
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, code::bad_option);
  }
}

}  // namespace
}  // namespace planish::brep
