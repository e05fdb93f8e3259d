#include "bend_openings.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp_Ax3.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// Holes drilled square into a bend, sunk or bored on its outside, its inside or both. Of the
// drilled wall the pattern has the outermost end, which closes the opening most.

namespace planish::test {
namespace {

using std::numbers::pi;
using BoreProfile = std::vector<std::pair<double, double>>;  // radius, depth below the outside

constexpr double kBored = 2.5;
constexpr double kSink = 0.8, kInnerSink = 1.2;  // where sinks and bores end

const BoreProfile kOutside{{0, -9}, {3.3, -9}, {3.3, 0}, {kBored, kSink}, {kBored, 9}, {0, 9}};
const BoreProfile kInside{{0, -9},    {kBored, -9}, {kBored, kInnerSink},
                          {3.3, 2.0}, {3.3, 9},     {0, 9}};
const BoreProfile kBoth{{0, -9},  {3.3, -9}, {3.3, 0}, {kBored, kSink}, {kBored, kInnerSink},
                        {3.3, 2}, {3.3, 9},  {0, 9}};
const BoreProfile kBores{
    {0, -9},           {3.5, -9}, {3.5, kSink}, {kBored, kSink}, {kBored, kInnerSink},
    {3.5, kInnerSink}, {3.5, 9},  {0, 9}};
const BoreProfile kCones{{0, -9}, {3.5, -9}, {3.5, 0}, {kBored, 1}, {3.5, 2}, {3.5, 9}, {0, 9}};
const BoreProfile kPlain{{0, -9}, {kBored, -9}, {kBored, 9}, {0, 9}};

/// The body of revolution of a profile about the way into the sheet from a point of its outside.
TopoDS_Shape bore_tool(const BoreProfile& profile, const gp_Ax3& into) {
  BRepBuilderAPI_MakeWire wire;
  const auto at = [&](size_t i) {
    return gp_Pnt(profile[i % profile.size()].first, 0, profile[i % profile.size()].second);
  };
  for (size_t i = 0; i < profile.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(at(i), at(i + 1)).Edge());
  const auto face = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  gp_Trsf placed;
  placed.SetTransformation(into, gp_Ax3());
  return BRepBuilderAPI_Transform(BRepPrimAPI_MakeRevol(face, gp::OZ()).Shape(), placed).Shape();
}

TopoDS_Shape bored_bracket(double inside_radius, const BoreProfile& profile) {
  const double root = std::sqrt(0.5), r = inside_radius + 2;
  const gp_Ax3 into(gp_Pnt(40 + r * root, 25, r - r * root), gp_Dir(-root, 0, root));
  const BentBracket bracket{2, inside_radius, 40, 30, 50};
  return BRepAlgoAPI_Cut(bent_bracket(bracket), bore_tool(profile, into)).Shape();
}

/// Twice ∫ ρ turn(x) dy over a circle, ρ the middle radius of a sheet of 2 mm: the opening, flat.
double flat_area(double inside_radius, const std::function<double(double)>& turn) {
  constexpr int kSteps = 4000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = pi * (i + 0.5) / kSteps;  // y = −r cos a
    sum += turn(kBored * std::sin(a)) * kBored * std::sin(a);
  }
  return 2 * (inside_radius + 1) * sum * pi / kSteps;
}

struct Cut {
  double area = 0.0;
  std::vector<FormSide> sinks;
};

void expect_cut(const TopoDS_Shape& part, const Cut& cut) {
  const auto made = unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->flat.openings.size(), 1u);
  EXPECT_NEAR(signed_area(made->flat.openings.front().loop), -cut.area, 1e-3);
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1.0, 1e-6);
  std::vector<FormSide> sinks;
  for (const FlatFeature& feature : made->flat.features)
    if (feature.kind == "countersink") sinks.push_back(feature.side);
  EXPECT_EQ(sinks.size(), cut.sinks.size());
  const auto both = std::ranges::count(sinks, FormSide::both);
  EXPECT_EQ(both, std::ranges::count(cut.sinks, FormSide::both));
}

TEST(BendOpenings, AreCutAtTheOutermostEndOfTheirWall) {
  for (const double inside_radius : {6.0, 20.0}) {
    const double outside = inside_radius + 2;
    const auto area_at = [&](double depth) {
      return flat_area(inside_radius, [&](double x) { return std::atan(x / (outside - depth)); });
    };
    const double on_skin = flat_area(inside_radius,
                                     [&](double x) { return std::asin(x / outside); });
    const auto expect = [&](const BoreProfile& profile, const Cut& cut) {
      expect_cut(bored_bracket(inside_radius, profile), cut);
    };
    expect(kOutside, {area_at(kSink), {FormSide::up}});
    expect(kInside, {on_skin, {FormSide::up}});
    expect(kBoth, {area_at(kSink), {FormSide::both}});
    expect(kBores, {area_at(kSink), {FormSide::both}});
    expect(kCones, {area_at(1.0), {FormSide::both}});
  }
}

TEST(BendOpenings, MayReachOverBothTangentLinesOnTheInside) {
  const double area = flat_area(3, [](double x) { return std::atan(x / (5 - kSink)); });
  expect_cut(bored_bracket(3, kOutside), {area, {FormSide::up}});
  expect_cut(bored_bracket(3, kBoth), {area, {FormSide::both}});
}

TEST(BendOpenings, AreLeftAloneWhereTheyAreDrilledOnly) {
  const auto made = unfolded_shape(bored_bracket(6, kPlain));
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(-signed_area(made->flat.openings.front().loop),
              flat_area(6, [](double x) { return std::asin(x / 8); }), 1e-3);
  EXPECT_TRUE(std::ranges::none_of(made->flat.features, [](const FlatFeature& feature) {
    return feature.kind == "countersink";
  }));
}

TEST(BendOpenings, BesideTheMiddleOfTheirDrillAreCutWhereEitherEndIsInnermost) {
  // Drilled 2 mm beside the axis of a bend, of radii 20 and 22.
  const double root = std::sqrt(0.5), aside = 2.0;
  const gp_Ax3 into(gp_Pnt(40 + (22 + aside) * root, 25, 22 - (22 - aside) * root),
                    gp_Dir(-root, 0, root));
  const auto area_between = [&](double outer, double inner) {  // depths of the wall's ends
    constexpr int kSteps = 200000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double a = pi * (i + 0.5) / kSteps, half = kBored * std::sin(a);
      const auto turn = [](double x, double depth) {
        const bool skin = depth == 0.0 || depth == 2.0;
        return skin ? std::asin(x / (22 - depth)) : std::atan(x / (22 - depth));
      };
      const double low = aside - half;
      sum += std::max(0.0, turn(aside + half, outer) - turn(low, low < 0 ? outer : inner)) * half;
    }
    return 21 * sum * pi / kSteps;
  };
  const TopoDS_Shape bracket = bent_bracket({2, 20, 40, 30, 50});
  for (const auto& [profile, area] : {std::pair{kPlain, area_between(0, 2)},
                                      std::pair{kBores, area_between(kSink, kInnerSink)}}) {
    const auto made = unfolded_shape(BRepAlgoAPI_Cut(bracket, bore_tool(profile, into)));
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->flat.openings.size(), 1u);
    EXPECT_NEAR(-signed_area(made->flat.openings.front().loop), area, 1e-3);
  }
}

TEST(BendOpenings, OfAConeAreCutAlike) {
  // A wall of 2 mm that leans by 20°, its outside 40 mm from the axis where it is drilled.
  const double lean = pi / 9, c = std::cos(lean), s = std::sin(lean);
  const auto at = [&](double along, double depth) {
    return gp_Pnt(40 + along * s - depth * c, 0, along * c + depth * s);
  };
  BRepBuilderAPI_MakeWire wire;
  const std::vector<gp_Pnt> corners{at(-20, 0), at(20, 0), at(20, 2), at(-20, 2)};
  for (size_t i = 0; i < corners.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]).Edge());
  gp_Trsf back;  // so that the drill is in the middle of the wall's turn
  back.SetRotation(gp::OZ(), -pi / 2);
  const auto section = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  const TopoDS_Shape wall = BRepBuilderAPI_Transform(
                                BRepPrimAPI_MakeRevol(section, gp::OZ(), pi).Shape(), back)
                                .Shape();
  const gp_Ax3 into(at(0, 0), gp_Dir(-c, 0, s));
  // A circle's points onto the cone half-way between the skins, and that to a sector.
  const double apex = -40 / std::tan(lean);
  double area = 0.0, last_radius = 0.0, last_turn = 0.0;
  constexpr int kSteps = 100000;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = 2 * pi * i / kSteps;
    const gp_Pnt p = at(kBored * std::sin(a), kSink);
    const double y = kBored * std::cos(a);
    const double along = std::hypot(p.X(), y) * s + (p.Z() - apex) * c;
    const double radius = along - 1 / std::tan(lean), turn = std::atan2(y, p.X()) * s;
    if (i > 0) area += std::pow((radius + last_radius) / 2, 2) * (turn - last_turn) / 2;
    last_radius = radius;
    last_turn = turn;
  }
  for (const BoreProfile& profile : {kBoth, kBores})
    expect_cut(BRepAlgoAPI_Cut(wall, bore_tool(profile, into)).Shape(),
               {std::abs(area), {FormSide::both}});
}

}  // namespace
}  // namespace planish::test
