#include "genus.hpp"

#include "recognised.hpp"
#include "solid_reader.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

/// Of a solid of the kernel, which has seams and degenerate edges.
std::optional<int> kernel_genus(const TopoDS_Shape& shape) {
  const TopExp_Explorer solids(shape, TopAbs_SOLID);
  return read_solid(TopoDS::Solid(solids.Current()), 0.01).genus;
}

Loop circle(double radius, double turn) { return {Arc{{0, 0}, radius, 0.0, turn}}; }

std::vector<Turned> holes(int count) {
  std::vector<Turned> all;
  for (int i = 0; i < count; ++i)
    all.push_back({{20.0 + 20 * i, 30}, {{5, 2}, {5, 0}}});
  return all;
}

TEST(Genus, OfAPlateIsTheNumberOfItsHoles) {
  for (const int count : {0, 1, 4})
    EXPECT_EQ(genus_of(plate(2, {120, 60}, holes(count))), count);
}

TEST(Genus, OfATubeIsOne) {
  EXPECT_EQ(genus_of(prism({circle(20, 2 * pi), circle(18, -2 * pi)}, 100)), 1);
}

TEST(Genus, CountsNoPocketAndNoBoss) {
  EXPECT_EQ(genus_of(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 1.2}, {0, 1.2}}}})), 0);
  EXPECT_EQ(genus_of(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}})), 0);
}

TEST(Genus, OfABentStripIsThatOfTheStrip) {
  EXPECT_EQ(genus_of(prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40)), 0);
}

TEST(Genus, CountsNoFaceThatHasBecomePartOfAnother) {
  // The top of a box, with a hole, as two faces on one plane.
  SolidModel model = plate(2, {100, 60}, holes(1));
  model.faces.emplace_back().surface = Frame{};
  EXPECT_EQ(genus_of(model), 1);
}

TEST(Genus, IsNotDefinedForAnOpenBoundary) {
  SolidMaker maker;
  maker.plane(Vec3::UnitZ(), {polygon_path({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})});
  EXPECT_FALSE(genus_of(std::move(maker).build_open()));
}

TEST(Genus, MindsTheSeamsAndPolesOfTheKernel) {
  EXPECT_EQ(kernel_genus(BRepPrimAPI_MakeSphere(10).Shape()), 0);
  EXPECT_EQ(kernel_genus(BRepPrimAPI_MakeCone(10, 0, 20).Shape()), 0);
  EXPECT_EQ(kernel_genus(BRepPrimAPI_MakeCylinder(10, 20).Shape()), 0);
  EXPECT_EQ(kernel_genus(BRepPrimAPI_MakeTorus(20, 5).Shape()), 1);
}

TEST(Genus, OfAHollowBodyIsThatOfItsShellsTogether) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(40, 40, 40).Shape();
  const gp_Ax2 middle(gp_Pnt(20, 20, 20), gp_Dir(0, 0, 1));
  EXPECT_EQ(kernel_genus(BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeSphere(middle, 10).Shape())), 0);
  EXPECT_EQ(kernel_genus(BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeTorus(middle, 10, 3).Shape())), 1);
}

TEST(Genus, CountsWaysThatCross) {
  // Three bores that meet in the middle: six mouths, 6 − 1 handles.
  TopoDS_Shape block = BRepPrimAPI_MakeBox(40, 40, 40).Shape();
  for (const auto& [at, along] : {std::pair{gp_Pnt(20, 20, -1), gp_Dir(0, 0, 1)},
                                  std::pair{gp_Pnt(20, -1, 20), gp_Dir(0, 1, 0)},
                                  std::pair{gp_Pnt(-1, 20, 20), gp_Dir(1, 0, 0)}})
    block = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(gp_Ax2(at, along), 5, 42).Shape());
  EXPECT_EQ(kernel_genus(block), 5);
}

TEST(ClosedBorders, CountThoseThatHaveAWantedEdge) {
  // The walls of a square opening: four edges round each of two borders.
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inner = clockwise(rectangle_at({40, 20}, {60, 40}));
  const SolidModel model = plate(2, {{{outer, outer}, {0, 2}}, {{inner, inner}, {0, 2}}});
  const std::vector<int> walls{6, 7, 8, 9};
  const auto borders_with = [&](const std::vector<int>& edges) {
    return closed_borders(model, walls, [&](int e) { return std::ranges::count(edges, e) > 0; });
  };
  const int above = edge_between(model, kTop, 6), below = edge_between(model, kBottom, 7);
  EXPECT_EQ(borders_with({above}), 1);
  EXPECT_EQ(borders_with({below, edge_between(model, kBottom, 9)}), 1);
  EXPECT_EQ(borders_with({above, below}), 2);
  EXPECT_EQ(borders_with({edge_between(model, 6, 7), edge_between(model, kTop, 2)}), 0)
      << "one between the walls, one of another wall";
}

int openings_at(const SolidModel& model, int face) {
  const Recognised seen = recognised(model, 2, 1);
  return seen.rim.parts.at(seen.rim.part_of.at(face)).openings;
}

TEST(OpeningsThrough, AreOneInAHoleAndAtTheOuterRimAndNoneInAPocketOrABoss) {
  EXPECT_EQ(openings_at(plate(2, {100, 60}), 2), 1);
  EXPECT_EQ(openings_at(plate(2, {100, 60}, holes(1)), 6), 1);
  EXPECT_EQ(openings_at(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 1.2}, {0, 1.2}}}}), 6), 0);
  EXPECT_EQ(openings_at(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}}), 6), 0);
}

TEST(OpeningsThrough, AreOneInAnExtrudedHole) {
  const Turned collar{{30, 30}, {{5, 2}, {5, -1.5}, {6, -1.5}, {6, 0}}};
  EXPECT_EQ(openings_at(plate(2, {100, 60}, {collar}), 6), 1);
}

}  // namespace
}  // namespace planish::brep::test
