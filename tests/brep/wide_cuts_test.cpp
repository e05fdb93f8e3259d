#include "wide_cuts.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <gp_Ax3.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace planish::test {
namespace {

/// With a hole of radius 5 right over the bend, chamfered on both skins.
TopoDS_Shape chamfered_over_bend(double by) {
  const std::vector<std::pair<double, double>> profile{
      {0, -5}, {5 + by, -5}, {5 + by, 0}, {5, by}, {5, 2 - by}, {5 + by, 2}, {5 + by, 9}, {0, 9}};
  BRepBuilderAPI_MakeWire wire;
  const auto at = [&](size_t i) {
    return gp_Pnt(profile[i % profile.size()].first, 25, profile[i % profile.size()].second);
  };
  for (size_t i = 0; i < profile.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(at(i), at(i + 1)).Edge());
  const gp_Ax1 axis(gp_Pnt(0, 25, 0), gp_Dir(0, 0, 1));
  const auto face = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  return BRepAlgoAPI_Cut(gently_bent(), BRepPrimAPI_MakeRevol(face, axis).Shape());
}

/// A bracket of 2 mm milled by boxes; its first flange ends at x = 40, its inside is at z = 2.
TopoDS_Shape milled_bracket(const std::vector<std::pair<gp_Pnt, gp_Pnt>>& boxes) {
  TopoDS_Shape part = bent_bracket({2, 2, 40, 30, 50});
  for (const auto& [from, to] : boxes)
    part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeBox(from, to).Shape()).Shape();
  return part;
}

TEST(WideCuts, AreLeftAtTheEndOfABendThatIsMilledOnTheWiderSkin) {
  // The end of the bend is milled on one skin and, which makes that the wider one, the end of the
  // flange on the other. Nothing is cut off.
  const double blank = 50 * (40 + 30 + 3 * std::numbers::pi / 2);
  for (const TopoDS_Shape& part :
       {milled_bracket({{{33, -1, 1.4}, {41, 5, 4.9}}, {{-1, 8, -1}, {8, 42, 0.6}}}),
        milled_bracket({{{33, -1, 1.4}, {41.5, 5, 4.9}}, {{-1, 8, -1}, {8, 42, 0.6}}}),
        milled_bracket({{{33, -1, -1}, {43, 5, 0.6}}, {{-1, 8, 1.4}, {8, 42, 3}}})}) {
    const auto made = unfolded_shape(part);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_NEAR(made->flat.area, blank, 1e-6);
    EXPECT_TRUE(made->flat.openings.empty() && made->flat.slits.empty());
    EXPECT_LT(made->certificate.outline_error.value_or(0), 1e-6);
  }
}

TEST(WideCuts, AreMeasuredAtTheEndsOfABendThatAreMilledOnEitherSkin) {
  // Neither skin is whole at the bend, so the pattern lacks what is left below one of the recesses.
  const auto made = unfolded_shape(
      milled_bracket({{{33, -1, -1}, {43, 5, 0.6}}, {{33, 45, 1.4}, {41, 51, 4.9}}}));
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_LT(made->flat.area, 50 * (40 + 30 + 3 * std::numbers::pi / 2) - 0.1);
  EXPECT_GT(made->certificate.outline_error.value_or(0), 0.5);
}

TEST(WideCuts, AreMeasuredWherePocketsOnBothSkinsRunOverABendAndOverHolesOrAnEdge) {
  // Bores of radius 3 beside the bend, in pockets that both reach 0.8 mm into it.
  const double blank = 50 * (40 + 30 + 3 * std::numbers::pi / 2);
  const auto above = [](double x, double y, double to_x, double to_y) {
    return std::pair{gp_Pnt(x, y, 1.6), gp_Pnt(to_x, to_y, 3.5)};
  };
  const auto below = [](double x, double y, double to_x, double to_y) {
    return std::pair{gp_Pnt(x, y, -1), gp_Pnt(to_x, to_y, 0.4)};
  };
  for (const auto& [holes, pockets] :
       {std::pair{2, std::vector{above(24, 10, 40.8, 38), below(23, 8, 40.7, 20)}},
        std::pair{1, std::vector{above(24, 10, 40.8, 55), below(23, 8, 40.7, 20)}},
        std::pair{1, std::vector{above(24, 10, 40.8, 55), below(23, -5, 40.7, 20)}}}) {
    TopoDS_Shape part = milled_bracket(pockets);
    for (int i = 0; i < holes; ++i) {
      const gp_Ax2 axis(gp_Pnt(30, 15 + 17 * i, -1), gp_Dir(0, 0, 1));
      part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 3, 4).Shape());
    }
    const auto made = unfolded_shape(part);
    ASSERT_TRUE(made) << made.error().message;
    const double off = blank - holes * 9 * std::numbers::pi - made->flat.area;
    const double told = std::max(made->certificate.opening_error.value_or(0),
                                 made->certificate.outline_error.value_or(0));
    EXPECT_TRUE(std::abs(off) < 1e-6 || told > 0.5) << off << " mm² less, " << told;
  }
}

TEST(WideCuts, AreMeasuredWhereAHoleIsMachinedOverAWholeBend) {
  const auto made = unfolded_shape(chamfered_over_bend(0.3));
  ASSERT_TRUE(made) << made.error().message;
  const double error = made->certificate.opening_error.value_or(0);
  EXPECT_GT(error, 0.28) << "in the middle of the bend the chamfer is 0.3 wide";
  EXPECT_LT(error, 1.0);
}

TEST(WideCuts, AreMeasuredWhereAHoleIsSunkOverBothTangentLines) {
  // A bend of 90° round 1 mm, drilled square in its middle with 2.5 mm, sunk by 0.8 mm on each
  // skin.
  const double root = std::sqrt(0.5), r = 3;
  const std::vector<std::pair<double, double>> profile{{0, -9},    {3.3, -9}, {3.3, 0}, {2.5, 0.8},
                                                       {2.5, 1.2}, {3.3, 2},  {3.3, 9}, {0, 9}};
  BRepBuilderAPI_MakeWire wire;
  const auto at = [&](size_t i) {
    return gp_Pnt(profile[i % profile.size()].first, 0, profile[i % profile.size()].second);
  };
  for (size_t i = 0; i < profile.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(at(i), at(i + 1)).Edge());
  const auto face = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  gp_Trsf placed;
  placed.SetTransformation(gp_Ax3(gp_Pnt(40 + r * root, 25, r - r * root), gp_Dir(-root, 0, root)),
                           gp_Ax3());
  auto drill = BRepBuilderAPI_Transform(BRepPrimAPI_MakeRevol(face, gp::OZ()).Shape(), placed);
  const auto made = unfolded_shape(
      BRepAlgoAPI_Cut(bent_bracket({2, 1, 40, 30, 50}), drill.Shape()));
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->certificate.opening_error.value_or(0), 0.8, 0.05);
}

TEST(WideCuts, AreMeasuredOverTheFlangesToo) {
  // A window of 14 × 8 mm, sunk from the outside at 45° to 0.5 mm above the middle of the bend:
  // where the flanges begin, 4 (1 − cos 10°) above it, they are cut along the sink.
  TopoDS_Shape window = BRepPrimAPI_MakeBox(gp_Pnt(-7, 21, -9), gp_Pnt(7, 29, 9));
  TopoDS_Shape sink = BRepPrimAPI_MakeWedge(
      gp_Ax2(gp_Pnt(-9.5, 31.5, -2), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), 19, 2.5, 13, 2.5, 2.5,
      16.5, 10.5);
  const auto made = unfolded_shape(BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(gently_bent(), window), sink));
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->flat.openings.size(), 1u);
  const double sunk = 0.5 - 4 * (1 - std::cos(std::numbers::pi / 18));
  const double width = bounds(made->flat.openings.front().loop).size().minCoeff();
  EXPECT_NEAR(width, 8 + 2 * sunk, 1e-3);
  EXPECT_NEAR(made->certificate.opening_error.value_or(0), sunk, 0.05);
}

}  // namespace
}  // namespace planish::test
