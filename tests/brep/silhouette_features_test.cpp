#include "silhouette_features.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <planish/sheet/pattern_facts.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

// Plates as milled after cutting: the blank, what is drawn of the rest, and the volume of it.

namespace planish::brep::test {
namespace {

using std::numbers::pi;

constexpr double kThickness = 3.0;

TopoDS_Shape block(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}
TopoDS_Shape bore(double x, double y, double r, double low, double high) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2({x, y, low}, {0, 0, 1}), r, high - low).Shape();
}
TopoDS_Shape sink(double x, double y, double low, double r_low, double high, double r_high) {
  return BRepPrimAPI_MakeCone(gp_Ax2({x, y, low}, {0, 0, 1}), r_low, r_high, high - low).Shape();
}

planish::test::UnfoldedShape unfolded(const std::vector<TopoDS_Shape>& cuts) {
  TopoDS_Shape shape = block({0, 0, 0}, {100, 60, kThickness});
  for (const TopoDS_Shape& cut : cuts)
    shape = BRepAlgoAPI_Cut(shape, cut).Shape();
  auto made = planish::test::unfolded_shape(shape);
  EXPECT_TRUE(made) << made.error().message;
  if (!made) return {};
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0.0), 1.0, 1e-9);
  EXPECT_LT(made->certificate.outline_error.value_or(0.0), 1e-9);
  EXPECT_LT(made->certificate.opening_error.value_or(0.0), 1e-9);
  return std::move(*made);
}

std::vector<std::string> kinds(const FlatPattern& flat) {
  return mapped(flat.features, [](const auto& feature) { return feature.kind; });
}

TEST(Silhouettes, KeepAHoleThatIsCountersunkThroughTheEdgeFromBothSides) {
  const auto [sheet, flat, certificate] = unfolded(
      {bore(20, 3, 2, 0, 3), sink(20, 3, 2, 2, 3, 4), sink(20, 3, 0, 4, 1, 2)});
  ASSERT_EQ(flat.openings.size(), 1u);
  EXPECT_NEAR(-signed_area(flat.openings.front().loop), 4 * pi, 1e-9);
  EXPECT_NEAR(outer_cutting_length(flat), 320.0, 1e-9);
  EXPECT_TRUE(flat.slits.empty());
  EXPECT_EQ(kinds(flat), (std::vector<std::string>{"chamfer", "chamfer"}));
}

TEST(Silhouettes, KeepTheOutlineWhereEdgesAreSteppedFromBothSides) {
  const auto [sheet, flat, certificate] = unfolded(
      {block({10, -1, 2}, {30, 4, 4}), block({20, -1, -1}, {50, 6, 1.2})});
  EXPECT_NEAR(flat.area, 6000.0, 1e-9);
  EXPECT_NEAR(outer_cutting_length(flat), 320.0, 1e-9);
  EXPECT_NEAR(sheet.forms_volume.value(), -(20 * 4 * 1 + 30 * 6 * 1.2), 1e-9);
}

TEST(Silhouettes, AreOpenWhereStepsFromBothSidesMeet) {
  const auto [sheet, flat, certificate] = unfolded(
      {block({10, -1, 1}, {30, 4, 4}), block({20, -1, -1}, {50, 6, 1.2})});
  EXPECT_NEAR(flat.area, 6000.0 - 10 * 4, 1e-9);
}

TEST(Silhouettes, CutEachHoleOfASharedRecess) {
  std::vector<TopoDS_Shape> cuts{block({20, 20, 0}, {80, 40, 0.5})};
  for (const double x : {25.0, 40.0, 60.0}) {
    cuts.push_back(bore(x, 30, 2.5, 0, 3));
    cuts.push_back(bore(x, 30, 4.5, 2, 3));
  }
  const auto [sheet, flat, certificate] = unfolded(cuts);
  ASSERT_EQ(flat.openings.size(), 3u);
  for (const Contour& opening : flat.openings)
    EXPECT_NEAR(-signed_area(opening.loop), 6.25 * pi, 1e-9);
  EXPECT_EQ(std::ranges::count(kinds(flat), "pocket"), 4) << "three bores above, the recess below";
}

TEST(Silhouettes, CountTunnelsThatNoCutShows) {
  // From edge to edge between the skins, so that nothing is seen through.
  const auto [sheet, flat, certificate] = unfolded({block({40, -1, 1}, {50, 61, 2})});
  EXPECT_NEAR(flat.area, 6000.0, 1e-9);
  EXPECT_TRUE(flat.openings.empty());
  EXPECT_EQ(sheet.genus, 1);
  EXPECT_EQ(certificate.openings.features, 1);
  EXPECT_EQ(certificate.openings.lost(), 0);
}

TEST(Silhouettes, DoNotTakeABlindBoreBesideAHoleForTheHole) {
  const auto [sheet, flat, certificate] = unfolded({bore(40, 30, 8, 0, 3), bore(30, 30, 5, 1, 3)});
  ASSERT_EQ(flat.openings.size(), 1u);
  EXPECT_NEAR(-signed_area(flat.openings.front().loop), 64 * pi, 1e-9);
}

TEST(Silhouettes, PartOneOutlineOfTheSkinIntoTheRimAndAHole) {
  // Recesses on both skins, each over a part of the hole and through the edge, beside a bend: the
  // skin's one outline is now the rim's, now the hole's.
  const auto upright = [](double x, double y, double from, double radius) {
    const gp_Ax2 axis(gp_Pnt(x, y, from), gp_Dir(0, 0, 1));
    return BRepPrimAPI_MakeCylinder(axis, radius, 4).Shape();
  };
  TopoDS_Shape part = planish::test::bent_bracket({2, 2, 40, 30, 50});
  for (const TopoDS_Shape& tool :
       {upright(20, 3, -1, 2.5), upright(21.5, 0, -3.5, 3), upright(18.5, 0, 1.5, 3)})
    part = BRepAlgoAPI_Cut(part, tool).Shape();
  const auto made = planish::test::unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  const double blank = 50 * (40 + 30 + 3 * std::numbers::pi / 2);
  EXPECT_NEAR(made->flat.area, blank - std::numbers::pi * 2.5 * 2.5, 1e-9);
  EXPECT_EQ(made->flat.openings.size(), 1u);
  EXPECT_EQ(made->flat.bends.size(), 1u);
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0.0), 1.0, 1e-9);
}

TEST(Silhouettes, KeepHolesThatAPocketOnTheOtherSkinJoinsOverABend) {
  // One of the holes is wider on this skin too, and a third is machined beside them.
  for (const bool above : {false, true}) {
    const auto pocket = [&](double x, double y, double to_x, double to_y, bool upper) {
      return upper ? block({x, y, 1.6}, {to_x, to_y, 3}) : block({x, y, -1}, {to_x, to_y, 0.4});
    };
    TopoDS_Shape part = planish::test::bent_bracket({2, 2, 40, 30, 50});
    for (const TopoDS_Shape& tool :
         {bore(30, 15, 3, -1, 3), bore(30, 32, 3, -1, 3), bore(12, 15, 3, -1, 3),
          pocket(24, 10, 40.8, 38, above), pocket(29, 8, 35, 22, !above),
          pocket(7, 14, 17, 16, !above), pocket(11, 9, 13, 19, above)})
      part = BRepAlgoAPI_Cut(part, tool).Shape();
    const auto made = planish::test::unfolded_shape(part);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->flat.openings.size(), 3u);
    for (const Contour& opening : made->flat.openings)
      EXPECT_NEAR(-signed_area(opening.loop), 9 * pi, 1e-9) << above;
    EXPECT_NEAR(made->flat.area, 50 * (40 + 30 + 3 * pi / 2) - 27 * pi, 1e-9);
    EXPECT_NEAR(made->certificate.explained_ratio.value_or(0.0), 1.0, 1e-9);
    EXPECT_LT(made->certificate.opening_error.value_or(0.0), 1e-9);
  }
}

TEST(Silhouettes, KeepHolesOfBothFlangesThatAPocketJoinsRoundTheBend) {
  // Drilled into either flange, joined inside, and each in a groove outside.
  const TopoDS_Shape other = BRepPrimAPI_MakeCylinder(gp_Ax2({41, 15, 14}, {1, 0, 0}), 3, 5);
  TopoDS_Shape part = planish::test::bent_bracket({2, 2, 40, 30, 50});
  for (const TopoDS_Shape& tool :
       {bore(30, 15, 3, -1, 3), other, block({25, 10, 1.6}, {42.4, 20, 18}),
        block({24, 14, -1}, {36, 16, 0.4}), block({43.6, 8, 10}, {46, 15, 20})})
    part = BRepAlgoAPI_Cut(part, tool).Shape();
  const auto made = planish::test::unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->flat.openings.size(), 2u);
  for (const Contour& opening : made->flat.openings)
    EXPECT_NEAR(-signed_area(opening.loop), 9 * pi, 1e-9);
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0.0), 1.0, 1e-9);
  EXPECT_LT(made->certificate.opening_error.value_or(0.0), 1e-9);
}

TEST(Silhouettes, AreMeasuredToTheDigitsOfTheFile) {
  // Bore and recess meet in a curve that is no line or arc; what is cut is none of it.
  const auto [sheet, flat, certificate] = unfolded(
      {bore(52.4893, 55.57, 6.23, 0, 3), sink(56.8257, 43.2265, 0, 8.0465, 1.7855, 5.6276)});
  EXPECT_EQ(kinds(flat), std::vector<std::string>{"pocket"});
}

TEST(Silhouettes, HoldBesideWallsWithADraft) {
  // From 100 × 60 on one skin the walls lean in by 0.06 on 3 mm; a step leaves 1.8 mm of them.
  const TopoDS_Shape plate = BRepPrimAPI_MakeWedge(100, 3, 60, 0.06, 0.06, 99.94, 59.94).Shape();
  const TopoDS_Shape stepped = BRepAlgoAPI_Cut(plate, block({-1, -1, 20}, {8, 1.2, 40})).Shape();
  const auto text = guarded([&] { return step_text(stepped, "plate"); });
  const auto file = read_step_text(text.value(), "plate.step");
  const auto found = recognize(file.value().bodies.front());
  ASSERT_TRUE(found) << found.error().message;
  const auto flat = flatten(found->sheet, {.allowance = ConstantK{0.5, "test"}});
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_NEAR(flat->area, 6000.0 - 20 * 0.06 * 1.2 / 3, 1e-6);
  const auto certificate = certify(found->sheet, *flat, found->distance);
  EXPECT_LT(certificate->outline_error.value(), 1e-9);
  EXPECT_NEAR(certificate->explained_ratio.value(), 1.0, 1e-9);
}

TEST(Silhouettes, AreNoSheetWhereMostIsMilledOff) {
  const TopoDS_Shape plate = block({0, 0, 0}, {100, 60, kThickness});
  const TopoDS_Shape milled = BRepAlgoAPI_Cut(plate, block({-1, -1, 1.5}, {60, 61, 4})).Shape();
  const auto text = guarded([&] { return step_text(milled, "plate"); });
  EXPECT_FALSE(recognize(read_step_text(text.value(), "plate.step").value().bodies.front()));
}

TEST(MeasuredOutline, TellsWhatReachesBeyondTheCut) {
  const auto [sheet, flat, certificate] = unfolded({block({10, -1, 2}, {30, 4, 4})});
  ASSERT_EQ(sheet.measured_outlines.size(), 1u);
  Sheet wrong = sheet;
  wrong.measured_outlines.front().beyond = 0.7;
  const auto doubted = certify(wrong, flat, {});
  EXPECT_NEAR(doubted->outline_error.value(), 0.7, 1e-12);
}

}  // namespace
}  // namespace planish::brep::test
