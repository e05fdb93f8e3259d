#include "body.hpp"
#include "mend.hpp"
#include "soundness.hpp"
#include "support/closed_mesh.hpp"

#include <planish/brep/step.hpp>

#include <BRepAdaptor_Surface.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Vec2d.hxx>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace planish::test {
namespace {

constexpr double kRadius = 20.0, kHeight = 50.0;

TopoDS_Face round_face(const TopoDS_Shape& solid) {
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(faces.Current())).GetType() == GeomAbs_Cylinder)
      return TopoDS::Face(faces.Current());
  return {};
}

/// A quarter of a cylinder. The parameter curve of one edge of its round face lies `periods` off,
/// as files have it: in space it is the same.
TopoDS_Solid quarter(int edge_moved, int periods) {
  const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(kRadius, kHeight, std::numbers::pi / 2)
                                 .Solid();
  const TopoDS_Face face = round_face(solid);
  int number = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next(), ++number) {
    if (number != edge_moved) continue;
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    double t0 = 0.0, t1 = 0.0;
    const Handle(Geom2d_Curve) curve = Handle(Geom2d_Curve)::DownCast(
        BRep_Tool::CurveOnSurface(edge, face, t0, t1)->Copy());
    curve->Translate(gp_Vec2d(periods * 2 * std::numbers::pi, 0.0));
    BRep_Builder().UpdateEdge(edge, curve, face, BRep_Tool::Tolerance(edge));
  }
  return TopoDS::Solid(solid);
}

Body body_of(const TopoDS_Solid& solid) {
  Body::Shape shape{solid, "quarter"};
  shape.faces = 5;
  return Body(std::make_shared<const Body::Shape>(std::move(shape)));
}

TEST(BodyMesh, IsThatOfTheSolidWhereParameterCurvesLieAPeriodApart) {
  constexpr double kChord = 0.01;
  const double volume = std::numbers::pi * kRadius * kRadius * kHeight / 4;
  const double round = std::numbers::pi * kRadius * kHeight / 2;
  for (int edge = 0; edge < 4; ++edge)
    for (int periods : {-2, -1, 0, 1}) {
      SCOPED_TRACE(std::to_string(edge) + ", " + std::to_string(periods));
      const TopoDS_Solid solid = quarter(edge, periods);
      EXPECT_EQ(brep::follows_in_parameters(round_face(solid)), periods == 0);
      EXPECT_TRUE(brep::follows_in_parameters(round_face(brep::meshable(solid))));
      for (const auto& surface :
           {body_mesh(body_of(solid), kChord), body_mesh_in_part(body_of(solid), kChord)}) {
        ASSERT_TRUE(surface.has_value()) << surface.error().message;
        EXPECT_TRUE(is_closed(surface->mesh));
        EXPECT_EQ(std::set<int>(surface->face.begin(), surface->face.end()).size(), 5u);
        EXPECT_NEAR(volume_in(surface->mesh), volume, kChord * round);
      }
      EXPECT_TRUE(body_faces_mesh(body_of(solid), kChord).has_value());
    }
}

}  // namespace
}  // namespace planish::test
