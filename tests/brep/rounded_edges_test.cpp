#include "support/bent_bracket.hpp"
#include "support/unfolded_shape.hpp"

#include <planish/sheet/pattern_facts.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

// Parts deburred all over have the blank of the same part with sharp edges.

namespace planish::test {
namespace {

using std::numbers::pi;
using Wanted = std::function<bool(const gp_Pnt& a, const gp_Pnt& middle, const gp_Pnt& b)>;

std::vector<TopoDS_Edge> edges_where(const TopoDS_Shape& shape, const Wanted& wanted) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::vector<TopoDS_Edge> found;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges(i)));
    const double a = curve.FirstParameter(), b = curve.LastParameter();
    if (wanted(curve.Value(a), curve.Value((a + b) / 2), curve.Value(b)))
      found.push_back(TopoDS::Edge(edges(i)));
  }
  return found;
}

TopoDS_Shape with_rounded(const TopoDS_Shape& shape, double radius, const Wanted& wanted) {
  BRepFilletAPI_MakeFillet make(shape);
  for (const TopoDS_Edge& edge : edges_where(shape, wanted))
    make.Add(radius, edge);
  return make.Shape();
}

TopoDS_Shape with_chamfered(const TopoDS_Shape& shape, double width, const Wanted& wanted) {
  BRepFilletAPI_MakeChamfer make(shape);
  for (const TopoDS_Edge& edge : edges_where(shape, wanted))
    make.Add(width, edge);
  return make.Shape();
}

FlatPattern pattern_of(const TopoDS_Shape& shape) {
  const auto made = unfolded_shape(shape);
  EXPECT_TRUE(made) << made.error().message;
  if (!made) return {};
  EXPECT_LT(made->certificate.refold_deviation.value(), 1e-4);
  EXPECT_LT(made->certificate.opening_error.value_or(0.0), 1e-6);
  return made->flat;
}

/// Of a part that has the volume of its blank but for what is taken off after cutting.
FlatPattern explained_pattern_of(const TopoDS_Shape& shape) {
  const auto made = unfolded_shape(shape);
  EXPECT_TRUE(made) << made.error().message;
  if (!made) return {};
  EXPECT_NEAR(made->certificate.explained_ratio.value_or(0.0), 1.0, 1e-6);
  EXPECT_LT(made->certificate.refold_deviation.value(), 1e-4);
  EXPECT_LT(made->certificate.opening_error.value_or(0.0), 1e-6);
  return made->flat;
}

/// Both skins' edges rounded and chamfered.
void expect_same_blank(const TopoDS_Shape& sharp, const Wanted& edges) {
  const FlatPattern plain = explained_pattern_of(sharp);
  for (const auto& deburred :
       {with_rounded(sharp, 0.4, edges), with_chamfered(sharp, 0.4, edges)}) {
    const FlatPattern flat = explained_pattern_of(deburred);
    EXPECT_NEAR(flat.area, plain.area, 1e-6 * plain.area);
    EXPECT_NEAR(outer_cutting_length(flat), outer_cutting_length(plain), 1e-3);
    EXPECT_NEAR(inner_cutting_length(flat), inner_cutting_length(plain), 1e-3);
    EXPECT_TRUE(flat.slits.empty());
    EXPECT_FALSE(flat.features.empty()) << "what is taken off after cutting is noted";
  }
}

TopoDS_Shape block(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

/// Of a plate of 2 mm from z = 0.
bool is_flat(const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
  return std::abs(a.Z() - b.Z()) < 1e-6 && std::abs(a.Z() - m.Z()) < 1e-6;
}

TEST(RoundedEdges, OfAPlateLeaveItsOutlineAndHoles) {
  const TopoDS_Shape window = BRepAlgoAPI_Cut(block({0, 0, 0}, {100, 60, 2}),
                                              block({20, 20, -1}, {40, 35, 3}));
  const gp_Ax2 axis(gp_Pnt(70, 30, -1), gp_Dir(0, 0, 1));
  expect_same_blank(BRepAlgoAPI_Cut(window, BRepPrimAPI_MakeCylinder(axis, 2.5, 5).Shape()),
                    is_flat);
}

TEST(RoundedEdges, OfADiscLeaveItsOutline) {
  expect_same_blank(BRepPrimAPI_MakeCylinder(30, 2).Shape(), is_flat);
}

TEST(RoundedEdges, MeetInTheCornerOfAPlate) {
  // Corners as small as the roundings are balls, which taper to a point on the skin.
  const TopoDS_Shape plate = with_rounded(
      block({0, 0, 0}, {100, 60, 2}), 0.4,
      [](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) { return !is_flat(a, m, b); });
  const FlatPattern flat = pattern_of(with_rounded(plate, 0.4, is_flat));
  EXPECT_NEAR(flat.area, 6000 - (4 - pi) * 0.16, 1e-5);
}

TEST(RoundedEdges, ThatAreOneFaceFromSkinToSkinReachToTheirMiddle) {
  // On two sides, and on four that meet in sharp corners.
  const auto round_bar = [](double x, double y) {
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(x - 1, 0, 0)).Edge());
    wire.Add(
        BRepBuilderAPI_MakeEdge(
            GC_MakeArcOfCircle(gp_Pnt(x - 1, 0, 0), gp_Pnt(x, 0, 1), gp_Pnt(x - 1, 0, 2)).Value())
            .Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x - 1, 0, 2), gp_Pnt(1, 0, 2)).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(
                 GC_MakeArcOfCircle(gp_Pnt(1, 0, 2), gp_Pnt(0, 0, 1), gp_Pnt(1, 0, 0)).Value())
                 .Edge());
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, y, 0))
        .Shape();
  };
  EXPECT_NEAR(pattern_of(round_bar(100, 60)).area, 6000.0, 1e-6);
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), pi / 2);
  turn.SetTranslationPart(gp_Vec(100, 0, 0));
  const TopoDS_Shape across = BRepBuilderAPI_Transform(round_bar(60, 100), turn).Shape();
  const FlatPattern both = pattern_of(BRepAlgoAPI_Common(round_bar(100, 60), across));
  EXPECT_NEAR(both.area, 6000.0, 1e-6);
  EXPECT_NEAR(outer_cutting_length(both), 320.0, 1e-6);
}

constexpr BentBracket kBracket{
    .thickness = 2, .inside_radius = 6, .first = 40, .second = 40, .width = 60};

TEST(RoundedEdges, GoRoundBends) {
  expect_same_blank(bent_bracket(kBracket), [](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
    if (a.Distance(b) < 2 + 1e-6) return false;
    const auto all = [&](const std::function<bool(const gp_Pnt&)>& on) {
      return on(a) && on(m) && on(b);
    };
    return all([](const gp_Pnt& p) { return p.Y() < 1e-6; }) ||
           all([](const gp_Pnt& p) { return p.Y() > 60 - 1e-6; }) ||
           all([](const gp_Pnt& p) { return p.X() < 1e-6; }) ||
           all([](const gp_Pnt& p) { return p.Z() > 48 - 1e-6; });
  });
}

TEST(RoundedEdges, OfAWindowAcrossABendLeaveIt) {
  const TopoDS_Shape part = BRepAlgoAPI_Cut(bent_bracket(kBracket),
                                            block({30, 24, -1}, {60, 36, 30}));
  expect_same_blank(part, [](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
    const auto within = [](const gp_Pnt& p) { return p.Y() > 23.9 && p.Y() < 36.1; };
    return within(a) && within(m) && within(b) && std::abs(a.Distance(b) - 2) > 1e-6;
  });
}

TEST(RoundedEdges, OnOneSkinOnlyGoRoundBends) {
  for (const double skin : {0.0, 2.0}) {
    const auto on_skin = [&](const gp_Pnt& p) {
      const double in_bend = std::hypot(p.X() - 40, p.Z() - 8);
      return p.X() <= 40 + 1e-6  ? std::abs(p.Z() - skin) < 1e-6
             : p.Z() >= 8 - 1e-6 ? std::abs(p.X() - 48 + skin) < 1e-6
                                 : std::abs(in_bend - 8 + skin) < 1e-6;
    };
    expect_same_blank(
        bent_bracket(kBracket), [&](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
          return on_skin(a) && on_skin(m) && on_skin(b) && a.Y() < 1e-6 && b.Y() < 1e-6;
        });
  }
}

TEST(RoundedEdges, OfARolledConeLeaveItsOutline) {
  // A wall of 2 mm and 40 mm, leaning by 20°, its ends square to it.
  const double lean = pi / 9;
  const auto at = [&](double along, double across) {
    return gp_Pnt(30 + along * std::sin(lean) - across * std::cos(lean), 0,
                  along * std::cos(lean) + across * std::sin(lean));
  };
  BRepBuilderAPI_MakeWire wire;
  const std::vector<gp_Pnt> corners{at(0, 0), at(40, 0), at(40, 2), at(0, 2)};
  for (size_t i = 0; i < corners.size(); ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]).Edge());
  const TopoDS_Face section = BRepBuilderAPI_MakeFace(wire.Wire()).Face();
  expect_same_blank(BRepPrimAPI_MakeRevol(section, gp::OZ(), 1.5 * pi).Shape(),
                    [](const gp_Pnt& a, const gp_Pnt&, const gp_Pnt& b) {
                      return std::abs(a.Distance(b) - 2) > 1e-6;
                    });
}

TEST(RoundedEdges, OfARolledSheetLeaveItsOutline) {
  const TopoDS_Shape shell = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeCylinder(gp::XOY(), 30, 50, 1.5 * pi).Shape(),
      BRepPrimAPI_MakeCylinder(28, 50).Shape());
  expect_same_blank(shell, [](const gp_Pnt& a, const gp_Pnt&, const gp_Pnt& b) {
    return std::abs(a.Distance(b) - 2) > 1e-6;
  });
}

TEST(RoundedEdges, OfADrilledHoleInABendLeaveAnOpening) {
  const double root = std::sqrt(0.5);
  const gp_Ax2 axis(gp_Pnt(40 + 2 * root, 30, 8 - 2 * root), gp_Dir(root, 0, -root));
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(bent_bracket(kBracket),
                                               BRepPrimAPI_MakeCylinder(axis, 3, 12).Shape());
  const FlatPattern plain = pattern_of(drilled);
  const Wanted of_hole = [](const gp_Pnt& a, const gp_Pnt&, const gp_Pnt& b) {
    return a.Distance(b) < 1e-6;
  };
  for (const auto& part :
       {with_rounded(drilled, 0.4, of_hole), with_chamfered(drilled, 0.4, of_hole)}) {
    const FlatPattern flat = pattern_of(part);
    ASSERT_EQ(flat.openings.size(), 1u);
    EXPECT_LT(signed_area(flat.openings.front().loop), 0.0) << "openings run clockwise";
    EXPECT_NEAR(signed_area(flat.openings.front().loop), signed_area(plain.openings.front().loop),
                2.5)
        << "its walls are parallel to the drill, so that it widens inwards";
  }
}

TEST(Counterbores, MayBeMuchOfASmallPlate) {
  TopoDS_Shape part = block({0, 0, 0}, {60, 60, 10});
  for (const double x : {15.0, 45.0})
    for (const double y : {15.0, 45.0}) {
      const gp_Ax2 axis(gp_Pnt(x, y, -1), gp_Dir(0, 0, 1));
      part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 5, 12).Shape());
      part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCylinder(axis, 10, 6).Shape());
    }
  EXPECT_NEAR(pattern_of(part).area, 3600 - 4 * pi * 25, 1e-6);
}

TEST(RoundedEdges, OfALouvreLeaveItsSlit) {
  TopoDS_Shape part = BRepAlgoAPI_Fuse(block({0, 0, 0}, {100, 60, 1}),
                                       block({30, 20, 0}, {70, 40, 4}));
  part = BRepAlgoAPI_Cut(part, block({31, 20, -1}, {69, 39, 3}));
  for (const auto& heights : {std::vector{0.0}, {1.0}, {0.0, 1.0}}) {
    const Wanted edge = [&](const gp_Pnt& a, const gp_Pnt& m, const gp_Pnt& b) {
      const bool at = std::ranges::any_of(heights,
                                          [&](double z) { return std::abs(m.Z() - z) < 1e-6; });
      return at && std::abs(m.Y() - 20) < 1e-6 && std::abs(m.X() - 50) < 1e-6 && is_flat(a, m, b);
    };
    const FlatPattern flat = pattern_of(with_rounded(part, 0.3, edge));
    EXPECT_TRUE(flat.openings.empty());
    ASSERT_EQ(flat.slits.size(), 1u);
    EXPECT_NEAR(length(flat.slits.front()), 38.0, 1e-6);
  }
}

}  // namespace
}  // namespace planish::test
