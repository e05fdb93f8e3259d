#include "soundness.hpp"

#include "made_faces.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace planish::brep::test {
namespace {

TopoDS_Face face_of_kind(const TopoDS_Shape& shape, GeomAbs_SurfaceType kind) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(faces.Current())).GetType() == kind)
      return TopoDS::Face(faces.Current());
  return {};
}

TEST(IsReadable, HoldsForTheKernelsOwnFaces) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeBox(3, 4, 5).Shape(), BRepPrimAPI_MakeCylinder(5, 8).Shape(),
        BRepPrimAPI_MakeCone(5, 2, 4).Shape(), BRepPrimAPI_MakeCylinder(5, 8, 1.3).Shape(),
        BRepPrimAPI_MakeSphere(5).Shape()})
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
      EXPECT_TRUE(is_readable(TopoDS::Face(faces.Current())));
      EXPECT_TRUE(has_parameter_curves(TopoDS::Face(faces.Current())));
      EXPECT_TRUE(follows_in_parameters(TopoDS::Face(faces.Current())));
    }
}

TEST(IsReadable, WantsEdgesThatFollowEachOtherForwardsOrBackwards) {
  const TopoDS_Face side = face_of_kind(BRepPrimAPI_MakeBox(3, 4, 5).Shape(), GeomAbs_Plane);
  std::vector<TopoDS_Edge> edges = edges_of(side);
  EXPECT_TRUE(is_readable(with_loops(side, {edges})));
  std::rotate(edges.begin(), edges.begin() + 1, edges.end());
  EXPECT_TRUE(is_readable(with_loops(side, {edges})));
  std::ranges::reverse(edges);
  EXPECT_TRUE(is_readable(with_loops(side, {edges}))) << "written the other way round";
  std::swap(edges[0], edges[1]);
  EXPECT_FALSE(is_readable(with_loops(side, {edges})));
  edges = edges_of(side);
  edges.pop_back();
  EXPECT_FALSE(is_readable(with_loops(side, {edges}))) << "open";
  EXPECT_FALSE(is_readable(with_loops(side, {}))) << "without a loop";
  EXPECT_FALSE(is_readable(TopoDS_Face(TopoDS::Face(with_loops(side, {edges_of(side), {}})))));
}

TEST(IsReadable, WantsASeamWhereALoopRunsRoundTheAxis) {
  for (const auto& [shape, kind] :
       {std::pair{BRepPrimAPI_MakeCylinder(5, 8).Shape(), GeomAbs_Cylinder},
        {BRepPrimAPI_MakeCone(5, 2, 4).Shape(), GeomAbs_Cone}}) {
    const TopoDS_Face wall = face_of_kind(shape, kind);
    std::vector<std::vector<TopoDS_Edge>> circles;
    for (const TopoDS_Edge& edge : edges_of(wall)) {
      double t0, t1;
      if (!BRep_Tool::IsClosed(edge, wall)) circles.push_back({edge});
      EXPECT_FALSE(BRep_Tool::Curve(edge, t0, t1).IsNull());
    }
    ASSERT_EQ(circles.size(), 2u);
    EXPECT_TRUE(is_readable(with_loops(wall, {edges_of(wall)})));
    EXPECT_FALSE(is_readable(with_loops(wall, circles)));
    EXPECT_FALSE(is_readable(with_loops(wall, {circles[0]})));
  }
}

TEST(HasParameterCurves, IsWhatMeshingNeedsBesidesPlanes) {
  const TopoDS_Face wall = face_of_kind(BRepPrimAPI_MakeCylinder(5, 8).Shape(), GeomAbs_Cylinder);
  const TopoDS_Face top = face_of_kind(BRepPrimAPI_MakeCylinder(5, 8).Shape(), GeomAbs_Plane);
  // A surface of its own, for which the edges have no curves.
  BRep_Builder builder;
  TopoDS_Face bare;
  builder.MakeFace(bare, Handle(Geom_Surface)::DownCast(BRep_Tool::Surface(wall)->Copy()), 1e-7);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : edges_of(wall))
    builder.Add(wire, edge);
  builder.Add(bare, wire);
  EXPECT_FALSE(has_parameter_curves(bare));
  EXPECT_FALSE(follows_in_parameters(bare));
  EXPECT_TRUE(has_parameter_curves(wall));
  EXPECT_TRUE(has_parameter_curves(top));
}

TopoDS_Solid solid_of(const std::vector<TopoDS_Shape>& faces) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  builder.MakeShell(shell);
  for (const TopoDS_Shape& face : faces)
    builder.Add(shell, face);
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

std::vector<TopoDS_Shape> faces_in(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
    faces.push_back(at.Current());
  return faces;
}

TEST(IsClosedSolid, WantsOneShellThatHangsTogetherAndCloses) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(3, 4, 5).Shape();
  auto faces = faces_in(box);
  EXPECT_TRUE(is_closed_solid(BRepPrimAPI_MakeBox(3, 4, 5).Solid()));
  EXPECT_TRUE(is_closed_solid(BRepPrimAPI_MakeSphere(5).Solid())) << "poles are no edges";
  EXPECT_TRUE(is_closed_solid(BRepPrimAPI_MakeCylinder(5, 8).Solid()));
  EXPECT_TRUE(is_closed_solid(solid_of(faces)));
  EXPECT_FALSE(is_closed_solid(TopExp_Explorer(box, TopAbs_SHELL).Current())) << "no solid";
  for (size_t i = 0; i < faces.size(); ++i) {
    auto others = faces;
    others.erase(others.begin() + static_cast<long>(i));
    EXPECT_FALSE(is_closed_solid(solid_of(others)));
    others = faces;
    others[i].Reverse();
    EXPECT_FALSE(is_closed_solid(solid_of(others)));
    others = faces;
    others.push_back(faces[i]);
    EXPECT_FALSE(is_closed_solid(solid_of(others)));
  }
  auto two = faces;
  for (const TopoDS_Shape& face : faces_in(BRepPrimAPI_MakeBox(gp_Pnt(9, 9, 9), 1, 1, 1).Shape()))
    two.push_back(face);
  EXPECT_FALSE(is_closed_solid(solid_of(two))) << "two boxes in one shell";
  EXPECT_FALSE(is_closed_solid(solid_of({})));
  TopoDS_Solid hollow = solid_of(faces);
  BRep_Builder().Add(hollow,
                     TopExp_Explorer(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_SHELL).Current());
  EXPECT_FALSE(is_closed_solid(hollow)) << "two shells";
}

}  // namespace
}  // namespace planish::brep::test
