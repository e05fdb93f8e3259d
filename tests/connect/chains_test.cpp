#include <planish/connect/edge_search.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using Outline = std::vector<Vec2>;

/// Corners 0 … 3 of a rectangle above the axis, counter-clockwise.
Outline rectangle_at(double y0 = 10, double y1 = 50) {
  return {{0, y0}, {100, y0}, {100, y1}, {0, y1}};
}

const Chain* of_kind(const std::vector<Chain>& chains, EdgeKind kind) {
  const auto found = std::ranges::find_if(chains,
                                          [&](const Chain& chain) { return chain.kind == kind; });
  return found == chains.end() ? nullptr : &*found;
}

TEST(ViableChains, OfARectangleAreItsLowerAndItsUpperEdge) {
  const auto chains = viable_chains(rectangle_at());
  ASSERT_EQ(chains.size(), 2u);
  const Chain *facing = of_kind(chains, EdgeKind::facing),
              *averted = of_kind(chains, EdgeKind::averted);
  ASSERT_TRUE(facing && averted);
  EXPECT_EQ(facing->edges, std::vector{0});
  EXPECT_EQ(averted->edges, std::vector{2});
  EXPECT_EQ(averted->corners, (Outline{{0, 50}, {100, 50}})) << "x grows";
}

TEST(ViableChains, AreTheSameEitherWayRound) {
  Outline outline{{0, 30}, {40, 10}, {80, 12}, {100, 40}, {50, 70}};
  const auto forward = viable_chains(outline);
  std::ranges::reverse(outline);
  const auto backward = viable_chains(outline);
  for (const EdgeKind kind : {EdgeKind::facing, EdgeKind::averted}) {
    ASSERT_TRUE(of_kind(forward, kind) && of_kind(backward, kind));
    EXPECT_EQ(of_kind(forward, kind)->corners, of_kind(backward, kind)->corners);
  }
}

TEST(ViableChains, RunOverTheStartOfTheOutline) {
  // The facing edges are 3, 0 and 1.
  const auto chains = viable_chains({{40, 5}, {70, 8}, {100, 30}, {0, 30}});
  const Chain* facing = of_kind(chains, EdgeKind::facing);
  ASSERT_TRUE(facing);
  EXPECT_EQ(facing->edges, (std::vector{3, 0, 1}));
  EXPECT_EQ(facing->corners.front(), Vec2(0, 30));
}

TEST(ViableChains, LeaveOutEdgesBelowAndAcrossTheAxis) {
  // The lower edge lies below the axis, the sides cross it.
  const auto chains = viable_chains(rectangle_at(-10, 50));
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].kind, EdgeKind::averted);
}

TEST(ViableChains, TakeWhatIsNearlyOnTheAxisAsOnIt) {
  const double extent = std::hypot(100, 50);
  const auto on = viable_chains(rectangle_at(-0.5e-9 * extent, 50));
  const Chain* facing = of_kind(on, EdgeKind::facing);
  ASSERT_TRUE(facing);
  EXPECT_EQ(facing->corners[0].y(), 0.0);
  EXPECT_FALSE(of_kind(viable_chains(rectangle_at(-2e-9 * extent, 50)), EdgeKind::facing));
}

TEST(ViableChains, AreDividedByEdgesAcrossTheAxis) {
  // A notch with upright sides: its bottom and both feet are three chains.
  const auto chains = viable_chains(
      {{0, 10}, {40, 10}, {40, 30}, {60, 30}, {60, 10}, {100, 10}, {100, 80}, {0, 80}});
  EXPECT_EQ(
      std::ranges::count_if(chains, [](const Chain& c) { return c.kind == EdgeKind::facing; }), 3);
  for (std::size_t i = 1; i < chains.size(); ++i)
    EXPECT_LT(chains[i - 1].edges.front(), chains[i].edges.front()) << "in order";
}

}  // namespace
}  // namespace planish::test
