#include "surface_reader.hpp"

#include "kernel_points.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

gp_Ax2 leaning_axes() { return {gp_Pnt(20, -7, 3), gp_Dir(1, 2, 2), gp_Dir(2, -1, 0)}; }

std::vector<TopoDS_Face> all_faces(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
    faces.push_back(TopoDS::Face(at.Current()));
  return faces;
}

/// Points inside a face, and its outward normals there, as the kernel has them.
template <typename Visit>
void visit_points(const TopoDS_Face& face, const Visit& visit) {
  const BRepGProp_Face kernel(face);
  double u0, u1, v0, v1;
  kernel.Bounds(u0, u1, v0, v1);
  for (const double a : {0.13, 0.5, 0.81})
    for (const double b : {0.21, 0.5, 0.77}) {
      gp_Pnt p;
      gp_Vec n;
      kernel.Normal(std::lerp(u0, u1, a), std::lerp(v0, v1, b), p, n);
      visit(vector_of(p), vector_of(n).normalized());
    }
}

/// The surface that was read has the face's points and its outward normals.
void expect_the_face(const TopoDS_Face& face, double accuracy) {
  const SolidFace read = read_surface(face, 0.01);
  visit_points(face, [&](const Vec3& p, const Vec3& n) {
    if (const auto* plane = std::get_if<Frame>(&read.surface)) {
      EXPECT_NEAR(plane->local(p).z(), 0.0, accuracy);
      EXPECT_NEAR((plane->z - n).norm(), 0.0, 1e-6);
      return;
    }
    const auto* surface = std::get_if<Developable>(&read.surface);
    ASSERT_NE(surface, nullptr);
    const Vec2 uv = parameters_of(*surface, p, 0.0);
    EXPECT_NEAR((point_on(*surface, uv) - p).norm(), 0.0, accuracy);
    EXPECT_NEAR((read.sense * normal_on(*surface, uv.x()) - n).norm(), 0.0, 1e-4);
  });
}

TEST(ReadSurface, KeepsPlanesCylindersAndConesWithTheirOutside) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)));
  const gp_Ax2 axes = leaning_axes();
  for (const TopoDS_Shape& solid :
       {BRepPrimAPI_MakeBox(axes, 30, 20, 2).Shape(), BRepPrimAPI_MakeCylinder(axes, 5, 12).Shape(),
        BRepPrimAPI_MakeCylinder(axes, 5, 12, 1.2).Shape(),
        BRepPrimAPI_MakeCone(axes, 6, 2, 9).Shape(), BRepPrimAPI_MakeCone(axes, 2, 6, 9).Shape(),
        BRepPrimAPI_MakeCone(axes, 6, 0, 9).Shape()})
    for (const TopoDS_Shape& shape :
         {solid, solid.Reversed(), BRepBuilderAPI_Transform(solid, mirror, true).Shape(),
          BRepBuilderAPI_Transform(solid, mirror, false).Shape()})
      for (const TopoDS_Face& face : all_faces(shape)) {
        const auto kind = BRepAdaptor_Surface(face).GetType();
        const SolidFace read = read_surface(face, 0.01);
        EXPECT_EQ(std::holds_alternative<Frame>(read.surface), kind == GeomAbs_Plane);
        EXPECT_EQ(read.fitted, 0.0);
        if (kind != GeomAbs_Plane) {
          EXPECT_EQ(std::holds_alternative<Cone>(std::get<Developable>(read.surface)),
                    kind == GeomAbs_Cone);
        }
        expect_the_face(face, 1e-9);
      }
}

TEST(ReadSurface, FindsThemInSplines) {
  const gp_Ax2 axes = leaning_axes();
  for (const TopoDS_Shape& solid : {BRepPrimAPI_MakeBox(axes, 30, 20, 2).Shape(),
                                    BRepPrimAPI_MakeCylinder(axes, 5, 12, 1.2).Shape(),
                                    BRepPrimAPI_MakeCone(axes, 6, 2, 9).Shape()})
    for (const TopoDS_Shape& shape : {solid, solid.Reversed()}) {
      const auto plain = all_faces(shape);
      const auto splines = all_faces(BRepBuilderAPI_NurbsConvert(shape, true).Shape());
      ASSERT_EQ(plain.size(), splines.size());
      for (size_t i = 0; i < plain.size(); ++i) {
        const SolidFace expected = read_surface(plain[i], 0.01);
        const SolidFace read = read_surface(splines[i], 0.01);
        EXPECT_EQ(read.surface.index(), expected.surface.index());
        EXPECT_LT(read.fitted, 1e-6);
        expect_the_face(splines[i], 1e-6);
      }
    }
}

/// The wall over half an ellipse, extruded along its axis.
TopoDS_Face elliptic_wall(double a, double b) {
  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(leaning_axes(), a, b);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(ellipse, 0.2, 2.9);
  return TopoDS::Face(BRepPrimAPI_MakePrism(edge, gp_Vec(leaning_axes().Direction()) * 30).Shape());
}

TEST(ReadSurface, FindsTheRulingsOfAnExtrudedEllipse) {
  for (const bool turned : {false, true}) {
    TopoDS_Face wall = elliptic_wall(20, 12);
    if (turned) wall.Reverse();
    for (const TopoDS_Face& face :
         {wall, TopoDS::Face(BRepBuilderAPI_NurbsConvert(wall, true).Shape())}) {
      const SolidFace read = read_surface(face, 0.01);
      ASSERT_TRUE(std::holds_alternative<Developable>(read.surface));
      const auto* ruled = std::get_if<Ruled>(&std::get<Developable>(read.surface));
      ASSERT_NE(ruled, nullptr);
      for (const Ruled::Knot& knot : ruled->knots)
        EXPECT_NEAR(std::abs(knot.g.dot(Vec3(1, 2, 2) / 3)), 1, 1e-9);
      expect_the_face(face, 1e-6);
    }
  }
}

TEST(ReadSurface, FindsRulingsThoughAnEndHasNoNormal) {
  // A cubic extruded by 30 mm whose last handle, or first, has no length: there ∂u vanishes.
  for (const bool at_end : {true, false}) {
    const gp_Pnt start(0, 0, 0), end(40, 0, 0), low(4, 12, 0), high(30, 14, 0);
    TColgp_Array2OfPnt poles(1, 4, 1, 2);
    const std::array row{start, at_end ? low : start, at_end ? end : high, end};
    for (const int i : {1, 2, 3, 4}) {
      poles(i, 1) = row.at(i - 1);
      poles(i, 2) = poles(i, 1).Translated(gp_Vec(0, 0, 30));
    }
    const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(poles);
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(patch, 1e-7).Face();
    const SolidFace read = read_surface(face, 0.01);
    ASSERT_TRUE(std::holds_alternative<Developable>(read.surface)) << at_end;
    expect_the_face(face, 1e-6);
  }
}

/// A wall over three cubics, 30 mm high and upright over the middle one, u from 1 to 2 alone: over
/// the others it leans more and more, by 5 mm at both ends.
TopoDS_Face warped_at_both_ends(double u0, double u1) {
  constexpr int kPoles = 10;
  TColgp_Array2OfPnt poles(1, kPoles, 1, 2);
  const std::array height{0, 9, 4, 0, 12, 14, 0, 6, 8, 0};
  for (int i = 0; i < kPoles; ++i) {
    const double lean = i % 9 == 0 ? 5.0 : 0.0;
    poles(i + 1, 1) = gp_Pnt(10 * i, height.at(i), 0);
    poles(i + 1, 2) = gp_Pnt(10 * i, height.at(i) + lean, 30);
  }
  TColStd_Array1OfReal u(1, 4), v(1, 2);
  TColStd_Array1OfInteger u_counts(1, 4), v_counts(1, 2);
  for (int i = 1; i <= 4; ++i) {
    u(i) = i - 1;
    u_counts(i) = i % 3 == 1 ? 4 : 3;
  }
  v(1) = 0, v(2) = 1;
  v_counts.Init(2);
  const Handle(Geom_BSplineSurface)
      wall = new Geom_BSplineSurface(poles, u, v, u_counts, v_counts, 3, 1);
  return BRepBuilderAPI_MakeFace(wall, u0, u1, 0, 1, 1e-7).Face();
}

TEST(ReadSurface, LooksForRulingsInTheFaceAloneAndInAllOfIt) {
  EXPECT_TRUE(
      std::holds_alternative<Developable>(read_surface(warped_at_both_ends(1, 2), 0.01).surface));
  expect_the_face(warped_at_both_ends(1, 2), 1e-6);
  for (const auto& [u0, u1] : {std::pair{0, 2}, std::pair{1, 3}})
    EXPECT_TRUE(std::holds_alternative<DoublyCurved>(
        read_surface(warped_at_both_ends(u0, u1), 0.01).surface));
}

TEST(ReadSurface, InterpolatesWithinATenthOfAMicrometreWithFewKnots) {
  // A Hermite span of an ellipse of about 20 mm is off by 20 h⁴ / 384: h is about 0.03 at 1e-7.
  const SolidFace read = read_surface(elliptic_wall(20, 12), 0.01);
  const Developable& surface = std::get<Developable>(read.surface);
  const auto knots = std::get<Ruled>(surface).knots.size();
  EXPECT_GE(knots, 2.7 / std::pow(384e-7 / 12, 0.25));
  EXPECT_LE(knots, 4 * 2.7 / std::pow(384e-7 / 20, 0.25));
  visit_points(elliptic_wall(20, 12), [&](const Vec3& p, const Vec3&) {
    const Vec2 uv = parameters_of(surface, p, 1.0);
    EXPECT_NEAR((point_on(surface, uv) - p).norm(), 0.0, 2e-7);
  });
}

TEST(ReadSurface, NamesWhatCurvesTwice) {
  const auto kind = [](const TopoDS_Shape& shape) {
    const SolidFace read = read_surface(all_faces(shape).front(), 0.01);
    const auto* other = std::get_if<DoublyCurved>(&read.surface);
    return other != nullptr ? other->kind : std::string("developable");
  };
  EXPECT_EQ(kind(BRepPrimAPI_MakeSphere(leaning_axes(), 7).Shape()), "sphere");
  EXPECT_EQ(kind(BRepPrimAPI_MakeTorus(leaning_axes(), 9, 2).Shape()), "torus");
  EXPECT_EQ(kind(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(9, 2).Shape(), true).Shape()),
            "spline");
}

TEST(ReadSurface, TakesAWarpedPatchOnlyIfItsPlanesHardlyTurnAlongItsRulings) {
  // Between the sides of a rectangle 100 x 50 with one corner lifted by h: straight both ways, and
  // its tangent plane turns by h/100 along the rulings of 50, by h/50 along those of 100.
  const auto is_developable = [](double h) {
    TColgp_Array2OfPnt poles(1, 2, 1, 2);
    poles(1, 1) = gp_Pnt(0, 0, 0);
    poles(2, 1) = gp_Pnt(100, 0, 0);
    poles(1, 2) = gp_Pnt(0, 50, 0);
    poles(2, 2) = gp_Pnt(100, 50, h);
    const Handle(Geom_BezierSurface) patch = new Geom_BezierSurface(poles);
    const SolidFace read = read_surface(BRepBuilderAPI_MakeFace(patch, 1e-7).Face(), 0.01);
    return std::holds_alternative<Developable>(read.surface);
  };
  EXPECT_TRUE(is_developable(0.15));
  EXPECT_FALSE(is_developable(0.3));
  EXPECT_FALSE(is_developable(5.0));
}

}  // namespace
}  // namespace planish::brep
