#include "guarded.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// Parts that are drawn closed, cut open where their refusals say.

namespace planish::test {
namespace {

using std::numbers::pi;

Result<Recognized> recognised_with(const TopoDS_Shape& shape, const std::vector<int>& edges) {
  const auto text = brep::guarded([&] { return brep::step_text(shape, "part"); });
  const auto file = read_step_text(text.value(), "part.step");
  return recognize(file.value().bodies.front(), {.rip_edges = edges});
}

/// How many rips the refusal says are needed.
int promised(const Error& refusal) {
  int edges = 0;
  for (const Place& place : refusal.places)
    if (place.kind == PlaceKind::edge) ++edges;
  // The remedy is the option that rips all of them.
  if (edges == 0) return 0;
  EXPECT_EQ(refusal.remedies.size(), 1u);
  if (refusal.remedies.size() != 1) return 0;
  EXPECT_EQ(refusal.remedies[0].option, "rip_edges");
  EXPECT_EQ(std::ranges::count(refusal.remedies[0].value, ','), edges - 1);
  return edges;
}

/// Rips the edge that each refusal names until the sheet lies flat: as many as the first one says,
/// and each next one says one less.
std::vector<int> rips_asked_for(const TopoDS_Shape& shape) {
  std::vector<int> edges, left;
  for (int guard = 0; guard < 20; ++guard) {
    const auto found = recognised_with(shape, edges);
    left.push_back(found ? 0 : promised(found.error()));
    EXPECT_EQ(left.back() + guard, left.front());
    if (found) return edges;
    EXPECT_EQ(found.error().code, code::closed_loop) << found.error().message;
    const std::vector<Place>& places = found.error().places;
    if (places.empty() || places[0].kind != PlaceKind::edge) break;
    EXPECT_EQ(places[0].faces.size(), 2u);
    edges.push_back(std::get<int>(places[0].id));
  }
  ADD_FAILURE() << "the refusals did not come to an end";
  return edges;
}

/// The edges that the remedy of a refusal rips.
std::vector<int> edges_of_remedy(const Error& refusal) {
  std::vector<int> edges;
  if (refusal.remedies.empty()) return edges;
  std::istringstream value(refusal.remedies[0].value);
  for (std::string edge; std::getline(value, edge, ',');)
    edges.push_back(std::stoi(edge));
  return edges;
}

/// Refused as closed, with a place but without an edge to rip.
void expect_no_rips(const TopoDS_Shape& shape) {
  const auto found = recognised_with(shape, {});
  ASSERT_FALSE(found);
  const Error& error = found.error();
  EXPECT_EQ(error.code, code::closed_loop) << error.message;
  EXPECT_TRUE(error.message.ends_with(" No rips along its edges open it.")) << error.message;
  EXPECT_TRUE(std::regex_match(error.where, std::regex("between face \\d+ and face \\d+")))
      << error.where;
}

/// The pattern of the part cut open by `rips` rips has that area at K = 0.5, and its certificate.
void expect_opened(const TopoDS_Shape& shape, std::size_t rips, double area, int openings = 0,
                   double explained = 1.0) {
  const std::vector<int> edges = rips_asked_for(shape);
  EXPECT_EQ(edges.size(), rips);
  const std::vector<int> at_once = edges_of_remedy(recognised_with(shape, {}).error());
  EXPECT_EQ(at_once.size(), rips);
  EXPECT_TRUE(recognised_with(shape, at_once));
  const auto found = recognised_with(shape, edges);
  ASSERT_TRUE(found) << found.error().message;
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  const auto flat = flatten(found->sheet, options);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_NEAR(flat->area, area, 1e-6 * area);
  EXPECT_EQ(std::ssize(flat->openings), openings);
  const auto certificate = certify(found->sheet, *flat, found->distance);
  ASSERT_TRUE(certificate);
  EXPECT_NEAR(*certificate->explained_ratio, explained, 1e-6);
  EXPECT_LT(*certificate->refold_deviation, 1e-6);
  EXPECT_LT(certificate->length_error, 1e-6);
  EXPECT_EQ(certificate->openings.solid, openings);
}

TopoDS_Shape tube_of(const TopoDS_Shape& outside, double x, double y, double length) {
  return BRepAlgoAPI_Cut(outside, BRepPrimAPI_MakeBox(gp_Pnt(2, 2, -1), x - 4, y - 4, length + 2));
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius) {
  BRepFilletAPI_MakeFillet rounding(shape);
  for (TopExp_Explorer each(shape, TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(each.Current());
    double from = 0, to = 0;
    const auto curve = BRep_Tool::Curve(edge, from, to);
    if (std::abs(curve->Value(from).Z() - curve->Value(to).Z()) > 1) rounding.Add(radius, edge);
  }
  return rounding.Shape();
}

TEST(Ripped, SharpTubeIsFourWallsAndThreeBends) {
  expect_opened(tube_of(BRepPrimAPI_MakeBox(40, 30, 120).Shape(), 40, 30, 120), 1,
                (2 * 36 + 2 * 26 + 3 * pi / 2) * 120);
}

TEST(Ripped, RoundedTubeKeepsItsFourBends) {
  const TopoDS_Shape outside = rounded(BRepPrimAPI_MakeBox(40, 30, 120).Shape(), 5);
  const TopoDS_Shape inside = rounded(BRepPrimAPI_MakeBox(gp_Pnt(2, 2, -1), 36, 26, 122).Shape(),
                                      3);
  expect_opened(BRepAlgoAPI_Cut(outside, inside), 1, (2 * 30 + 2 * 20 + 2 * pi * 4) * 120);
}

TEST(Ripped, ClosedTrayIsRippedAtItsFourCorners) {
  const TopoDS_Shape tray = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeBox(100, 60, 40).Shape(),
      BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 2), 96, 56, 50).Shape());
  const double around = 2 * (96 + 56);
  expect_opened(tray, 4, 96 * 56 + around * 38 + around * pi / 2);
}

TEST(Ripped, ClosedBoxKeepsItsLongestEdges) {
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeBox(100, 60, 40).Shape(),
      BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 2), 96, 56, 36).Shape());
  const TopoDS_Shape box = BRepAlgoAPI_Cut(
      hollow, BRepPrimAPI_MakeBox(gp_Pnt(40, 20, 30), 20, 20, 20).Shape());
  // Of 12 edges the walls hang on 5: three of 96 mm, and two of 56 mm for the ends.
  const double area = 2 * (96 * 56 + 56 * 36 + 36 * 96) + (3 * 96 + 2 * 56) * pi / 2;
  expect_opened(box, 7, area - 20 * 20, 1);
  expect_opened(hollow, 7, area);
}

TEST(Ripped, ClosedBoxesOfOtherShapesHaveNoOpening) {
  // Bends between the walls, sharp edges around base and lid, which keep one straight edge each.
  const TopoDS_Shape box = BRepAlgoAPI_Cut(
      rounded(BRepPrimAPI_MakeBox(100, 60, 40).Shape(), 5),
      rounded(BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 2), 96, 56, 36).Shape(), 3));
  const double lid = 96 * 56 - (4 - pi) * 9, around = 2 * (90 + 50) + 2 * pi * 4;
  const double area = 2 * lid + around * 36 + 2 * 90 * pi / 2;
  // Round corners are counted along their inside edges, a quarter of 2 · 2π less at each of eight.
  expect_opened(box, 15, area, 0, area / (area + 8 * pi));
}

/// A trough of half a pipe, 2 mm thick, with walls beside it and one end closed.
TopoDS_Shape trough(double wall) {
  const auto solid = [&](double radius, double from, double to) {
    const gp_Ax2 axis(gp_Pnt(0, 0, from), gp::DZ());
    const TopoDS_Shape round = BRepAlgoAPI_Common(
        BRepPrimAPI_MakeCylinder(axis, radius, to - from).Shape(),
        BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, from), 60, 30, to - from).Shape());
    if (wall == 0) return round;
    ShapeUpgrade_UnifySameDomain one(BRepAlgoAPI_Fuse(
        round, BRepPrimAPI_MakeBox(gp_Pnt(-radius, 0, from), 2 * radius, wall, to - from).Shape()));
    one.Build();
    return one.Shape();
  };
  return BRepAlgoAPI_Cut(solid(20, 0, 102), solid(18, 2, 103));
}

TEST(Ripped, EndOfATroughHangsOnAWallAndNotOnItsRoundEdge) {
  const double walls = 100 * (2 * 30 + 19 * pi), end = 36 * 30 + 18 * 18 * pi / 2;
  const double area = walls + end + 30 * pi / 2;
  // What the round corner holds is counted along its inside edge, 18 π of 19 π mm.
  expect_opened(trough(30), 2, area, 0, area / (area + 2 * pi));
}

TEST(Ripped, EndThatMeetsARoundWallOnlyIsNotRippedOff) { expect_no_rips(trough(0)); }

TEST(Ripped, ElbowOfTwoPipesIsNotOnePart) {
  const TopoDS_Shape pipe = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -100), gp::DZ()), 20, 200).Shape(),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -101), gp::DZ()), 18, 202).Shape());
  const gp_Ax2 mitre(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 1));
  const TopoDS_Shape half = BRepAlgoAPI_Cut(
      pipe,
      BRepPrimAPI_MakeBox(gp_Ax2(gp_Pnt(0, 0, 0).Translated(gp_Vec(mitre.XDirection()) * -300 +
                                                            gp_Vec(mitre.YDirection()) * -300),
                                 mitre.Direction(), mitre.XDirection()),
                          600, 600, 300)
          .Shape());
  gp_Trsf mirror;
  mirror.SetMirror(mitre);
  expect_no_rips(BRepAlgoAPI_Fuse(half, BRepBuilderAPI_Transform(half, mirror, true).Shape()));
}

TEST(Ripped, EdgesAreThoseOfTheSheet) {
  const TopoDS_Shape tube = tube_of(BRepPrimAPI_MakeBox(40, 30, 120).Shape(), 40, 30, 120);
  EXPECT_EQ(recognised_with(tube, {999}).error().code, code::bad_option);
  const auto open = recognised_with(tube, rips_asked_for(tube));
  ASSERT_TRUE(open);
  // A second rip takes a wall away.
  std::vector<int> two = rips_asked_for(tube);
  two.push_back(*open->sheet[open->sheet.joints.front().a].edge);
  const auto apart = recognised_with(tube, two);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::bad_option);
  EXPECT_NE(apart.error().message.find("several parts"), std::string::npos);
  std::vector<int> named;
  for (const Place& place : apart.error().places)
    named.push_back(std::get<int>(place.id));
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(two));
}

}  // namespace
}  // namespace planish::test
