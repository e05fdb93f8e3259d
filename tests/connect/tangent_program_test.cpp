#include "tangent_program.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

/// Corners of two sides, and the ranges of them all.
struct TwoSides {
  std::array<RunEnvelope, 2> chains;
  std::array<CornerRange, 2> ranges;
  TwoSides(std::vector<Vec2> a, std::vector<Vec2> b)
      : chains{RunEnvelope(std::move(a)), RunEnvelope(std::move(b))} {
    for (std::size_t i = 0; i < 2; ++i)
      ranges[i] = {&chains[i], 0, static_cast<int>(chains[i].corners().size()) - 1};
  }
};

std::optional<TangentOptimum> cheapest(const TwoSides& sides, const TangentCost& cost,
                                       EdgeKind kind = EdgeKind::facing,
                                       const GivenLine& given = {}) {
  return cheapest_tangent(sides.ranges, kind, cost, given, size_of(sides.ranges));
}

const TwoSides& parallel() {
  static const TwoSides sides({{0, 10}, {100, 10}}, {{0, 16}, {100, 16}});
  return sides;
}

TEST(CheapestTangent, LiesOnTheNearerEdgeWhereExtensionCosts) {
  const auto best = cheapest(parallel(), {0.0, 1.0, Vec2::Zero()});
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.slope, 0.0, 1e-12);
  EXPECT_NEAR(best->line.at(50), 10.0, 1e-10);
  EXPECT_NEAR(best->value, 6.0, 1e-10) << "of the farther one";
}

TEST(CheapestTangent, LiesOnTheAxisWhereHeightCosts) {
  const auto best = cheapest(parallel(), {1.5, 1.0, Vec2::Zero()});
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.at(50), 0.0, 1e-10);
  EXPECT_NEAR(best->value, 26.0, 1e-10);
}

TEST(CheapestTangent, FollowsEdgesThatRunApart) {
  const TwoSides sides({{100, 20}, {300, 60}}, {{100, 20}, {300, 60}});
  const auto best = cheapest(sides, {0.1, 1.0, Vec2::Zero()});
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.slope, 0.2, 1e-12);
  EXPECT_NEAR(best->line.offset, 0.0, 1e-9);
  EXPECT_NEAR(best->value, 2 * 0.1 * 60, 1e-9);
}

TEST(CheapestTangent, LiesAboveTheCornersOfAvertedEdges) {
  const auto best = cheapest(parallel(), {1.0, 1.0, Vec2::Zero()}, EdgeKind::averted);
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.at(50), 16.0, 1e-10);
  EXPECT_NEAR(best->value, 2 * 16 + 6, 1e-10);
}

TEST(CheapestTangent, KeepsWhatIsGiven) {
  const TangentCost cost{0.0, 1.0, Vec2::Zero()};
  const auto slope = cheapest(parallel(), cost, EdgeKind::facing, {.slope = 0.05});
  ASSERT_TRUE(slope);
  EXPECT_EQ(slope->line.slope, 0.05);
  EXPECT_NEAR(slope->line.at(100), 10.0, 1e-9) << "as high as it can be";
  const auto offset = cheapest(parallel(), cost, EdgeKind::facing, {.offset = -4.0});
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->line.offset, -4.0, 1e-12);
  const auto apex = cheapest(parallel(), cost, EdgeKind::facing, {.apex = -100.0});
  ASSERT_TRUE(apex);
  EXPECT_NEAR(apex->line.at(-100), 0.0, 1e-10);
  EXPECT_NEAR(apex->line.at(100), 10.0, 1e-6) << "a given line may cut a plate by 1e-9 of its size";
}

TEST(CheapestTangent, IsNotThereWhereAPlateWouldBeCut) {
  const TangentCost cost{0.0, 1.0, Vec2::Zero()};
  EXPECT_FALSE(cheapest(parallel(), cost, EdgeKind::facing, {.slope = 0.11}));
  EXPECT_TRUE(cheapest(parallel(), cost, EdgeKind::facing, {.slope = 0.09}));
  EXPECT_FALSE(cheapest(parallel(), cost, EdgeKind::facing, {.slope = 0.0, .offset = -10.1}));
}

TEST(CheapestTangent, TakesASideWithoutCorners) {
  TwoSides sides({{0, 10}, {100, 20}}, {{0, 1}, {100, 1}});
  sides.ranges[1].last = -1;
  const auto best = cheapest(sides, {0.0, 1.0, Vec2::Zero()});
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->value, 0.0, 1e-10);
}

TEST(SizeOf, IsTheReachOfTheCornersAboutTheirMiddle) {
  const TwoSides sides({{100, 20}, {300, 60}}, {{150, 20}, {250, 70}});
  EXPECT_EQ(size_of(sides.ranges), 100.0);
}

}  // namespace
}  // namespace planish::test
