#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <vector>

// Beads and louvres pressed up from sheet, sharp where they leave it. Each is the sheet and an
// outer form, less the same form a thickness farther in. A pattern has none of their bends, and of
// a louvre the slit along its mouth.

namespace planish::test {
namespace {

TopoDS_Shape cuboid(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

TopoDS_Shape sheet_of_2(double length) { return cuboid({0, 0, 0}, {length, 120, 2}); }

struct Corner {
  double y, z;
};

/// A prism along x.
TopoDS_Shape prism(double from, double to, const std::vector<Corner>& corners) {
  BRepBuilderAPI_MakePolygon outline;
  for (const Corner& corner : corners)
    outline.Add(gp_Pnt(from, corner.y, corner.z));
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(),
                               gp_Vec(to - from, 0, 0))
      .Shape();
}

/// The sheet pressed up: its form is `outer` above and `inner` below.
TopoDS_Shape pressed(const TopoDS_Shape& sheet, const TopoDS_Shape& outer,
                     const TopoDS_Shape& inner) {
  ShapeUpgrade_UnifySameDomain whole(
      BRepAlgoAPI_Cut(BRepAlgoAPI_Fuse(sheet, outer).Shape(), inner).Shape());
  whole.Build();
  return whole.Shape();
}

/// Where it is and how long, along x; its mouth, or its ridge, is at y.
struct Place3 {
  double x, length, y;
};

/// A roof that falls from its mouth, `height` above the sheet, to the sheet 20 mm farther on, with
/// an upright wall at either end.
TopoDS_Shape wedge_louvre(const TopoDS_Shape& sheet, const Place3& at, double height) {
  const double end = at.x + at.length, down = 2 * std::hypot(20, height) / 20;
  const auto roof = [&](double below, double z) {
    return Corner{at.y + 20 * (2 + height - below - z) / height, z};
  };
  return pressed(sheet,
                 prism(at.x, end, {{at.y, 0}, {roof(0, 2).y, 0}, roof(0, 2), {at.y, 2 + height}}),
                 prism(at.x + 2, end - 2, {{at.y, -1}, roof(down, -1), {at.y, 2 + height - down}}));
}

enum class Ends { round, upright };

/// Round about the axis z = 0 at y, its ends balls or upright walls; all of it, or from y on.
struct Tube {
  double radius = 8;
  Ends ends = Ends::upright;
  bool half = false;
};

TopoDS_Shape tube(const Place3& at, const Tube& of, double inset, double below) {
  const double radius = of.radius - inset, shorter = of.ends == Ends::upright ? inset : 0.0;
  const gp_Ax2 axis(gp_Pnt(at.x + shorter, at.y, 0), gp_Dir(1, 0, 0));
  TopoDS_Shape whole = BRepPrimAPI_MakeCylinder(axis, radius, at.length - 2 * shorter).Shape();
  if (of.ends == Ends::round)
    for (const double x : {at.x, at.x + at.length})
      whole = BRepAlgoAPI_Fuse(whole, BRepPrimAPI_MakeSphere(gp_Pnt(x, at.y, 0), radius).Shape())
                  .Shape();
  return BRepAlgoAPI_Common(whole, cuboid({-50, of.half ? at.y : -50, below}, {900, 500, 50}))
      .Shape();
}

TopoDS_Shape with_tube(const TopoDS_Shape& sheet, const Place3& at, const Tube& of) {
  return pressed(sheet, tube(at, of, 0, 0), tube(at, of, 2, -1));
}

/// A ridge whose flanks meet the sheet `half` beside y, with upright ends.
TopoDS_Shape v_bead(const TopoDS_Shape& sheet, const Place3& at, double half, double height) {
  const double end = at.x + at.length, down = 2 * std::hypot(half, height) / half;
  const double low = half + half * (3 - down) / height;  // of the hollow, 1 below the sheet
  return pressed(
      sheet, prism(at.x, end, {{at.y - half, 2}, {at.y + half, 2}, {at.y, 2 + height}}),
      prism(at.x + 2, end - 2, {{at.y - low, -1}, {at.y + low, -1}, {at.y, 2 + height - down}}));
}

/// The sheet's own area and the number of forms, all of one kind, with a slit for each louvre.
struct Expected {
  double area;
  int forms = 1, slits = 0;
  int bends = 0;
};

void expect_forms(const TopoDS_Shape& shape, const Expected& expected) {
  const auto seen = unfolded_shape(shape);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->sheet.thickness, 2.0, 1e-9);
  EXPECT_EQ(std::ssize(seen->sheet.bends), expected.bends);
  EXPECT_EQ(std::ssize(seen->flat.features), expected.forms);
  for (const auto& feature : seen->flat.features)
    EXPECT_EQ(feature.kind, "formed");
  EXPECT_EQ(std::ssize(seen->flat.slits), expected.slits);
  EXPECT_EQ(std::ssize(seen->flat.openings), 0);
  EXPECT_NEAR(seen->flat.area, expected.area, 1e-6) << "nothing is cut away";
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 1e-6);
  EXPECT_EQ(seen->certificate.openings.lost(), 0);
}

TEST(PressedForms, LouvresMayHaveUprightEnds) {
  for (const double height : {3.0, 5.0, 8.0, 14.0})
    expect_forms(wedge_louvre(sheet_of_2(200), {60, 60, 40}, height), {24000, 1, 1});
  for (const Ends ends : {Ends::round, Ends::upright})
    for (const double radius : {5.0, 8.0})
      expect_forms(with_tube(sheet_of_2(200), {60, 60, 40}, {radius, ends, true}), {24000, 1, 1});
}

TEST(PressedForms, HalfPressedOnesHaveNoMouthAndAreStillOneForm) {
  // The roof's mouth ends at or below the sheet's upper skin: nothing is cut through.
  for (const double height : {1.0, 1.9})
    expect_forms(wedge_louvre(sheet_of_2(200), {60, 60, 40}, height), {24000, 1, 0});
}

TEST(PressedForms, BeadsMayHaveUprightEnds) {
  expect_forms(v_bead(sheet_of_2(200), {50, 100, 60}, 9, 6), {24000});
  for (const double radius : {5.0, 8.0, 12.0})
    expect_forms(with_tube(sheet_of_2(200), {50, 100, 60}, {radius}), {24000});
}

TEST(PressedForms, StandBesideABend) {
  const BentBracket of{
      .thickness = 2, .inside_radius = 2, .first = 120, .second = 40, .width = 120};
  const double flat = 120 * (120 + 40 + 3 * std::numbers::pi / 2);
  for (const double from_bend : {0.0, 1e-4, 1.0, 4.0, 30.0}) {
    const double x = 120 - from_bend - 50;
    expect_forms(wedge_louvre(bent_bracket(of), {x, 50, 40}, 6), {flat, 1, 1, 1});
    if (from_bend >= 1.0)
      expect_forms(with_tube(bent_bracket(of), {x, 50, 40}, {}), {flat, 1, 0, 1});
  }
}

TEST(PressedForms, MayEndWithTheirFootOnTheTangentLine) {
  const BentBracket of{
      .thickness = 2, .inside_radius = 2, .first = 120, .second = 40, .width = 120};
  gp_Trsf turned;  // the first flange along y, its bend at y = 120
  turned.SetRotation(gp_Ax1(gp_Pnt(60, 60, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 2);
  const TopoDS_Shape bracket = BRepBuilderAPI_Transform(bent_bracket(of), turned).Shape();
  for (const double height : {3.0, 6.0})
    for (const double before : {0.0, 1e-4, 1.0})
      expect_forms(wedge_louvre(bracket, {30, 60, 100 - before}, height),
                   {120 * (120 + 40 + 3 * std::numbers::pi / 2), 1, 1, 1});
}

TEST(PressedForms, MayHaveTheirMouthOnTheTangentLine) {
  const BentBracket of{
      .thickness = 2, .inside_radius = 2, .first = 120, .second = 40, .width = 120};
  gp_Trsf turned;  // the first flange along y, its bend at y = 0
  turned.SetRotation(gp_Ax1(gp_Pnt(60, 60, 0), gp_Dir(0, 0, 1)), -std::numbers::pi / 2);
  const TopoDS_Shape bracket = BRepBuilderAPI_Transform(bent_bracket(of), turned).Shape();
  for (const double radius : {5.0, 8.0})
    for (const double before : {0.0, 1e-4, 1.0})
      expect_forms(with_tube(bracket, {30, 60, before}, {radius, Ends::round, true}),
                   {120 * (120 + 40 + 3 * std::numbers::pi / 2), 1, 1, 1});
}

TEST(PressedForms, MayCoverAPanel) {
  // By themselves they are a third of the skin, and add a tenth to the volume.
  TopoDS_Shape louvres = sheet_of_2(400), beads = louvres;
  for (const double x : {10.0, 110.0, 210.0, 310.0})
    for (const double y : {8.0, 36.0, 64.0, 92.0})
      louvres = wedge_louvre(louvres, {x, 80, y}, 8);
  for (const double y : {20.0, 47.0, 74.0, 101.0})
    beads = with_tube(beads, {20, 360, y}, {});
  expect_forms(louvres, {48000, 16, 16});
  expect_forms(beads, {48000, 4, 0});
}

TEST(PressedForms, AreNoTabsThatAreBentUp) {
  // A tab of 30 × 40 cut free on three sides, bent up sharply by 45° along x: two flanges.
  const double corner = 2 * std::tan(std::numbers::pi / 8), step = 2 * std::sqrt(0.5);
  TopoDS_Shape sheet = BRepAlgoAPI_Cut(sheet_of_2(200), cuboid({60, 40, -1}, {90, 80, 3})).Shape();
  const TopoDS_Shape tab = prism(
      61, 89, {{80, 0}, {80, 2}, {60, 22}, {60 - step, 22 - step}, {80 - corner, 0}});
  sheet = BRepAlgoAPI_Fuse(sheet, tab).Shape();
  const auto seen = unfolded_shape(sheet);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_EQ(seen->sheet.bends.size(), 1u);
  EXPECT_TRUE(seen->flat.features.empty());
  EXPECT_EQ(seen->flat.openings.size(), 1u);
}

}  // namespace
}  // namespace planish::test
