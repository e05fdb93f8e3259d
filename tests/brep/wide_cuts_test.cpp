#include "wide_cuts.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax3.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace planish::test {
namespace {

/// A sheet of 2 mm, bent by 20° round the radius 2, symmetric about x = 0, its outside at z = 0.
TopoDS_Shape gently_bent() {
  const double half = std::numbers::pi / 18;
  const auto at = [&](double radius, double turn, double along) {
    return gp_Pnt(radius * std::sin(turn) + std::copysign(along, turn) * std::cos(turn), 0,
                  4 - radius * std::cos(turn) + along * std::sin(std::abs(turn)));
  };
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](const gp_Pnt& a, const gp_Pnt& b) {
    wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
  };
  const auto bend = [&](double radius, double from) {
    const auto arc = GC_MakeArcOfCircle(at(radius, from, 0), at(radius, 0, 0),
                                        at(radius, -from, 0));
    wire.Add(BRepBuilderAPI_MakeEdge(arc.Value()).Edge());
  };
  line(at(4, -half, 40), at(4, -half, 0));
  bend(4, -half);
  line(at(4, half, 0), at(4, half, 40));
  line(at(4, half, 40), at(2, half, 40));
  line(at(2, half, 40), at(2, half, 0));
  bend(2, half);
  line(at(2, -half, 0), at(2, -half, 40));
  line(at(2, -half, 40), at(4, -half, 40));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 50, 0))
      .Shape();
}

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

}  // namespace
}  // namespace planish::test
