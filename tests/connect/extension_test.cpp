#include <planish/connect/codes.hpp>
#include <planish/connect/edge_search.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using Corners = std::array<std::vector<Vec2>, 2>;

const Corners kParallel{{{{0, 10}, {100, 10}}, {{20, 16}, {100, 16}}}};

TEST(ExtensionArea, IsBetweenTheEdgesAndTheLine) {
  EXPECT_NEAR(extension_area(kParallel, EdgeKind::facing, {0.0, -4.0}), 100 * 6 + 80 * 12, 1e-9);
  EXPECT_NEAR(extension_area(kParallel, EdgeKind::averted, {0.0, -20.0}), 100 * 10 + 80 * 4, 1e-9);
  // 0.1 x under an edge at 10: a triangle.
  EXPECT_NEAR(
      extension_area({{{{0, 10}, {100, 10}}, {{0, 10}, {100, 10}}}}, EdgeKind::facing, {0.1, 0.0}),
      2 * 0.5 * 100 * 10, 1e-9);
}

TEST(SmallestExtension, LiesOnTheNearerEdge) {
  const auto best = smallest_extension(kParallel, EdgeKind::facing);
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.at(0), 10.0, 1e-9);
  EXPECT_NEAR(best->line.at(100), 10.0, 1e-9);
  EXPECT_NEAR(best->area, 80 * 6, 1e-6);
}

TEST(SmallestExtension, IsNothingWhereBothEdgesAreOneLine) {
  const Corners corners{{{{100, 20}, {300, 60}}, {{150, 30}, {300, 60}}}};
  const auto best = smallest_extension(corners, EdgeKind::facing);
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.slope, 0.2, 1e-12);
  EXPECT_NEAR(best->area, 0.0, 1e-6);
}

TEST(SmallestExtension, RestsOnTheCornersOfAnArch) {
  // Of all lines below (0, 10), (50, 4), (100, 10), the level one through the middle is best: by
  // symmetry, and lines through one corner are equally good only about the middle.
  const std::vector<Vec2> arch{{0, 10}, {50, 4}, {100, 10}};
  const auto best = smallest_extension({arch, arch}, EdgeKind::facing);
  ASSERT_TRUE(best);
  EXPECT_NEAR(best->line.at(50), 4.0, 1e-9);
  EXPECT_NEAR(best->line.slope, 0.0, 1e-12) << "the smallest of all slopes";
}

TEST(SmallestExtension, SaysWhichSlopesThereAre) {
  const auto refused = smallest_extension(kParallel, EdgeKind::facing, {.slope = 0.2});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::no_bend_fits);
  EXPECT_NE(refused.error().message.find("from -0.1 to 0.1"), std::string::npos)
      << refused.error().message;
}

TEST(FeasibleSlopes, AreThoseOfLinesBetweenTheAxisAndTheEdges) {
  const auto slopes = feasible_slopes(kParallel, EdgeKind::facing);
  ASSERT_TRUE(slopes);
  EXPECT_NEAR(slopes->low, -0.1, 1e-9);
  EXPECT_NEAR(slopes->high, 0.1, 1e-9);
  EXPECT_TRUE(std::isinf(feasible_slopes(kParallel, EdgeKind::averted)->high));
}

TEST(FeasibleOffsets, AreThoseOfTheSlope) {
  // 0 ≤ 0.05 x − q ≤ 10 from x = 0 to 100: −5 ≤ q ≤ 0.
  const auto offsets = feasible_offsets(kParallel, EdgeKind::facing, 0.05);
  ASSERT_TRUE(offsets);
  EXPECT_NEAR(offsets->low, -5.0, 1e-12);
  EXPECT_NEAR(offsets->high, 0.0, 1e-12);
  EXPECT_FALSE(feasible_offsets(kParallel, EdgeKind::facing, 0.2));
  // 0.05 x − q ≥ 10 at x = 0, and 16 at x = 20.
  EXPECT_NEAR(feasible_offsets(kParallel, EdgeKind::averted, 0.05)->high, -15.0, 1e-12);
}

TEST(Extension, StopsWithoutCorners) {
  EXPECT_DEATH((void)extension_area({}, EdgeKind::facing, {0.0, 0.0}), "empty");
  EXPECT_DEATH((void)smallest_extension({}, EdgeKind::facing), "empty");
  EXPECT_DEATH((void)feasible_slopes({}, EdgeKind::facing), "empty");
}

}  // namespace
}  // namespace planish::test
