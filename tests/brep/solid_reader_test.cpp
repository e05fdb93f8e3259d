#include "solid_reader.hpp"

#include "face_volume.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep {
namespace {

SolidModel read(const TopoDS_Shape& shape) {
  return read_solid(TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current()), 0.01);
}

TopoDS_Shape drilled_box() {
  const gp_Ax2 axis(gp_Pnt(30, 30, -1), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(100, 60, 2).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, 5, 4).Shape())
      .Shape();
}

TEST(ReadSolid, CountsFacesEdgesAndTheirUses) {
  const SolidModel model = read(drilled_box());
  EXPECT_EQ(model.faces.size(), 7u);
  EXPECT_EQ(model.edges.size(), 15u) << "a box has 12; the hole two circles and a seam";
  for (const SolidEdge& edge : model.edges) {
    EXPECT_EQ(edge.uses, 2);
    EXPECT_NE(edge.forward[0], edge.forward[1]);
  }
}

TEST(ReadSolid, MeasuresTheBoxAndTheVolume) {
  const SolidModel model = read(drilled_box());
  EXPECT_NEAR(model.size, std::sqrt(100.0 * 100 + 60 * 60 + 4), 1e-6);
  EXPECT_NEAR((model.centre - Vec3(50, 30, 1)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(volume_of(model), 12000 - std::numbers::pi * 25 * 2, 1e-7);
}

TEST(ReadSolid, TurnsASolidThatIsInsideOut) {
  const SolidModel model = read(drilled_box().Reversed());
  EXPECT_GT(volume_of(model), 0.0);
  for (const SolidFace& face : model.faces)
    if (const auto* plane = std::get_if<Frame>(&face.surface)) {
      EXPECT_GT(plane->z.dot(plane->origin - model.centre), 0.0) << "planes look outwards";
    }
}

TEST(ReadSolid, RunsLoopsFromVertexToVertex) {
  const SolidModel model = read(drilled_box());
  for (const SolidFace& face : model.faces)
    for (const auto& loop : face.loops)
      for (size_t i = 0; i < loop.size(); ++i) {
        const CoEdge& next = loop[(i + 1) % loop.size()];
        EXPECT_EQ(model.edges[loop[i].edge].vertices[loop[i].forward ? 1 : 0],
                  model.edges[next.edge].vertices[next.forward ? 0 : 1]);
      }
}

}  // namespace
}  // namespace planish::brep
