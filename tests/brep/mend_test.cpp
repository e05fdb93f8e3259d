#include "mend.hpp"

#include "face_volume.hpp"
#include "guarded.hpp"
#include "made_faces.hpp"
#include "mend_where_needed.hpp"
#include "patch_volume.hpp"
#include "solid_reader.hpp"
#include "soundness.hpp"
#include "step_out.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

gp_Ax2 upright(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

TopoDS_Shape only_solid(const TopoDS_Shape& shape) {
  return TopExp_Explorer(shape, TopAbs_SOLID).Current();
}

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(100, 60, 10).Shape(); }

TopoDS_Shape drilled() {
  return only_solid(
      BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCylinder(upright(30, 30, -1), 5, 12).Shape())
          .Shape());
}
constexpr double kDrilledVolume = 60000 - 250 * pi;

/// A hole with a conical sink down to its full depth.
TopoDS_Shape sunk() {
  return only_solid(
      BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCone(upright(30, 30, -1), 3, 9, 12).Shape())
          .Shape());
}

/// With a round dimple of radius 5 in its top.
TopoDS_Shape dimpled() {
  return only_solid(
      BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeSphere(gp_Pnt(30, 30, 10), 5).Shape()).Shape());
}
constexpr double kDimpledVolume = 60000 - 250 * pi / 3;

struct Read {
  TopoDS_Shape shape;
  MendCount count;
};

/// As it is written and read again; files are written without curves in parameters.
Read read_again(const TopoDS_Shape& shape) {
  const auto text = step_text(shape, "part");
  const MendWhereNeeded mending;
  STEPControl_Reader reader;
  std::istringstream stream(*text);
  EXPECT_EQ(reader.ReadStream("part", stream), IFSelect_RetDone);
  reader.TransferRoots();
  return {reader.OneShape(), mending.count()};
}

double volume(const TopoDS_Shape& shape) {
  return volume_of(read_solid(TopoDS::Solid(only_solid(shape)), 0.01));
}

template <typename Wanted>
TopoDS_Face face_where(const TopoDS_Shape& shape, const Wanted& wanted) {
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    if (wanted(TopoDS::Face(faces.Current()))) return TopoDS::Face(faces.Current());
  return {};
}

bool is_cylinder(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face).GetType() == GeomAbs_Cylinder;
}

TopoDS_Shape with(const TopoDS_Shape& shape, const TopoDS_Shape& face, const TopoDS_Shape& other) {
  BRepTools_ReShape change;
  change.Replace(face, other);
  return change.Apply(shape);
}

/// The drilled block as read, the wall of its hole between two circles and without a seam.
TopoDS_Shape without_seam() {
  const TopoDS_Shape solid = only_solid(read_again(drilled()).shape);
  const TopoDS_Face wall = face_where(solid, is_cylinder);
  std::vector<std::vector<TopoDS_Edge>> circles;
  for (const TopoDS_Edge& edge : edges_of(wall))
    if (TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge))) circles.push_back({edge});
  return with(solid, wall, with_loops(wall, circles));
}

/// The block, the edges of one side in another order than they follow each other.
TopoDS_Shape disordered() {
  const TopoDS_Shape solid = block();
  const TopoDS_Face side = face_where(solid, [](const TopoDS_Face&) { return true; });
  std::vector<TopoDS_Edge> edges = edges_of(side);
  std::swap(edges[1], edges[2]);
  return with(solid, side, with_loops(side, {edges}));
}

TEST(Mend, LeavesPlanesCylindersAndConesAsTheyAreWritten) {
  for (const TopoDS_Shape& shape : {drilled(), sunk()}) {
    const Read read = read_again(shape);
    EXPECT_EQ(read.count.shapes, 1);
    EXPECT_EQ(read.count.faces, 0);
    EXPECT_EQ(read.count.whole, 0);
    EXPECT_NEAR(volume(read.shape), volume(shape), 1e-6);
  }
}

TEST(Mend, GivesParameterCurvesToTheFacesThatAreReadByThemAlone) {
  const Read read = read_again(dimpled());
  EXPECT_EQ(read.count.faces, 1);
  EXPECT_EQ(read.count.whole, 0);
  EXPECT_NEAR(volume(read.shape), kDimpledVolume, 1e-5);
}

TEST(Mend, PutsTheEdgesOfALoopInOrder) {
  const Mended done = mended(disordered(), {});
  EXPECT_EQ(done.faces, 1);
  EXPECT_FALSE(done.whole);
  EXPECT_NEAR(volume(done.shape), 60000, 1e-6);
}

TEST(Mend, AddsTheSeamThatALoopRoundACylinderNeeds) {
  const TopoDS_Shape solid = without_seam();
  EXPECT_FALSE(is_readable(face_where(solid, is_cylinder)));
  const Mended done = mended(solid, {});
  EXPECT_EQ(done.faces, 1);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(done.shape, TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 15) << "a box has 12; the hole two circles and a seam";
  EXPECT_NEAR(volume(done.shape), kDrilledVolume, 1e-6);
}

TEST(Mend, MendsWhatDoesNotCloseAsAWhole) {
  BRepTools_ReShape change;
  const TopoDS_Shape solid = block();
  change.Remove(face_where(solid, [](const TopoDS_Face&) { return true; }));
  const TopoDS_Shape open = change.Apply(solid);
  EXPECT_FALSE(is_closed_solid(open));
  EXPECT_TRUE(mended(open, {}).whole);
}

TEST(Mend, MendsNothingTwice) {
  for (const TopoDS_Shape& shape : {disordered(), without_seam()}) {
    const Mended once = mended(shape, {});
    const Mended twice = mended(once.shape, {});
    EXPECT_EQ(twice.faces, 0);
    EXPECT_FALSE(twice.whole);
  }
}

TEST(Mend, LetsTheKernelMeasureEveryFaceOfACopy) {
  const TopoDS_Shape read = read_again(drilled()).shape;
  const TopoDS_Face wall = face_where(read, is_cylinder);
  EXPECT_FALSE(has_parameter_curves(wall));
  const TopoDS_Shape copy = with_parameter_curves(read);
  EXPECT_FALSE(has_parameter_curves(wall)) << "what was read stays as it is";
  double sum = 0.0;
  for (TopExp_Explorer faces(copy, TopAbs_FACE); faces.More(); faces.Next()) {
    EXPECT_TRUE(has_parameter_curves(TopoDS::Face(faces.Current())));
    sum += patch_volume(TopoDS::Face(faces.Current()), Vec3::Zero(), 1e-6);
  }
  EXPECT_NEAR(sum, kDrilledVolume, 1e-4);
}

TEST(ClosedSolid, RunsEveryEdgeOnceEachWay) {
  EXPECT_TRUE(is_closed_solid(drilled()));
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid one_turned;
  builder.MakeShell(shell);
  for (TopExp_Explorer faces(block(), TopAbs_FACE); faces.More(); faces.Next())
    builder.Add(shell, shell.NbChildren() == 0 ? faces.Current().Reversed() : faces.Current());
  builder.MakeSolid(one_turned);
  builder.Add(one_turned, shell);
  EXPECT_FALSE(is_closed_solid(one_turned));
}

}  // namespace
}  // namespace planish::brep::test
