#include "drawn_edges.hpp"

#include "sample_chains.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

// Edges that a drawing has brought to the bend: both sides in (x, height over the line where the
// planes meet), a bend that lies level at 20.

namespace planish::test {
namespace {

using namespace connect_detail;
using Edges = std::array<std::vector<int>, 2>;

constexpr double kLevel = 20.0;

std::optional<Edges> drawn(const std::vector<Vec2>& a, const std::vector<Vec2>& b,
                           EdgeKind kind = EdgeKind::facing) {
  PairChoice choice;
  choice.search.best.kind = kind;
  choice.search.best.line = {0.0, -kLevel};
  for (const auto& [side, corners] : {std::pair{0, a}, std::pair{1, b}}) {
    choice.chains[side] = {SamplePair::chain(corners, kind)};
    choice.search.best.runs[side] = {0, 0, static_cast<int>(corners.size()) - 2};
  }
  return drawn_edges(choice);
}

/// A run from `from` to `to` at the bend with a recess from 100 to 140, `deep` away from it: edges
/// 0 and 4 are at the bend.
std::vector<Vec2> recessed(double from, double to, double deep = 15.0) {
  return {{from, kLevel},       {100, kLevel}, {105, kLevel + deep},
          {135, kLevel + deep}, {140, kLevel}, {to, kLevel}};
}

std::vector<Vec2> straight(const std::vector<double>& xs, double height = kLevel) {
  return mapped(xs, [&](double x) { return Vec2(x, height); });
}

TEST(DrawnEdges, LeaveTheChoiceAsItIsWhereAllIsDrawnForEachOther) {
  EXPECT_FALSE(drawn(straight({0, 200}), straight({0, 200})));
  EXPECT_FALSE(drawn(straight({0, 80, 200}), straight({0, 120, 200}))) << "corners between ends";
  EXPECT_FALSE(drawn({{0, 20}, {100, 25}}, {{0, 20}, {100, 25}})) << "not on the bend";
}

TEST(DrawnEdges, AreTheWiderOfTwoStretchesBesideARecess) {
  EXPECT_EQ(drawn(recessed(0, 200), recessed(0, 200)), (Edges{{{0}, {0}}}));
  EXPECT_EQ(drawn(recessed(50, 200), recessed(50, 200)), (Edges{{{4}, {4}}}));
  // Of bends round the back the recess lies on the side of the line.
  EXPECT_EQ(drawn(recessed(0, 200, -15), recessed(0, 200, -15), EdgeKind::averted),
            (Edges{{{0}, {0}}}));
  EXPECT_EQ(drawn(recessed(50, 200, -15), recessed(50, 200, -15), EdgeKind::averted),
            (Edges{{{4}, {4}}}));
}

TEST(DrawnEdges, HaveTheirEndsOppositeEachOther) {
  // The wider stretch of one plate is 10 shorter than that of the other.
  EXPECT_EQ(drawn(recessed(0, 200), recessed(10, 200)), (Edges{{{4}, {4}}}));
  // Within a hundredth of a millimetre.
  EXPECT_EQ(drawn(recessed(0, 200), recessed(0.009, 200)), (Edges{{{0}, {0}}}));
  EXPECT_EQ(drawn(recessed(0, 200), recessed(-0.011, 200)), (Edges{{{4}, {4}}}));
}

TEST(DrawnEdges, ArePartOfALongerRowOfEdges) {
  EXPECT_EQ(drawn(straight({0, 50, 120, 200}), straight({50, 120})), (Edges{{{1}, {0}}}));
  EXPECT_EQ(drawn(straight({50, 120}), straight({0, 50, 120, 200})), (Edges{{{0}, {1}}}));
  EXPECT_EQ(drawn(straight({0, 50, 120, 200}), straight({50, 90, 200})), (Edges{{{1, 2}, {0, 1}}}));
  // None has an end opposite an end, and nothing interrupts them: both are used as they are.
  EXPECT_FALSE(drawn(straight({0, 200}), straight({10, 190})));
}

TEST(DrawnEdges, LieWithinAHundredthOfTheBend) {
  EXPECT_EQ(drawn(straight({0, 50, 120}, kLevel + 0.009), straight({50, 120})),
            (Edges{{{1}, {0}}}));
  EXPECT_FALSE(drawn(straight({0, 50, 120}, kLevel + 0.011), straight({50, 120})));
  EXPECT_FALSE(drawn(straight({50, 120}), straight({0, 50, 120}, kLevel + 0.011)));
}

TEST(DrawnEdges, AreThoseWithMostWidthInCommonWhereNoneMatch) {
  EXPECT_EQ(drawn(recessed(0, 200), straight({10, 95})), (Edges{{{0}, {0}}}));
  EXPECT_EQ(drawn(straight({10, 95}), recessed(0, 200)), (Edges{{{0}, {0}}}));
  EXPECT_EQ(drawn(recessed(0, 250), straight({60, 148, 240})), (Edges{{{4}, {1}}}))
      << "the edge from 60 to 148 has but 8 of its 88 in common with the wider stretch";
}

TEST(DrawnEdges, TakePartWithMoreThanATenth) {
  // Up to the recess one plate has an edge of 5 and one of 95; the other begins within the former.
  std::vector<Vec2> stepped = recessed(0, 120);
  stepped.insert(stepped.begin() + 1, {5, kLevel});
  EXPECT_EQ(drawn(stepped, straight({4.6, 95})), (Edges{{{1}, {0}}}));
  EXPECT_EQ(drawn(stepped, straight({4.4, 95})), (Edges{{{0, 1}, {0}}}));
}

}  // namespace
}  // namespace planish::test
