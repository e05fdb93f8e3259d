#include "sample_chains.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace planish::test {
namespace {

using namespace connect_detail;

constexpr double kAny = std::numeric_limits<double>::infinity();

using Runs = std::array<std::pair<int, int>, 2>;

TEST(Measured, IsHalfTheFactorTimesTheHeightsPlusExtensionsPlusShift) {
  // With Ψ̃ = 1 the line lies as high as it can: on y = 10.
  const SamplePair parallel({{0, 10}, {100, 10}}, {{20, 16}, {90, 16}}, 1.0);
  const auto choice = measured(parallel.pair, Runs{{{0, 0}, {0, 0}}});
  ASSERT_TRUE(choice);
  EXPECT_NEAR(choice->width, 0.5 * (100 + 70), 1e-12);
  EXPECT_NEAR(choice->span, 0.5 * (10 + 10) + (0 + 6) + (20 + 10), 1e-9);
  EXPECT_NEAR(choice->line.at(50), 10.0, 1e-9);
}

TEST(Measured, PutsTheLineOnTheAxisWhereHeightIsDear) {
  const SamplePair parallel({{0, 10}, {100, 10}}, {{0, 16}, {100, 16}}, 3.0);
  const auto choice = measured(parallel.pair, Runs{{{0, 0}, {0, 0}}});
  ASSERT_TRUE(choice);
  EXPECT_NEAR(choice->span, 26.0, 1e-9);
}

TEST(ReferenceBend, JoinsTheNearestEdges) {
  // Each side: an edge at 30, one at 10, one at 50.
  const std::vector<Vec2> steps{{0, 30}, {50, 30}, {51, 10}, {100, 10}, {101, 50}, {150, 50}};
  const SamplePair pair(steps, steps, 1.0);
  const auto bend = reference_bend(pair.pair, kAny);
  ASSERT_TRUE(bend);
  EXPECT_EQ(bend->choice.runs[0], (planish::Run{0, 2, 2}));
  EXPECT_EQ(bend->choice.runs[1], (planish::Run{0, 2, 2}));
  // ½ Ψ̃ per side on heights of 10, without extension.
  EXPECT_NEAR(bend->length, 0.5 * (10 + 10), 1e-9);
}

TEST(ReferenceBend, PaysForWhatTheEdgesAreShifted) {
  // The nearest edge of the second side lies beside that of the first: one farther off is shorter.
  const SamplePair pair({{0, 10}, {100, 10}}, {{0, 12}, {100, 12}, {101, 10}, {201, 10}}, 1.0);
  const auto bend = reference_bend(pair.pair, kAny);
  ASSERT_TRUE(bend);
  EXPECT_EQ(bend->choice.runs[1], (planish::Run{0, 0, 0}));
  EXPECT_NEAR(bend->length, 10 + 2, 1e-9);
}

TEST(ReferenceBend, UsesAllEdgesThatAreFixed) {
  SamplePair pair({{0, 10}, {100, 10}, {200, 20}}, {{0, 10}, {200, 10}}, 1.0);
  pair.pair.fixed[0] = std::pair{0, 1};
  const auto bend = reference_bend(pair.pair, kAny);
  ASSERT_TRUE(bend);
  EXPECT_EQ(bend->choice.runs[0], (planish::Run{0, 0, 1}));
}

TEST(ReferenceBend, IsNotThereBeyondTheBound) {
  const SamplePair pair({{0, 10}, {100, 10}}, {{0, 10}, {100, 10}}, 1.0);
  EXPECT_TRUE(reference_bend(pair.pair, 10.0 + 1e-6));
  EXPECT_FALSE(reference_bend(pair.pair, 10.0 - 1e-6));
}

TEST(Better, IsTheWiderThenTheShorterThenTheOneOfSmallerNumbers) {
  const SamplePair pair({{0, 10}, {100, 10}}, {{0, 10}, {100, 10}}, 1.0);
  EdgeChoice a, b;
  a.width = 10.0;
  b.width = 9.0;
  EXPECT_TRUE(better(pair.pair, a, b));
  EXPECT_FALSE(better(pair.pair, b, a));
  b.width = 10.0 + 1e-12;  // equal
  a.span = 4.0;
  b.span = 5.0;
  EXPECT_TRUE(better(pair.pair, a, b));
  b.span = 4.0;
  b.runs[1] = {0, 1, 1};
  EXPECT_TRUE(better(pair.pair, a, b));
  EXPECT_FALSE(better(pair.pair, b, a));
}

}  // namespace
}  // namespace planish::test
