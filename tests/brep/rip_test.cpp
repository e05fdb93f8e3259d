#include "guarded.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
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

/// Rips the edge that each refusal names until the sheet lies flat.
std::vector<int> rips_asked_for(const TopoDS_Shape& shape) {
  std::vector<int> edges;
  for (int guard = 0; guard < 20; ++guard) {
    const auto found = recognised_with(shape, edges);
    if (found) return edges;
    EXPECT_EQ(found.error().code, ErrorCode::closed_loop) << found.error().message;
    std::smatch named;
    if (!std::regex_search(found.error().where, named, std::regex("edge (\\d+)"))) break;
    edges.push_back(std::stoi(named[1]));
  }
  ADD_FAILURE() << "the refusals did not come to an end";
  return edges;
}

/// The pattern of the part cut open by `rips` rips has that area at K = 0.5, and its certificate.
void expect_opened(const TopoDS_Shape& shape, std::size_t rips, double area) {
  const std::vector<int> edges = rips_asked_for(shape);
  EXPECT_EQ(edges.size(), rips);
  const auto found = recognised_with(shape, edges);
  ASSERT_TRUE(found) << found.error().message;
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  const auto flat = flatten(found->sheet, options);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_NEAR(flat->area, area, 1e-6 * area);
  EXPECT_TRUE(flat->openings.empty());
  const auto certificate = certify(found->sheet, *flat, found->distance);
  ASSERT_TRUE(certificate);
  EXPECT_NEAR(*certificate->explained_ratio, 1.0, 1e-6);
  EXPECT_LT(*certificate->refold_deviation, 1e-6);
  EXPECT_LT(certificate->length_error, 1e-6);
  EXPECT_EQ(certificate->openings.solid, 0);
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

TEST(Ripped, EdgesAreThoseOfTheSheet) {
  const TopoDS_Shape tube = tube_of(BRepPrimAPI_MakeBox(40, 30, 120).Shape(), 40, 30, 120);
  EXPECT_EQ(recognised_with(tube, {999}).error().code, ErrorCode::bad_option);
  const auto open = recognised_with(tube, rips_asked_for(tube));
  ASSERT_TRUE(open);
  // A second rip takes a wall away.
  std::vector<int> two = rips_asked_for(tube);
  two.push_back(*open->sheet[open->sheet.joints.front().a].edge);
  const auto apart = recognised_with(tube, two);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, ErrorCode::bad_option);
  EXPECT_NE(apart.error().message.find("several parts"), std::string::npos);
}

}  // namespace
}  // namespace planish::test
