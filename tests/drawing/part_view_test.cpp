#include "support/sheets.hpp"

#include <planish/drawing/part_view.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::drawing {
namespace {

using namespace planish::test;

// In an isometric view lines along the axes have √(2/3) of their length.
const double kShort = std::sqrt(2.0 / 3.0);
constexpr double kThin = 0.02;  // mm: drawn without thickness

/// In the coordinates of the first flange, its reference side up.
PartView view_of(const Sheet& sheet) {
  FlattenOptions options;
  options.keep_root = true;
  options.up = UpSide::reference;
  const auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat) << flat.error().message;
  return isometric_view(sheet, flat->layout);
}

double length_of(const std::vector<std::vector<Vec2>>& lines) {
  double sum = 0.0;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      sum += (line[i] - line[i - 1]).norm();
  return sum;
}

Box2 box_of(const PartView& view) {
  Box2 box;
  for (const auto& line : view.edges)
    for (const Vec2& p : line)
      box.add(p);
  return box;
}

TEST(IsometricView, OfAFlatSheetIsItsOutline) {
  const PartView view = view_of(strip({Straight{100.0}}, 60.0, kThin));
  EXPECT_NEAR(length_of(view.edges), kShort * 2 * (100.0 + 60.0), 1e-9);
  EXPECT_TRUE(view.bends.empty());
  // To the right by x − y, up by x + y.
  EXPECT_NEAR(box_of(view).size().x(), std::sqrt(0.5) * (100.0 + 60.0), 1e-9);
  EXPECT_NEAR(box_of(view).size().y(), std::sqrt(1.0 / 6.0) * (100.0 + 60.0), 1e-9);
}

TEST(IsometricView, ShowsAFlangeThatStandsUpWhole) {
  const double height = 30.0, radius = 0.5;
  const PartView view = view_of(
      strip({Straight{50.0}, Turn{Angle::degrees(90), radius, BendDirection::up}, Straight{height}},
            40.0, kThin));
  // Two sides of the floor, three of the flange; the arcs of the bend are short.
  const double edges = 40.0 + 2 * 50.0 + 2 * height + 40.0;
  EXPECT_NEAR(length_of(view.edges), kShort * edges, 4.0 * radius);
  EXPECT_NEAR(length_of(view.bends), kShort * 2 * 40.0, 0.5);
}

TEST(IsometricView, LeavesOutWhatTheSheetHides) {
  // The flange hangs down behind the far edge of the floor. A point `depth` below the floor is
  // seen only where the line towards the viewer, (−1, −1, 1), leaves the floor at its side.
  const double height = 30.0, radius = 0.5, width = 40.0;
  const PartView view = view_of(strip(
      {Straight{50.0}, Turn{Angle::degrees(90), radius, BendDirection::down}, Straight{height}},
      width, kThin));
  const double depth = height + radius;
  // The floor's three edges, the near side of the flange, the seen part of its lower edge; its far
  // side is hidden.
  const double edges = width + 2 * 50.0 + height + depth;
  EXPECT_NEAR(length_of(view.edges), kShort * edges, 6.0 * radius);
}

TEST(IsometricView, ShowsTheThicknessOfASheet) {
  const PartView view = view_of(strip({Straight{100.0}}, 60.0, 10.0));
  // A block: nine of its twelve edges.
  EXPECT_NEAR(length_of(view.edges), kShort * (2 * 160.0 + 160.0 + 3 * 10.0), 1.0);
}

TEST(IsometricView, IsKeptAsText) {
  const PartView view = view_of(l_bracket());
  const auto again = read_view_json(view_json(view));
  ASSERT_TRUE(again);
  EXPECT_EQ(view_json(*again), view_json(view));
  EXPECT_NEAR(length_of(again->edges), length_of(view.edges), 0.5);
  EXPECT_FALSE(read_view_json("{}"));
  EXPECT_FALSE(read_view_json(view_json(view).substr(0, 60)));
}

}  // namespace
}  // namespace planish::drawing
