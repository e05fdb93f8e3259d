#include "step_out.hpp"
#include "support/error_data.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace planish::brep {
namespace {

std::string text_with(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
    builder.Add(all, shape);
  return step_text(all, "kit").value();
}

/// A block with a hole and a notch: it has no mirror plane.
TopoDS_Shape handed_block() {
  const gp_Ax2 axis(gp_Pnt(12, 31, -1), gp::DZ());
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(100, 60, 10).Shape(),
                                               BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape());
  const TopoDS_Shape cut = BRepAlgoAPI_Cut(
      drilled, BRepPrimAPI_MakeBox(gp_Pnt(80, 50, 6), 30, 30, 30).Shape());
  return TopExp_Explorer(cut, TopAbs_SOLID).Current();
}

TopoDS_Shape transformed_by(const TopoDS_Shape& shape, bool mirrored) {
  gp_Trsf motion;
  if (mirrored)
    motion.SetMirror(gp_Ax2(gp_Pnt(300, 0, 0), gp_Dir(1, 1, 0)));
  else
    motion.SetTranslation(gp_Vec(300, 20, 5));
  return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

TEST(StepIn, CountsCopiesOfABodyButNotItsMirrorImage) {
  const auto file = read_step_text(
      text_with({handed_block(), transformed_by(handed_block(), false),
                 transformed_by(handed_block(), true), BRepPrimAPI_MakeBox(1, 2, 3).Solid()}),
      "a.step");
  ASSERT_TRUE(file);
  ASSERT_EQ(file->bodies.size(), 3u);
  EXPECT_EQ(file->bodies[0].quantity(), 2);
  EXPECT_EQ(file->bodies[1].quantity(), 1);
  EXPECT_EQ(file->bodies[2].quantity(), 1);
  EXPECT_EQ(file->bodies[0].face_count(), 10) << "six, a hole and three of a notch";
  EXPECT_EQ(file->bodies[2].face_count(), 6);
  EXPECT_NEAR(file->bodies[2].volume(), 6, 1e-6);
  EXPECT_EQ(file->unit, "mm");
  EXPECT_EQ(file->surface_bodies, 0);
  EXPECT_EQ(file->cad_system, "Planish");
  EXPECT_TRUE(file->schema.starts_with("AP214 (AUTOMOTIVE_DESIGN"));
}

TEST(StepIn, CountsTheSameSolidInSeveralPlaces) {
  gp_Trsf aside;
  aside.SetTranslation(gp_Vec(500, 0, 0));
  const TopoDS_Shape one = BRepPrimAPI_MakeBox(30, 20, 2).Solid();
  const auto file = read_step_text(text_with({one, one.Moved(TopLoc_Location(aside)),
                                              one.Moved(TopLoc_Location(aside * aside))}),
                                   "a.step");
  ASSERT_TRUE(file);
  ASSERT_EQ(file->bodies.size(), 1u);
  EXPECT_EQ(file->bodies[0].quantity(), 3);
}

TEST(StepIn, TellsFilesWithoutSolids) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 2).Shape();
  BRep_Builder builder;
  TopoDS_Shell open;
  builder.MakeShell(open);
  builder.Add(open, TopExp_Explorer(box, TopAbs_FACE).Current());
  const auto surfaces = read_step_text(step_text(open, "s").value(), "a.step");
  ASSERT_FALSE(surfaces);
  EXPECT_EQ(surfaces.error().code, code::shell_not_solid);
  EXPECT_EQ(planish::test::number_in(surfaces.error(), "count"), 1);
  const auto both = read_step_text(text_with({box, open}), "a.step");
  ASSERT_TRUE(both);
  EXPECT_EQ(both->bodies.size(), 1u);
  EXPECT_EQ(both->surface_bodies, 1);
  EXPECT_EQ(read_step_text("", "a.step").error().code, code::empty_file);
  EXPECT_EQ(read_step_text("solid", "a.step").error().code, code::not_step);
  const std::string text = text_with({box});
  EXPECT_EQ(read_step_text(text.substr(0, text.size() / 2), "a.step").error().code,
            code::truncated_file);
}

TEST(StepIn, StopsWhenAskedAndTellsHowFarItIs) {
  std::vector<double> shares;
  Progress progress;
  progress.report = [&](std::string_view, double share) { shares.push_back(share); };
  const std::string text = text_with({handed_block(), BRepPrimAPI_MakeBox(1, 2, 3).Solid()});
  EXPECT_TRUE(read_step_text(text, "a.step", progress));
  ASSERT_GE(shares.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
  EXPECT_GE(shares.back(), 0.9);
  // Whenever it is asked to stop it says that it did.
  for (const int after : {0, 1, 2, 3}) {
    int asked = 0;
    Progress stopping;
    stopping.cancelled = [&] { return asked++ >= after; };
    const auto file = read_step_text(text, "a.step", stopping);
    ASSERT_FALSE(file) << after;
    EXPECT_EQ(file.error().code, code::cancelled);
  }
}

TEST(StepIn, ReadsFilesAndSaysWhyItCannot) {
  const auto folder = std::filesystem::temp_directory_path() / "planish_step_in_test";
  std::filesystem::create_directories(folder);
  const auto path = folder / "box.step";
  std::ofstream(path) << text_with({BRepPrimAPI_MakeBox(3, 4, 5).Solid()});
  const auto file = read_step(path);
  ASSERT_TRUE(file);
  EXPECT_NEAR(file->bodies.at(0).volume(), 60, 1e-6);
  EXPECT_EQ(read_step(folder).error().code, code::cannot_read);
  EXPECT_EQ(read_step(folder / "none.step").error().code, code::cannot_read);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace planish::brep
