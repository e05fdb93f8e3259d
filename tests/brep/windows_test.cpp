#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Windows cut through both flanges of a bracket and the bend between them, with ends slanted by
// 45°: `outwards`, narrower on the outside of the bend, as those cut in one direction are; or
// inwards. Whichever skin the pattern follows elsewhere, each is cut as its narrowest section.

namespace planish::test {
namespace {

using std::numbers::pi;

constexpr double kThickness = 2, kFirst = 100, kSecond = 60, kWidth = 120;

BentBracket sizes(double radius) {
  return {.thickness = kThickness,
          .inside_radius = radius,
          .first = kFirst,
          .second = kSecond,
          .width = kWidth};
}

/// On the outside it ends 20 mm before the bend in either flange.
struct Window {
  double from, to;  ///< along the bend
  bool outwards = true;
};

TopoDS_Shape window_tool(double radius, const Window& of) {
  const double x = kFirst + radius + kThickness, z = kThickness + radius + 20;
  const double lean = of.outwards ? -1.0 : 1.0;  // of x over z
  BRepBuilderAPI_MakePolygon outline;
  const std::vector<std::pair<double, double>> corners{{80 - 2 * lean, -2},
                                                       {80 + 4 * lean, 4},
                                                       {x - 4, z - 4 * lean},
                                                       {x + 2, z + 2 * lean},
                                                       {x + 2, -2}};
  for (const auto& [px, pz] : corners)
    outline.Add(gp_Pnt(px, of.from, pz));
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(),
                               gp_Vec(0, of.to - of.from, 0))
      .Shape();
}

/// With K = ½.
double bend_length(double radius) { return pi / 2 * (radius + kThickness / 2); }

double window_area(double radius, const Window& of) {
  const double flange = of.outwards ? 20 : 20 - kThickness;
  return (of.to - of.from) * (2 * flange + bend_length(radius));
}

double sheet_area(double radius) { return kWidth * (kFirst + kSecond + bend_length(radius)); }

TopoDS_Shape with_windows(double radius, const std::vector<Window>& windows) {
  TopoDS_Shape shape = bent_bracket(sizes(radius));
  for (const Window& window : windows)
    shape = BRepAlgoAPI_Cut(shape, window_tool(radius, window)).Shape();
  return shape;
}

void expect_area(const TopoDS_Shape& shape, double area, int openings) {
  const auto seen = unfolded_shape(shape);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_EQ(std::ssize(seen->flat.openings), openings);
  EXPECT_NEAR(seen->flat.area, area, 1e-5);
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 2e-5);
  EXPECT_LT(seen->certificate.refold_deviation.value_or(0.0), 1e-5);
}

TEST(Windows, OverABendAreCutAsTheirNarrowestSectionOnEitherSkin) {
  for (const double radius : {1.0, 3.0, 8.0})
    for (const std::vector<Window>& windows :
         {std::vector<Window>{{20, 40, true}},
          {{20, 40, false}},
          {{20, 40, true}, {60, 80, false}},
          {{20, 40, true}, {60, 100, false}},
          {{20, 60, true}, {80, 100, false}},
          {{10, 30, true}, {40, 60, true}, {70, 110, false}}}) {
      double area = sheet_area(radius);
      for (const Window& window : windows)
        area -= window_area(radius, window);
      expect_area(with_windows(radius, windows), area, static_cast<int>(windows.size()));
    }
}

TEST(Windows, TellHowFarTheOtherSkinLiesOffWhereTheyLeanBothWays) {
  // Both ends lean by the same angle, so on one the solid reaches beyond what is cut along either
  // skin, on the other it ends within: by T tan of it.
  for (const double lean : {1.0, -1.0, 0.5}) {
    const double x = kFirst + 3 + kThickness, z = kThickness + 3 + 20;
    BRepBuilderAPI_MakePolygon outline;
    for (const auto& [px, pz] : std::vector<std::pair<double, double>>{{80 - 2 * lean, -2},
                                                                       {80 + 4 * lean, 4},
                                                                       {x - 4, z + 4 * lean},
                                                                       {x + 2, z - 2 * lean},
                                                                       {x + 2, -2}})
      outline.Add(gp_Pnt(px, 30, pz));
    outline.Close();
    const TopoDS_Shape tool = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(),
                                                    gp_Vec(0, 50, 0))
                                  .Shape();
    const auto seen = unfolded_shape(BRepAlgoAPI_Cut(bent_bracket(sizes(3)), tool).Shape());
    ASSERT_TRUE(seen) << seen.error().message;
    double beyond = 0.0, within = 0.0;
    for (const FlatFeature& feature : seen->flat.features) {
      beyond = std::max(beyond, feature.beyond_cut.value_or(0.0));
      within = std::min(within, feature.beyond_cut.value_or(0.0));
    }
    EXPECT_NEAR(beyond, kThickness * std::abs(lean), 1e-6);
    EXPECT_NEAR(within, -kThickness * std::abs(lean), 1e-6);
  }
}

TEST(Windows, MayBeRoundHolesAlongTheBisector) {
  // The wider window makes the inside the reference skin; the hole is narrower on the outside.
  const double radius = 3, hole = 9, outside = radius + kThickness;
  const double middle = kFirst + (radius + 1) * std::sqrt(0.5);
  const gp_Ax2 axis(gp_Pnt(middle - 30, 30, outside - (radius + 1) * std::sqrt(0.5) + 30),
                    gp_Dir(1, 0, -1));
  const Window other{60, 110, false};
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(with_windows(radius, {other}),
                                             BRepPrimAPI_MakeCylinder(axis, hole, 80).Shape())
                                 .Shape();
  // Seen along the bisector, the outside lies `outside sin θ` off it over the bend.
  constexpr int kSteps = 20000;
  const auto chord = [&](double v) { return 2 * std::sqrt(std::max(0.0, hole * hole - v * v)); };
  const double edge = outside * std::sqrt(0.5);
  double area = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    area += chord(outside * std::sin(share * pi / 4)) * (pi / 4) / kSteps * 2 * (radius + 1);
    area += chord(std::lerp(edge, hole, share)) * (hole - edge) / kSteps * 2 * std::sqrt(2.0);
  }
  const auto seen = unfolded_shape(shape);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, sheet_area(radius) - window_area(radius, other) - area, 1e-3);
  EXPECT_LT(seen->certificate.refold_deviation.value_or(0.0), 1e-4);
}

}  // namespace
}  // namespace planish::test
