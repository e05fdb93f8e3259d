#include "pair_search.hpp"

#include "sample_fits.hpp"
#include "tolerances.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace connect_detail;

BendFrame bare_frame(double beta) {
  BendFrame frame;
  frame.beta = Angle::degrees(beta);
  return frame;
}

TEST(TangentDistance, IsThatOfTheCylinderThatTouchesBothPlanes) {
  EXPECT_NEAR(tangent_distance(bare_frame(90), 12.0), 12.0, 1e-12);
  EXPECT_NEAR(tangent_distance(bare_frame(60), 12.0), 12.0 * std::sqrt(3.0), 1e-12);
}

TEST(LeastHeight, LeavesTheSmallestInsideRadius) {
  const PairTask pair(angle_pair(14.0, 200, 4.0));
  EXPECT_NEAR(least_height(pair.task, bare_frame(90)), 2.0 + kSmallestInsideRadius, 1e-12);
}

TEST(GivenLineOf, ARadiusIsALevelLineAtItsTangentDistance) {
  const GivenLine line = given_line({.inside_radius = 5.0}, bare_frame(90), 4.0);
  EXPECT_EQ(line.slope, 0.0);
  EXPECT_NEAR(line.offset.value(), -7.0, 1e-12);
}

TEST(GivenLineOf, ASlopeWithARadiusLeavesTheOffsetOpen) {
  const GivenLine line = given_line({.inside_radius = 5.0, .slope = 0.1}, bare_frame(90), 4.0);
  EXPECT_EQ(line.slope, 0.1);
  EXPECT_FALSE(line.offset);
}

TEST(GivenLineOf, ASurfaceIsLevelOrOpen) {
  EXPECT_EQ(given_line({.surface = SurfaceChoice::cylinder}, bare_frame(90), 4.0).slope, 0.0);
  EXPECT_FALSE(given_line({.surface = SurfaceChoice::cone}, bare_frame(90), 4.0).slope);
  EXPECT_FALSE(
      given_line({.surface = SurfaceChoice::general, .apex = 3.0}, bare_frame(90), 4.0).apex);
  EXPECT_EQ(given_line({}, bare_frame(0), 4.0).slope, 0.0) << "parallel planes";
}

TEST(SearchPair, FindsTheEdgesThatFaceEachOther) {
  const PairTask pair(angle_pair(14.0));
  const auto choice = search_pair(pair.task, {});
  ASSERT_TRUE(choice);
  const auto edges = choice->edges(choice->search.best);
  EXPECT_EQ(edges[0], std::vector{2});
  EXPECT_EQ(edges[1], std::vector{0});
  for (const auto& side : choice->corners(choice->search.best))
    for (const Vec2& p : side)
      EXPECT_NEAR(p.y(), 14.0, 1e-9);
}

TEST(SearchPair, LeavesEdgesToTheBendsThatUseThem) {
  PairTask pair(angle_pair(14.0));
  pair.task.taken[0].whole = {2};
  const auto choice = search_pair(pair.task, {});
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->edges(choice->search.best)[0], std::vector{0}) << "round the back";
  EXPECT_EQ(choice->search.best.kind, EdgeKind::averted);
}

TEST(SearchPair, PassesOverEdgesThatAreTooNearForTheThickness) {
  // Of the first plate a tab reaches to 1 mm before the line, the edges beside it lie 20 mm back.
  PlateStructure s = angle_pair(20.0, 200, 4.0);
  s.plates[0].outline = {{0, 0, 0},    {200, 0, 0},  {200, 100, 0}, {30, 100, 0},
                         {29, 119, 0}, {10, 119, 0}, {9, 100, 0},   {0, 100, 0}};
  const PairTask pair(s);
  const auto choice = search_pair(pair.task, {});
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->edges(choice->search.best)[0], std::vector{2});
}

TEST(SearchPair, RefusesPlatesInOnePlaneAndBesideEachOther) {
  PlateStructure s = angle_pair(14.0);
  s.plates[1] = rectangle_plate("B", {0, 120, 0}, {200, 0, 0}, {0, 100, 0});
  EXPECT_EQ(search_pair(PairTask(s).task, {}).error().code, code::plates_coplanar);
  s.plates[1] = rectangle_plate("B", {250, 120, 30}, {200, 0, 0}, {0, 100, 0});
  EXPECT_EQ(search_pair(PairTask(s).task, {}).error().code, code::plates_offset);
}

}  // namespace
}  // namespace planish::test
