#include "form_openings.hpp"

#include "form_volume.hpp"
#include "guarded.hpp"
#include "recognised.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

/// A collar of this height and wall below a hole of radius 5 in a sheet of 2 mm.
SolidModel extruded(double height, double wall) {
  const double outside = 5 + wall;
  return plate(2, {100, 60},
               {{{30, 30}, {{5, 2}, {5, -height}, {outside, -height}, {outside, 0}}}});
}

TEST(ExtrudedHole, IsPiercedBySoMuchLessThatTheRestMakesItsCollar) {
  // π 25 · 2 is missing from the sheet, π (36 − 25) · 1.5 is in the collar.
  const double area = pi * 25 - pi * 11 * 1.5 / 2;
  for (const int reference : {kTop, kBottom}) {
    const Sheet sheet = sheet_of(extruded(1.5, 1.0), reference);
    ASSERT_EQ(sheet.features.size(), 1u);
    const FormedFeature& feature = sheet.features.front();
    ASSERT_EQ(feature.openings.size(), 1u);
    EXPECT_EQ(feature.lost_openings, 0);
    EXPECT_NEAR(loop_area(feature.openings[0].through), pi * 25, 1e-8);
    EXPECT_NEAR(loop_area(feature.openings[0].pilot), area, 1e-8);
    ASSERT_EQ(feature.openings[0].pilot.size(), 1u);
    const Arc& pilot = std::get<Arc>(feature.openings[0].pilot.front().curve);
    const Arc& hole = std::get<Arc>(feature.openings[0].through.front().curve);
    EXPECT_NEAR((pilot.center - hole.center).norm(), 0.0, 1e-12);
    EXPECT_NEAR(pilot.radius, std::sqrt(area / pi), 1e-9);
    EXPECT_LT(pilot.sweep, 0.0) << "openings run clockwise";
  }
}

TEST(ExtrudedHole, IsPiercedAsItIsWhereItsCollarHoldsMoreThanItsHole) {
  const Sheet sheet = sheet_of(extruded(8, 2.0), kTop);
  const FormedOpening& opening = sheet.features.front().openings.at(0);
  EXPECT_NEAR(loop_area(opening.pilot), pi * 25, 1e-8);
}

TEST(ExtrudedHole, KeepsTheVolumeInTheFlatPattern) {
  const SolidModel model = extruded(1.5, 1.0);
  const Sheet sheet = sheet_of(model, kTop);
  for (const auto cut : {ExtrudedHoles::pilot, ExtrudedHoles::through, ExtrudedHoles::outline}) {
    const auto flat = flatten(sheet, {.extruded = cut});
    ASSERT_TRUE(flat) << flat.error().message;
    EXPECT_EQ(flat->openings.size(), cut == ExtrudedHoles::outline ? 0u : 1u);
    EXPECT_EQ(flat->features.front().uncut_openings, cut == ExtrudedHoles::outline ? 1 : 0);
    EXPECT_EQ(flat->features.front().pilots.size(), cut == ExtrudedHoles::pilot ? 1u : 0u);
    const auto certificate = certify(sheet, *flat, EdgeDistance());
    ASSERT_TRUE(certificate);
    EXPECT_NEAR(*certificate->explained_ratio, 1.0, 1e-9);
    if (cut == ExtrudedHoles::pilot) {
      EXPECT_NEAR(*certificate->volume_ratio, 1.0, 1e-9);
    }
  }
}

/// Pressed up by 3 mm from a sheet of 2 mm, with a hole of radius 5 in its top.
SolidModel embossed() {
  return plate(2, {100, 60},
               {{{40, 30}, {{20, 2}, {16, 5}, {5, 5}, {5, 3}, {14.5, 3}, {18.5, 0}}}});
}

TEST(Emboss, HasTheHoleOfItsTop) {
  for (const int reference : {kTop, kBottom}) {
    const Sheet sheet = sheet_of(embossed(), reference);
    ASSERT_EQ(sheet.features.size(), 1u);
    const FormedFeature& feature = sheet.features.front();
    ASSERT_EQ(feature.openings.size(), 1u);
    EXPECT_NEAR(loop_area(feature.openings[0].through), pi * 25, 1e-8);
    EXPECT_NEAR(loop_area(feature.openings[0].pilot), pi * 25, 1e-8)
        << "it is stretched, not drawn from its hole";
  }
}

struct Seen {
  Sheet sheet;
  FlatPattern flat;
  OpeningCount openings;
  double refold = 0.0;
};

Seen seen_in(const TopoDS_Shape& shape, ExtrudedHoles extruded = ExtrudedHoles::pilot) {
  const auto text = guarded([&] { return step_text(shape, "part"); });
  const auto file = read_step_text(text.value(), "part.step");
  auto found = recognize(file.value().bodies.front());
  EXPECT_TRUE(found) << found.error().message;
  if (!found) return {};
  auto flat = flatten(found->sheet, {.extruded = extruded});
  EXPECT_TRUE(flat) << flat.error().message;
  const auto certificate = certify(found->sheet, *flat, found->distance);
  EXPECT_TRUE(certificate) << certificate.error().message;
  return {found->sheet, *flat, certificate->openings, certificate->refold_deviation.value_or(0.0)};
}

TopoDS_Shape block(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

/// A dome with a flat top, 1 mm of sheet all over: 40 × 20 from (30, 20), 3 mm high.
TopoDS_Shape dome(const TopoDS_Shape& plate) {
  return BRepAlgoAPI_Cut(BRepAlgoAPI_Fuse(plate, block({30, 20, 0}, {70, 40, 4})).Shape(),
                         block({31, 21, -1}, {69, 39, 3}));
}

TEST(Emboss, HasEachOfItsHoles) {
  for (const int count : {1, 3}) {
    TopoDS_Shape part = dome(block({0, 0, 0}, {100, 60, 1}));
    for (int i = 0; i < count; ++i) {
      const gp_Ax2 axis(gp_Pnt(40 + 10 * i, 30, -1), gp_Dir(0, 0, 1));
      part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 3, 10).Shape());
    }
    const Seen seen = seen_in(part);
    EXPECT_EQ(seen.openings.solid, count);
    EXPECT_EQ(seen.openings.pattern, count);
    EXPECT_EQ(seen.openings.features, 0);
    ASSERT_EQ(std::ssize(seen.flat.openings), count);
    for (const Contour& opening : seen.flat.openings) {
      ASSERT_EQ(opening.loop.size(), 1u);
      EXPECT_NEAR(std::get<Arc>(opening.loop.front()).radius, 3.0, 1e-6);
    }
    EXPECT_LT(seen.refold, 1e-3);
  }
}

TEST(Emboss, WithoutAHoleIsNotCut) {
  const Seen seen = seen_in(dome(block({0, 0, 0}, {100, 60, 1})));
  EXPECT_EQ(seen.openings.solid, 0);
  EXPECT_EQ(seen.openings.pattern, 0);
  EXPECT_TRUE(seen.flat.openings.empty() && seen.flat.slits.empty());
}

TEST(Louvre, IsCutAlongItsFreeEdge) {
  // The dome reaches the edge of its block at y = 20 and is open there.
  TopoDS_Shape part = BRepAlgoAPI_Fuse(block({0, 0, 0}, {100, 60, 1}),
                                       block({30, 20, 0}, {70, 40, 4}));
  part = BRepAlgoAPI_Cut(part, block({31, 20, -1}, {69, 39, 3}));
  const Seen seen = seen_in(part);
  EXPECT_EQ(seen.openings.solid, 1);
  EXPECT_EQ(seen.openings.pattern, 1);
  EXPECT_TRUE(seen.flat.openings.empty());
  ASSERT_EQ(seen.flat.slits.size(), 1u);
  EXPECT_NEAR(length(seen.flat.slits.front()), 38.0, 1e-6);
  EXPECT_LT(seen.refold, 1e-3);
  EXPECT_EQ(seen.flat.features.size(), 1u) << "its outline is drawn";
  const Seen outlined = seen_in(part, ExtrudedHoles::outline);
  EXPECT_TRUE(outlined.flat.slits.empty());
  EXPECT_EQ(outlined.openings.features, 1);
  EXPECT_EQ(outlined.openings.lost(), 0);
}

TEST(Bridge, IsCutAlongBothItsEdges) {
  BRepBuilderAPI_MakePolygon arch;
  for (const auto& [x, z] :
       {std::pair{40, 0}, {44, 4}, {56, 4}, {60, 0}, {60, 1}, {56, 5}, {44, 5}, {40, 1}})
    arch.Add(gp_Pnt(x, 20, z));
  arch.Close();
  const TopoDS_Shape strap = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(arch.Wire()).Shape(),
                                                   gp_Vec(0, 12, 0))
                                 .Shape();
  const TopoDS_Shape window = BRepAlgoAPI_Cut(block({0, 0, 0}, {100, 60, 1}),
                                              block({40, 20, -1}, {60, 32, 2}));
  const Seen seen = seen_in(BRepAlgoAPI_Fuse(window, strap));
  EXPECT_EQ(seen.openings.solid, 2);
  EXPECT_EQ(seen.openings.pattern, 2);
  EXPECT_TRUE(seen.flat.openings.empty());
  EXPECT_EQ(seen.flat.slits.size(), 2u);
}

TEST(Lance, ThatIsBentUpIsAnOpeningOfTheSheet) {
  // Folded sharply at the side x = 40 of the window that it left.
  TopoDS_Shape part = BRepAlgoAPI_Cut(block({0, 0, 0}, {100, 60, 1}),
                                      block({40, 20, -1}, {60, 30, 2}));
  part = BRepAlgoAPI_Fuse(part, block({40, 20, 0}, {41, 30, 15}));
  const Seen seen = seen_in(part);
  EXPECT_EQ(seen.openings.solid, 1);
  EXPECT_EQ(seen.openings.pattern, 1);
  EXPECT_EQ(seen.flat.openings.size(), 1u);
}

/// An angle of 4 mm, bent with an inside radius of 10 at x = 100, with a boss on the inside. One
/// hole leads straight through the boss, the other at a slant to the outside of the bend.
TopoDS_Shape angle_with_boss() {
  const gp_Ax2 bend(gp_Pnt(100, 0, 14), gp_Dir(0, 1, 0));
  TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(bend, 14, 60).Shape(),
                                      BRepPrimAPI_MakeCylinder(bend, 10, 60).Shape());
  part = BRepAlgoAPI_Common(part, block({100, 0, 0}, {114, 60, 14}));
  for (const TopoDS_Shape& more :
       {block({0, 0, 0}, {100, 60, 4}), block({110, 0, 14}, {114, 60, 60}),
        block({70, 20, 3}, {99.5, 40, 6})})
    part = BRepAlgoAPI_Fuse(part, more);
  const gp_Ax2 straight(gp_Pnt(75, 30, -1), gp_Dir(0, 0, 1)),
      slanted(gp_Pnt(90, 30, 12), gp_Dir(1, 0, -1));  // out at about (102, 0.1)
  part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(straight, 2, 20).Shape());
  return BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(slanted, 0.5, 30).Shape());
}

/// Seen in the plane of the flange such a hole is not where it is drilled. The inside is seen where
/// a pad makes the outside the smaller skin.
TEST(Boss, WithAHoleThatLeavesThroughABendIsNotCutWhicheverSkinIsSeen) {
  for (const bool pad : {false, true}) {
    TopoDS_Shape part = angle_with_boss();
    if (pad) part = BRepAlgoAPI_Fuse(part, block({10, 10, -0.5}, {40, 50, 1}));
    const Seen seen = seen_in(part);
    EXPECT_EQ(seen.openings.solid, 2);
    EXPECT_TRUE(seen.flat.openings.empty() && seen.flat.slits.empty()) << pad;
    EXPECT_EQ(seen.openings.lost(), 2) << pad;
    EXPECT_EQ(seen.openings.missing.size(), 1u) << "in one form";
  }
}

TEST(Plate, HasTheHolesOfItsSolid) {
  TopoDS_Shape part = block({0, 0, 0}, {100, 60, 1});
  for (int i = 0; i < 5; ++i) {
    const gp_Ax2 axis(gp_Pnt(15 + 15 * i, 30, -1), gp_Dir(0, 0, 1));
    part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 3, 10).Shape());
    const Seen seen = seen_in(part);
    EXPECT_EQ(seen.openings.solid, i + 1);
    EXPECT_EQ(seen.openings.pattern, i + 1);
  }
}

}  // namespace
}  // namespace planish::brep::test
