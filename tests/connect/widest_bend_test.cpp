#include "sample_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace connect_detail;

/// Edges 40 long at the heights 10, 20, 40 … on both sides: each makes the bend wider and longer.
SamplePair& stairs() {
  static const std::vector<Vec2> corners{{0, 10}, {40, 10}, {80, 20}, {120, 40}, {160, 80}};
  static SamplePair pair(corners, corners, 1.0);
  return pair;
}

EdgeChoice first_edges() {
  return *measured(stairs().pair, std::array{std::pair{0, 0}, std::pair{0, 0}});
}

TEST(WidestBend, StaysWithTheReferenceWhereWidthIsWorthNothing) {
  const auto found = widest_bend(stairs().pair, first_edges(), 0.0, std::nullopt);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, 40.0, 1e-9);
}

TEST(WidestBend, TakesAllEdgesWhereWidthIsWorthEverything) {
  const auto found = widest_bend(stairs().pair, first_edges(), 100.0, std::nullopt);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->width, 160.0, 1e-9);
  EXPECT_EQ(found->runs[0], (planish::Run{0, 0, 3}));
}

TEST(WidestBend, GrowsAsFarAsTheSpanIsPaidFor) {
  // The rule itself, over all runs.
  const EdgeChoice reference = first_edges();
  for (const double trade_off : {0.1, 0.3, 0.5, 0.8, 1.2}) {
    double widest = 0.0;
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b)
        for (int c = 0; c < 4; ++c)
          for (int d = c; d < 4; ++d) {
            const auto choice = measured(stairs().pair,
                                         std::array{std::pair{a, b}, std::pair{c, d}});
            if (choice && choice->span - reference.span <=
                              trade_off * (choice->width - reference.width) + 1e-9)
              widest = std::max(widest, choice->width);
          }
    const auto found = widest_bend(stairs().pair, reference, trade_off, std::nullopt);
    ASSERT_TRUE(found) << trade_off;
    EXPECT_NEAR(found->width, widest, 1e-9) << trade_off;
  }
}

TEST(WidestBend, IsNothingWhereABetterOneIsKnown) {
  EdgeChoice known = first_edges();
  known.width = 1000.0;
  EXPECT_FALSE(widest_bend(stairs().pair, first_edges(), 100.0, known));
  known.width = 100.0;
  EXPECT_TRUE(widest_bend(stairs().pair, first_edges(), 100.0, known));
}

TEST(WidestBend, KeepsEdgesThatAreFixed) {
  static const std::vector<Vec2> corners{{0, 10}, {40, 10}, {80, 20}, {120, 40}, {160, 80}};
  SamplePair pair(corners, corners, 1.0);
  pair.pair.fixed[0] = std::pair{1, 2};
  const auto reference = reference_bend(pair.pair, 1e300);
  ASSERT_TRUE(reference);
  const auto found = widest_bend(pair.pair, reference->choice, 100.0, std::nullopt);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->runs[0], (planish::Run{0, 1, 2}));
  EXPECT_EQ(found->runs[1], (planish::Run{0, 0, 3}));
}

}  // namespace
}  // namespace planish::test
