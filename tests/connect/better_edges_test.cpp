#include "better_edges.hpp"

#include "sample_fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace connect_detail;

/// A floor of 200 × 100 and a wall from x = `from` to `to`, 20 from the line where they meet; the
/// sheets are 4 thick and the bend is much smaller than the gap, or as large.
struct FloorAndWall {
  PairTask pair;

  FloorAndWall(double from, double to, std::optional<double> radius) : pair(plates(from, to)) {
    pair.task.request.inside_radius = radius;
  }
  static PlateStructure plates(double from, double to) {
    PlateStructure s = angle_pair(20);
    s.plates[1] = rectangle_plate("B", {from, 120, 20}, {to - from, 0, 0}, {0, 0, 100});
    return s;
  }

  /// From where to where on x the bend uses the floor's edge.
  std::pair<double, double> used_of_floor() const {
    const auto found = search_pair(pair.task, {});
    EXPECT_TRUE(found) << found.error().message;
    const PairChoice choice = with_used_parts(*found, pair.task,
                                              search_options(pair.task, found->frame));
    const auto corners = choice.corners(choice.search.best)[0];
    const double a = choice.frame.point(0, corners.front()).x(),
                 b = choice.frame.point(0, corners.back()).x();
    EXPECT_EQ(choice.edges(choice.search.best)[0], std::vector<int>{2});
    return std::minmax(a, b);
  }
};

void expect_used(const FloorAndWall& plates, double from, double to) {
  const auto [low, high] = plates.used_of_floor();
  EXPECT_NEAR(low, from, 1e-9);
  EXPECT_NEAR(high, to, 1e-9);
}

TEST(UsedParts, AreWhatLiesOppositeWhereTheRestIsLonger) {
  expect_used({80, 120, 3.0}, 80, 120);
  expect_used({0, 40, 3.0}, 0, 40);
  expect_used({160, 200, 3.0}, 160, 200);
  expect_used({10, 60, 3.0}, 10, 60);
  expect_used({140, 190, 3.0}, 140, 190);
}

TEST(UsedParts, AreTheWholeEdgeWhereTheRestIsShorter) {
  expect_used({10, 190, 3.0}, 0, 200);
  expect_used({0, 110, 3.0}, 0, 200);
  expect_used({90, 200, 3.0}, 0, 200);
  expect_used({0, 90, 3.0}, 0, 90);
}

TEST(UsedParts, LeaveWhatOthersMayNeedWhereEdgesAreShared) {
  FloorAndWall plates(10, 190, 3.0);
  plates.pair.task.shares_edges = true;
  expect_used(plates, 10, 190);
  FloorAndWall nearly(3, 197, 3.0);  // rests of less than the thickness stay
  nearly.pair.task.shares_edges = true;
  expect_used(nearly, 0, 200);
  FloorAndWall one_side(3, 190, 3.0);
  one_side.pair.task.shares_edges = true;
  expect_used(one_side, 0, 190);
}

TEST(UsedParts, AreTheWholeEdgeThatIsDrawnUpToTheBend) {
  // Without a radius the bend is as large as the gap: it begins at the edges.
  expect_used({80, 120, std::nullopt}, 0, 200);
}

TEST(UsedParts, AreNoneWherePlatesHardlyLieOpposite) { expect_used({197, 260, 3.0}, 0, 200); }

TEST(EdgesOfKind, AreThoseAlone) {
  const std::vector<Chain> chains{
      {EdgeKind::facing, {}, {1}}, {EdgeKind::averted, {}, {2}}, {EdgeKind::facing, {}, {3}}};
  const auto facing = of_kind(chains, EdgeKind::facing);
  ASSERT_EQ(facing.size(), 2u);
  EXPECT_EQ(facing[0].edges, std::vector<int>{1});
  EXPECT_EQ(facing[1].edges, std::vector<int>{3});
  EXPECT_EQ(of_kind(chains, EdgeKind::averted).size(), 1u);
}

}  // namespace
}  // namespace planish::test
