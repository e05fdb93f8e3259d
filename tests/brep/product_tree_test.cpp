#include "product_tree.hpp"

#include "exchange_lock.hpp"
#include "kernel_points.hpp"
#include "step_out.hpp"

#include <planish/brep/codes.hpp>

#include <BRepBndLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <sstream>

namespace planish::brep {
namespace {

TopLoc_Location shifted_by(double x, double y, double z) {
  gp_Trsf motion;
  motion.SetTranslation(gp_Vec(x, y, z));
  return motion;
}

TopLoc_Location quarter_turn() {
  gp_Trsf motion;
  motion.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 2);
  return motion;
}

TopoDS_Compound assembly_of(const std::vector<TopoDS_Shape>& parts) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& part : parts)
    builder.Add(all, part);
  return all;
}

/// As a file with a product for each part of an assembly.
std::string assembly_text(const TopoDS_Shape& shape) {
  const auto lock = exchange_lock();
  STEPControl_Writer writer;
  Interface_Static::SetIVal("write.step.assembly", 1);
  EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
  StepData_StepWriter out(writer.Model());
  out.SendModel(Handle(StepData_Protocol)::DownCast(writer.Model()->Protocol()));
  std::ostringstream stream;
  EXPECT_TRUE(out.Print(stream));
  Interface_Static::SetIVal("write.step.assembly", 0);
  return stream.str();
}

Result<ProductTree> tree_of(const std::string& text) {
  const auto lock = exchange_lock();
  std::istringstream stream(text);
  return read_products(stream, "/nowhere/a.step", "a.step", {});
}

std::vector<Vec3> middles_of(const ProductTree& tree) {
  std::vector<Vec3> middles;
  for (const PlacedSolid& one : tree.solids) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(one.solid, box, false, false);
    middles.push_back(0.5 * (vector_of(box.CornerMin()) + vector_of(box.CornerMax())));
  }
  std::ranges::sort(middles, {}, [](const Vec3& p) { return p.x(); });
  return middles;
}

TEST(ProductTree, PlacesSolidsByAllThatTheyAreIn) {
  // A box of 2 × 4 × 6, shifted in a part that is turned in an assembly that is shifted.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 4, 6).Solid();
  const TopoDS_Compound inner = assembly_of({box, box.Moved(shifted_by(100, 0, 0))});
  const TopoDS_Compound outer = assembly_of(
      {inner.Moved(quarter_turn()), BRepPrimAPI_MakeBox(gp_Pnt(500, 0, 0), 1, 1, 1).Solid()});
  const auto tree = tree_of(assembly_text(outer.Moved(shifted_by(10, 20, 30))));
  ASSERT_TRUE(tree) << tree.error().message;
  const auto middles = middles_of(*tree);
  ASSERT_EQ(middles.size(), 3u);
  std::vector<Vec3> turned{middles[0], middles[1]};
  std::ranges::sort(turned, {}, [](const Vec3& p) { return p.y(); });
  // (1, 2, 3) and (101, 2, 3) turned about z are (−2, 1, 3) and (−2, 101, 3).
  EXPECT_NEAR((turned[0] - Vec3(8, 21, 33)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((turned[1] - Vec3(8, 121, 33)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((middles[2] - Vec3(510.5, 20.5, 30.5)).norm(), 0.0, 1e-5);
  EXPECT_EQ(tree->unit, "mm");
  EXPECT_EQ(tree->surface_bodies, 0);
}

TEST(ProductTree, SharesTheShapeOfPartsThatAnAssemblyHasTwice) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 4, 6).Solid();
  const auto tree = tree_of(assembly_text(assembly_of({box, box.Moved(shifted_by(50, 0, 0))})));
  ASSERT_TRUE(tree);
  ASSERT_EQ(tree->solids.size(), 2u);
  EXPECT_EQ(tree->solids[0].solid.TShape(), tree->solids[1].solid.TShape());
}

TEST(ProductTree, CountsShellsAndNamesSolids) {
  BRep_Builder builder;
  TopoDS_Shell open;
  builder.MakeShell(open);
  builder.Add(open, TopExp_Explorer(BRepPrimAPI_MakeBox(3, 4, 5).Shape(), TopAbs_FACE).Current());
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 4, 6).Solid();
  const auto tree = tree_of(
      step_text(assembly_of({box, open, open.Moved(shifted_by(9, 9, 9))}), "lid").value());
  ASSERT_TRUE(tree);
  ASSERT_EQ(tree->solids.size(), 1u);
  EXPECT_EQ(tree->solids[0].name, "lid");
  EXPECT_EQ(tree->surface_bodies, 2);
}

TEST(ProductTree, ReadsLengthsInTheFilesUnit) {
  std::string text = step_text(BRepPrimAPI_MakeBox(2, 4, 6).Solid(), "lid").value();
  const size_t at = text.find(".MILLI.,.METRE.");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 7, "$");
  const auto tree = tree_of(text);
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->unit, "m");
  EXPECT_NEAR((middles_of(*tree).at(0) - Vec3(1000, 2000, 3000)).norm(), 0.0, 1e-2);
}

TEST(ProductTree, RefusesWhatItCannotRead) {
  EXPECT_EQ(tree_of("ISO-10303-21;\nnonsense").error().code, code::invalid_input);
  std::string far = step_text(BRepPrimAPI_MakeBox(2, 4, 6).Solid(), "lid").value();
  const size_t at = far.find("CARTESIAN_POINT('',(");
  const size_t end = far.find(')', at + 20);
  far.replace(at, end - at, "CARTESIAN_POINT('',(2.E+09,0.,0.");
  EXPECT_EQ(tree_of(far).error().code, code::too_far_away);
}

}  // namespace
}  // namespace planish::brep
