#include "body.hpp"
#include "guarded.hpp"
#include "step_out.hpp"
#include "support/real_parts.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/same_part.hpp>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

// The same solid, wherever it lies in its file, is the same part; its mirror image is the same
// only if the two patterns are.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

Result<FlatPattern> flat_of(const Body& body) {
  const auto found = recognize(body);
  if (!found) return tl::unexpected(found.error());
  return flatten(found->sheet);
}

/// What is read of the body after the motion.
Result<FlatPattern> flat_of_moved(const Body& body, const gp_Trsf& motion) {
  const auto text = brep::guarded([&] {
    return brep::step_text(BRepBuilderAPI_Transform(body.shape().solid, motion, true).Shape(),
                           "moved");
  });
  if (!text) return tl::unexpected(text.error());
  const auto file = read_step_text(*text, "moved.step");
  if (!file) return tl::unexpected(file.error());
  return flat_of(file->bodies.front());
}

gp_Trsf turned_in_space() {
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 0.7)), 1.234);
  shift.SetTranslation(gp_Vec(-310, 47, 1020));
  return shift * turn;
}

gp_Trsf mirrored_in_space() {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(0.6, 0.8, 0)));
  return mirror;
}

/// A channel with a hole near one corner: a left and a right one differ.
Body handed_part() {
  Sheet sheet = u_channel();
  BorderLoop hole;
  for (const Curve2& curve : circular_opening({8.0, 5.0}, 2.0))
    hole.push_back({curve});
  sheet.faces[sheet.flanges[FlangeId{0}].faces.front()].loops.push_back(hole);
  sheet.volume.reset();
  sheet.genus.reset();
  auto body = folded_body(sheet, "channel");
  EXPECT_TRUE(body) << body.error().message;
  return *body;
}

TEST(SamePartInSpace, IsFoundInAnyPlaceButNotInAMirror) {
  const Body body = handed_part();
  const auto here = flat_of(body), there = flat_of_moved(body, turned_in_space()),
             mirrored = flat_of_moved(body, mirrored_in_space());
  ASSERT_TRUE(here && there && mirrored);
  EXPECT_TRUE(is_same_part(*here, *there));
  EXPECT_FALSE(is_same_part(*here, *mirrored));
  EXPECT_FALSE(is_same_part(*there, *mirrored));
}

/// A triangle of 2 mm without symmetry but that of its skins; what is done at (40, 20) makes it a
/// left or a right part.
TopoDS_Shape triangle() {
  BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(120, 0, 0), gp_Pnt(30, 80, 0), true);
  const TopoDS_Face base = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  return BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 2)).Shape();
}

/// Solids added to the triangle, then taken from it, symmetric about the plane x = middle.
struct Form {
  const char* name;
  std::vector<TopoDS_Shape> added, removed;
  double middle = 40.0;
};

/// The triangle with the form, or its mirror image: turned about the middle plane of the sheet.
TopoDS_Shape formed(const Form& form, bool mirrored) {
  gp_Trsf turn;
  if (mirrored)
    turn.SetRotation(gp_Ax1(gp_Pnt(form.middle, 0, 1), gp_Dir(0, 1, 0)), std::numbers::pi);
  TopoDS_Shape part = triangle();
  for (const TopoDS_Shape& tool : form.added)
    part = BRepAlgoAPI_Fuse(part, BRepBuilderAPI_Transform(tool, turn).Shape()).Shape();
  for (const TopoDS_Shape& tool : form.removed)
    part = BRepAlgoAPI_Cut(part, BRepBuilderAPI_Transform(tool, turn).Shape()).Shape();
  return part;
}

gp_Ax2 upright(double height) { return {gp_Pnt(40, 20, height), gp_Dir(0, 0, 1)}; }

TopoDS_Shape cylinder(double from, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(upright(from), radius, height).Shape();
}

TopoDS_Shape cone(double from, double low, double high, double height) {
  return BRepPrimAPI_MakeCone(upright(from), low, high, height).Shape();
}

/// Of a sphere, what is above a height.
TopoDS_Shape cap(double middle, double radius, double above) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(40, 20, middle), radius).Shape();
  return BRepAlgoAPI_Common(ball, cylinder(above, 2 * radius, 2 * radius)).Shape();
}

/// Saws the triangle's side along x, or chamfers it to this depth.
TopoDS_Shape wedge(double width, double depth) {
  BRepBuilderAPI_MakePolygon outline(gp_Pnt(-10, 0, 2), gp_Pnt(-10, width, 2),
                                     gp_Pnt(-10, 0, 2 - depth), true);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  return BRepPrimAPI_MakePrism(face, gp_Vec(140, 0, 0)).Shape();
}

TEST(SamePartInSpace, HasItsFormsOnTheirSides) {
  const Form forms[] = {{"countersink", {}, {cylinder(-1, 3, 4), cone(0.5, 3, 4.5, 1.5)}},
                        {"pocket", {}, {cylinder(1.2, 6, 0.8)}},
                        {"boss", {cylinder(1, 5, 4)}, {}},
                        {"low emboss", {cone(2, 12, 11, 0.7)}, {cone(0, 10, 9, 0.7)}},
                        {"high emboss", {cone(2, 12, 9, 3)}, {cone(0, 10, 7, 3)}},
                        {"dome, without an edge above its rim", {cap(-6, 14, 1)}, {cap(-6, 12, 0)}},
                        {"slanted side", {}, {wedge(1, 2)}, 60.0},
                        {"chamfer", {}, {wedge(0.5, 0.5)}, 60.0}};
  for (const Form& form : forms) {
    SCOPED_TRACE(form.name);
    const auto body_of = [&](bool mirrored) {
      const auto text = brep::guarded(
          [&] { return brep::step_text(formed(form, mirrored), "part"); });
      return read_step_text(text.value(), "part.step").value().bodies.front();
    };
    const Body left = body_of(false), right = body_of(true);
    const auto here = flat_of(left), there = flat_of_moved(left, turned_in_space()),
               mirrored = flat_of(right), elsewhere = flat_of_moved(right, turned_in_space());
    ASSERT_TRUE(here) << here.error().message;
    ASSERT_TRUE(there && mirrored && elsewhere);
    EXPECT_FALSE(here->features.empty());
    EXPECT_TRUE(is_same_part(*here, *there));
    EXPECT_TRUE(is_same_part(*mirrored, *elsewhere));
    EXPECT_FALSE(is_same_part(*here, *mirrored));
    EXPECT_FALSE(is_same_part(*there, *elsewhere));
  }
}

TEST(SamePartInSpace, IsFoundForRealParts) {
  if (!fs::exists(real_parts_folder())) GTEST_SKIP() << kNoRealParts;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(real_parts_folder()))
    if (entry.path().filename().string().starts_with("sm")) files.push_back(entry.path());
  std::ranges::sort(files);
  int compared = 0;
  for (const fs::path& file : files) {
    constexpr int kEnough = 12;
    if (compared == kEnough) break;
    const auto step = read_step(file);
    if (!step || step->bodies.size() != 1) continue;
    const auto here = flat_of(step->bodies.front());
    if (!here) continue;
    SCOPED_TRACE(file.filename().string());
    const auto there = flat_of_moved(step->bodies.front(), turned_in_space());
    ASSERT_TRUE(there) << there.error().message;
    EXPECT_TRUE(is_same_part(*here, *there));
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

}  // namespace
}  // namespace planish::test
