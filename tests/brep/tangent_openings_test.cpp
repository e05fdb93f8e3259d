#include "tangent_openings.hpp"

#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

// A hole of a flange near a bend: what is machined round it crosses the tangent line, the hole does
// not. The flat pattern has the drilled circle and the bend of the bracket without a hole.

namespace planish::test {
namespace {

using std::numbers::pi;
using ToolProfile = std::vector<std::pair<double, double>>;  // radius, height

constexpr BentBracket kHoledBracket{
    .thickness = 2, .inside_radius = 2, .first = 40, .second = 30, .width = 50};
constexpr double kDrilled = 2.5;

/// The body of revolution of a profile about the upright axis through (x, 25).
TopoDS_Shape turned_tool(const ToolProfile& profile, double x) {
  BRepBuilderAPI_MakeWire wire;
  const auto at = [&](const std::pair<double, double>& p) {
    return gp_Pnt(x + p.first, 25, p.second);
  };
  for (size_t i = 0; i < profile.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(at(profile[i]), at(profile[(i + 1) % profile.size()])).Edge());
  const gp_Ax1 axis(gp_Pnt(x, 25, 0), gp_Dir(0, 0, 1));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), axis).Shape();
}

/// A hole whose edge is `gap` from the tangent line.
double hole_at(double gap) { return kHoledBracket.first - kDrilled - gap; }

TopoDS_Shape drilled_bracket(double gap) {
  const gp_Ax2 axis(gp_Pnt(hole_at(gap), 25, -1), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                         BRepPrimAPI_MakeCylinder(axis, kDrilled, 4).Shape());
}

template <typename Make>
TopoDS_Shape deburred_bracket(double gap, double by) {
  const TopoDS_Shape part = drilled_bracket(gap);
  Make make(part);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(part, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    if (curve.GetType() == GeomAbs_Circle && std::abs(curve.Circle().Radius() - kDrilled) < 1e-6)
      make.Add(by, TopoDS::Edge(edges(i)));
  }
  return make.Shape();
}

void expect_drilled(const TopoDS_Shape& part, double gap) {
  const auto made = unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  const FlatPattern& flat = made->flat;
  ASSERT_EQ(flat.bends.size(), 1u);
  EXPECT_NEAR(made->sheet[BendId{0}].angle.degrees(), 90, 1e-6);
  const double length = 40 + 30 + pi / 2 * 3;
  EXPECT_NEAR(flat.area, 50 * length - pi * kDrilled * kDrilled, 1e-4);
  ASSERT_EQ(flat.openings.size(), 1u);
  const Box2 box = bounds(flat.openings.front().loop);
  EXPECT_NEAR(box.size().x(), 2 * kDrilled, 1e-6);
  EXPECT_NEAR(box.size().y(), 2 * kDrilled, 1e-6);
  const Box2 outer = bounds(flat.outer.loop);
  const double from_end = std::min(box.lo.x() - outer.lo.x(), outer.hi.x() - box.hi.x());
  EXPECT_NEAR(from_end, std::min(hole_at(gap) - kDrilled, length - hole_at(gap) - kDrilled), 1e-6);
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1, 1e-7)
      << "what is machined is measured";
  EXPECT_LT(made->certificate.opening_error.value_or(1), 1e-5);
  EXPECT_LT(made->certificate.refold_deviation.value_or(1), 1e-4);
  for (const FlatFeature& feature : flat.features)
    EXPECT_EQ(feature.kind, "countersink");
}

TEST(TangentOpenings, KeepTheDrilledHoleThatIsRoundedOrChamfered) {
  for (const double gap : {0.05, 0.2}) {
    expect_drilled(deburred_bracket<BRepFilletAPI_MakeFillet>(gap, 0.5), gap);
    expect_drilled(deburred_bracket<BRepFilletAPI_MakeChamfer>(gap, 0.5), gap);
  }
}

TEST(TangentOpenings, LieBesideARimThatIsChamferedToo) {
  const TopoDS_Shape part = drilled_bracket(0.2);
  BRepFilletAPI_MakeChamfer make(part);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(part, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    const gp_Pnt a = curve.Value(curve.FirstParameter()), b = curve.Value(curve.LastParameter());
    const bool hole = curve.GetType() == GeomAbs_Circle &&
                      std::abs(curve.Circle().Radius() - kDrilled) < 1e-6;
    const auto both = [&](const auto& on) { return on(a) && on(b); };
    const bool rim = std::abs(a.Distance(b) - 2) > 1e-6 &&
                     (both([](const gp_Pnt& p) { return p.Y() < 1e-6; }) ||
                      both([](const gp_Pnt& p) { return p.Y() > 50 - 1e-6; }) ||
                      both([](const gp_Pnt& p) { return p.X() < 1e-6; }) ||
                      both([](const gp_Pnt& p) { return p.Z() > 34 - 1e-6; }));
    if (hole || rim) make.Add(0.4, TopoDS::Edge(edges(i)));
  }
  const auto made = unfolded_shape(make.Shape());
  ASSERT_TRUE(made) << made.error().message;
  const double length = 40 + 30 + pi / 2 * 3;
  EXPECT_NEAR(made->sheet[BendId{0}].angle.degrees(), 90, 1e-6);
  EXPECT_NEAR(made->flat.area, 50 * length - pi * kDrilled * kDrilled, 1e-3);
  EXPECT_EQ(made->flat.openings.size(), 1u);
  EXPECT_LT(made->certificate.outline_error.value_or(0), 1e-6);
}

TEST(TangentOpenings, KeepTheHoleOfCountersinksOnEitherSkinOrBoth) {
  const ToolProfile inside{{0, -1}, {kDrilled, -1}, {kDrilled, 1.4}, {3.1, 2}, {3.1, 6}, {0, 6}};
  const ToolProfile outside{{0, -1}, {3.5, -1}, {3.5, 0}, {kDrilled, 1}, {kDrilled, 6}, {0, 6}};
  const ToolProfile both{{0, -1},         {3.5, -1}, {3.5, 0}, {kDrilled, 1},
                         {kDrilled, 1.4}, {3.1, 2},  {3.1, 6}, {0, 6}};
  const ToolProfile bores{{0, -1},         {3.5, -1},  {3.5, 0.6}, {kDrilled, 0.6},
                          {kDrilled, 1.4}, {3.5, 1.4}, {3.5, 6},   {0, 6}};
  for (const double gap : {0.1, 0.3})
    for (const ToolProfile& profile : {inside, outside, both, bores})
      expect_drilled(
          BRepAlgoAPI_Cut(bent_bracket(kHoledBracket), turned_tool(profile, hole_at(gap))), gap);
}

TEST(TangentOpenings, KeepTheDrilledHoleThatTouchesTheTangentLine) {
  const ToolProfile inside{{0, -1}, {kDrilled, -1}, {kDrilled, 1.4}, {3.1, 2}, {3.1, 6}, {0, 6}};
  const ToolProfile outside{{0, -1}, {3.5, -1}, {3.5, 0}, {kDrilled, 1}, {kDrilled, 6}, {0, 6}};
  const ToolProfile both{{0, -1},         {3.5, -1}, {3.5, 0}, {kDrilled, 1},
                         {kDrilled, 1.4}, {3.1, 2},  {3.1, 6}, {0, 6}};
  for (const double gap : {0.0, 1e-9, 1e-6, 5e-4}) {
    expect_drilled(deburred_bracket<BRepFilletAPI_MakeFillet>(gap, 0.5), gap);
    expect_drilled(deburred_bracket<BRepFilletAPI_MakeChamfer>(gap, 0.5), gap);
    for (const ToolProfile& profile : {inside, outside, both})
      expect_drilled(
          BRepAlgoAPI_Cut(bent_bracket(kHoledBracket), turned_tool(profile, hole_at(gap))), gap);
  }
}

/// Windows of 10 mm along the bend, from x = 34 to `to`, with a ledge 1 mm wide on each skin that
/// is stepped, 0.5 mm deep. Either may end on the tangent line, at 40.
TEST(TangentOpenings, MayHaveASideOrALedgeOnTheTangentLine) {
  const auto cut = [](const TopoDS_Shape& part, const gp_Pnt& from, const gp_Pnt& to) {
    return BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeBox(from, to).Shape()).Shape();
  };
  const double blank = 50 * (40 + 30 + pi / 2 * 3);
  for (const double to : {40.0, 39.0})
    for (const bool above : {false, true})
      for (const bool below : {false, true}) {
        TopoDS_Shape part = cut(bent_bracket(kHoledBracket), {34, 20, -1}, {to, 30, 3});
        if (above) part = cut(part, {33, 19, 1.5}, {to + 1, 31, 3});
        if (below) part = cut(part, {33, 19, -1}, {to + 1, 31, 0.5});
        const auto made = unfolded_shape(part);
        ASSERT_TRUE(made) << made.error().message;
        ASSERT_EQ(made->flat.openings.size(), 1u);
        EXPECT_NEAR(made->flat.area, blank - 10 * (to - 34), 1e-6);
        EXPECT_LT(made->certificate.opening_error.value_or(above || below ? 1 : 0), 1e-6);
        EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1, 1e-9);
        EXPECT_LT(made->certificate.refold_deviation.value_or(1), 1e-9);
      }
}

/// Where a drilled wall ends over the bend: at this height over the outside, or on the outside,
/// also where that has risen above it.
struct WallEnd {
  double height = 0.0;
  /// The turn of the bend at which it is met, over x from the tangent line.
  double turn(double x) const { return std::atan(x / std::min(4 - height, std::sqrt(16 - x * x))); }
};

/// A circle whose middle lies `before` the tangent line, its developed area at K = ½: over the
/// flange a segment of the circle, over the bend ∫ 3 turn(x) dy by Simpson's rule.
double area_across(double before, const WallEnd& end) {
  const double half = std::acos(before / kDrilled);
  const double flat = kDrilled * kDrilled * (pi - half + std::sin(half) * std::cos(half));
  const auto reach = [&](double turn) {  // y = r sin(turn)
    const double x = std::max(0.0, kDrilled * std::cos(turn) - before);
    return 3 * end.turn(x) * kDrilled * std::cos(turn);
  };
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i)
    sum += (i % kSteps == 0 ? 1 : i % 2 == 0 ? 2 : 4) * reach(half * (2.0 * i / kSteps - 1));
  return flat + sum * (2 * half / kSteps) / 3;
}

constexpr double kBlank = 50 * (40 + 30 + pi / 2 * 3);

/// The hole is cut at the outermost end of its drilled wall, which the blank's wall must not pass.
void expect_cut_across(const TopoDS_Shape& part, double gap, const WallEnd& end, size_t sinks) {
  const auto made = unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->sheet[BendId{0}].angle.degrees(), 90, 1e-6);
  ASSERT_EQ(made->flat.openings.size(), 1u);
  const double area = area_across(kDrilled + gap, end);
  EXPECT_NEAR(std::abs(signed_area(made->flat.openings.front().loop)), area, 1e-3);
  EXPECT_NEAR(made->flat.area, kBlank - area, 1e-3);
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0), 1, 1e-6);
  EXPECT_LT(made->certificate.refold_deviation.value_or(1), 1e-4);
  const auto is_sink = [](const FlatFeature& feature) { return feature.kind == "countersink"; };
  EXPECT_EQ(std::ranges::count_if(made->flat.features, is_sink), std::ptrdiff_t(sinks));
}

const ToolProfile kInsideSink{{0, -1}, {kDrilled, -1}, {kDrilled, 1.4}, {3.1, 2}, {3.1, 6}, {0, 6}};
const ToolProfile kOutsideSink{{0, -1}, {3.5, -1}, {3.5, 0}, {kDrilled, 1}, {kDrilled, 6}, {0, 6}};
const ToolProfile kInsideBore{{0, -1}, {kDrilled, -1}, {kDrilled, 1}, {3.5, 1}, {3.5, 6}, {0, 6}};
const ToolProfile kOutsideBore{{0, -1}, {3.5, -1}, {3.5, 1}, {kDrilled, 1}, {kDrilled, 6}, {0, 6}};

TEST(TangentOpenings, AreCutAcrossTheLineWhereTheHoleCrossesIt) {
  const ToolProfile both{{0, -1},         {3.5, -1}, {3.5, 0}, {kDrilled, 1},
                         {kDrilled, 1.4}, {3.1, 2},  {3.1, 6}, {0, 6}};
  for (const double gap : {-0.1, -0.5})
    expect_cut_across(BRepAlgoAPI_Cut(bent_bracket(kHoledBracket), turned_tool(both, hole_at(gap))),
                      gap, {1.0}, 2);
}

TEST(TangentOpenings, AreCutAcrossTheLineWhereOneSkinIsMachined) {
  for (const double gap : {-0.1, -0.5})
    for (const ToolProfile& profile : {kInsideSink, kOutsideSink, kInsideBore, kOutsideBore}) {
      const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                                                turned_tool(profile, hole_at(gap)));
      const bool outermost = profile[1].first == kDrilled;
      expect_cut_across(part, gap, outermost ? WallEnd{} : WallEnd{1.0}, 1);
    }
}

TEST(TangentOpenings, AreCutAcrossTheLineWhicheverSkinIsWider) {
  // A chamfer along the outside of the end makes the inside the reference.
  const auto on_end = [](const gp_Pnt& p) { return std::abs(p.X()) + std::abs(p.Z()) < 1e-6; };
  const auto expect_cut = [&](const ToolProfile& profile, const WallEnd& end, size_t sinks) {
    const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                                              turned_tool(profile, hole_at(-0.5)));
    BRepFilletAPI_MakeChamfer make(part);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(part, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
      if (on_end(curve.Value(curve.FirstParameter())) && on_end(curve.Value(curve.LastParameter())))
        make.Add(0.5, TopoDS::Edge(edges(i)));
    }
    expect_cut_across(make.Shape(), -0.5, end, sinks);
  };
  expect_cut(kInsideSink, {}, 1);
  expect_cut(kOutsideSink, {1.0}, 1);
  expect_cut({{0, -1}, {kDrilled, -1}, {kDrilled, 6}, {0, 6}}, {}, 0);
}

TEST(TangentOpenings, AreCutAcrossTheLineWhereTheyReachFarRoundTheBend) {
  const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                                            turned_tool(kOutsideSink, hole_at(-1.5)));
  expect_cut_across(part, -1.5, {1.0}, 1);
}

TEST(TangentOpenings, AreCutAcrossTheLineWhereTheBendRisesAboveTheSink) {
  const ToolProfile shallow{{0, -1}, {2.8, -1}, {2.8, 0}, {kDrilled, 0.29}, {kDrilled, 6}, {0, 6}};
  const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                                            turned_tool(shallow, hole_at(-1.7)));
  expect_cut_across(part, -1.7, {0.29}, 1);
}

TEST(TangentOpenings, KeepTheSmallestDifferenceOfTheEndsOfTheirWall) {
  // Bored from the outside and barely over the line: the wall's ends differ by 0.01 mm in one place
  // and by much less all round.
  const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kHoledBracket),
                                            turned_tool(kOutsideBore, hole_at(-0.03)));
  const auto made = unfolded_shape(part);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_NEAR(made->flat.area, kBlank - area_across(kDrilled - 0.03, {1.0}), 1e-5);
}

TEST(TangentOpenings, AreToldFromPlainHoles) { expect_drilled(drilled_bracket(0.2), 0.2); }

}  // namespace
}  // namespace planish::test
