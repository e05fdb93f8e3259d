#include "support/sheets.hpp"

#include <planish/sheet/facets.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// What facets draw and cut of formed features.

namespace planish::test {
namespace {

using std::numbers::pi;

double covered_by(const Facets& facets) {
  double area = 0.0;
  for (const Facet& facet : facets.facets)
    for (const Polygon& polygon : facet.polygons) {
      area += ring_area(polygon.outer);
      for (const auto& hole : polygon.holes)
        area += ring_area(hole);
    }
  return area;
}

/// A plate of 100 × 60 with a collar drawn out of it: Ø 20 at its foot, Ø 12 once it is drawn, and
/// Ø 4 before.
Sheet plate_with_collar() {
  SheetBuilder builder(1.0);
  const Vec2 middle(40, 30);
  const FaceId face = builder.flange(Frame{}, {rectangle(100, 60), circular_opening(middle, 10)});
  Sheet sheet = builder.finish();
  FormedFeature collar;
  collar.kind = "formed";
  collar.face = face;
  collar.openings.push_back(
      {{{circular_opening(middle, 2).front()}}, {{circular_opening(middle, 6).front()}}});
  sheet[BorderRef{face, 1, 0}].feature = sheet.features.push_back(collar);
  return sheet;
}

TEST(FeatureBorders, LetTheSheetGoOnWithinFormsAsThePatternDoes) {
  const Sheet sheet = plate_with_collar();
  constexpr double kChord = 1e-4;
  const std::pair<ExtrudedHoles, double> holes[]{
      {ExtrudedHoles::pilot, 2.0}, {ExtrudedHoles::through, 6.0}, {ExtrudedHoles::outline, 0.0}};
  for (const auto& [extruded, radius] : holes) {
    FlattenOptions options;
    options.extruded = extruded;
    const auto flat = flat_sheet(sheet, options);
    ASSERT_TRUE(flat) << flat.error().message;
    const Facets facets = facets_of(sheet, flat->layout, {.chord = kChord, .extruded = extruded});
    EXPECT_NEAR(covered_by(facets), 6000 - std::numbers::pi * radius * radius,
                kChord * 2 * std::numbers::pi * radius + 1e-9);
  }
}

/// Whether some border of that length outlines a feature (is drawn), and whether some is cut.
std::pair<bool, bool> drawn_and_cut(const Facets& facets, double wanted) {
  std::pair<bool, bool> found{false, false};
  for (const auto& [curve, feature] : facets.borders)
    if (std::abs(length(curve) - wanted) < 1e-9) (feature ? found.first : found.second) = true;
  return found;
}

constexpr std::pair<bool, bool> kDrawn{true, false}, kCut{false, true}, kNeither{false, false};

Facets facets_with(const Sheet& sheet, ExtrudedHoles extruded) {
  FlattenOptions options;
  options.extruded = extruded;
  const auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat) << (flat ? "" : flat.error().message);
  return facets_of(sheet, flat->layout, {.chord = 1e-3, .extruded = extruded});
}

TEST(FeatureBorders, AreDrawnOrCutAsInThePattern) {
  const Sheet sheet = plate_with_collar();
  const auto pilot = facets_with(sheet, ExtrudedHoles::pilot),
             through = facets_with(sheet, ExtrudedHoles::through),
             outline = facets_with(sheet, ExtrudedHoles::outline);
  for (const Facets* facets : {&pilot, &through, &outline}) {
    EXPECT_EQ(drawn_and_cut(*facets, 20 * pi), kDrawn);  // the foot
    EXPECT_EQ(drawn_and_cut(*facets, 100), kCut);
  }
  EXPECT_EQ(drawn_and_cut(pilot, 4 * pi), kCut);
  EXPECT_EQ(drawn_and_cut(pilot, 12 * pi), kNeither);
  EXPECT_EQ(drawn_and_cut(through, 4 * pi), kNeither);
  EXPECT_EQ(drawn_and_cut(through, 12 * pi), kCut);
  EXPECT_EQ(drawn_and_cut(outline, 4 * pi), kNeither);
  EXPECT_EQ(drawn_and_cut(outline, 12 * pi), kDrawn);
}

TEST(FeatureBorders, DrawTheRimOfACountersinkAboutTheHole) {
  SheetBuilder builder(2.0);
  const Vec2 middle(40, 30);
  const FaceId face = builder.flange(Frame{}, {rectangle(100, 60), circular_opening(middle, 2)});
  Sheet sheet = builder.finish();
  FormedFeature countersink;
  countersink.kind = "countersink";
  countersink.face = face;
  countersink.outlines = {{{circular_opening(middle, 4).front()}}};
  const FeatureId id = sheet.features.push_back(countersink);
  const Facets facets = facets_with(sheet, ExtrudedHoles::pilot);
  EXPECT_EQ(drawn_and_cut(facets, 4 * pi), kCut);
  EXPECT_EQ(drawn_and_cut(facets, 8 * pi), kDrawn);
  EXPECT_NEAR(covered_by(facets), 6000 - 4 * pi, 1e-3 * 4 * pi);
  double drawn = 0.0;
  for (const FacetEdge& edge : facets.edges)
    if (facets.borders[edge.border].feature == id) drawn += (edge.line.b - edge.line.a).norm();
  EXPECT_NEAR(drawn / (8 * pi), 1.0, 1e-3);
}

TEST(FeatureBorders, CutTheFreeEdgeOfALouvre) {
  SheetBuilder builder(1.0);
  const FaceId face = builder.flange(
      Frame{}, {rectangle(100, 60), polygon({{20, 20}, {20, 28}, {57, 28}, {57, 20}})});
  Sheet sheet = builder.finish();
  FormedFeature louvre;
  louvre.kind = "formed";
  louvre.face = face;
  louvre.slits = {{{Segment{{20, 28}, {55, 28}}}}};
  sheet[BorderRef{face, 1, 0}].feature = sheet.features.push_back(louvre);
  const Facets cut = facets_with(sheet, ExtrudedHoles::pilot);
  EXPECT_EQ(drawn_and_cut(cut, 37), kDrawn);  // its outline, although one border names it
  EXPECT_EQ(drawn_and_cut(cut, 35), kCut);
  EXPECT_EQ(drawn_and_cut(facets_with(sheet, ExtrudedHoles::outline), 35), kNeither);
  EXPECT_NEAR(covered_by(cut), 6000, 1e-9);
}

}  // namespace
}  // namespace planish::test
