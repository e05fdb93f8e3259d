#include "brake/random_table.hpp"
#include "stroke_work.hpp"

#include <gtest/gtest.h>

#include <array>

namespace planish::test {
namespace {

using namespace brake_detail;

/// The search alone, without a plan to begin with, finds what brute force does.
TEST(BestFirst, FindsTheCheapestPlan) {
  int plans = 0, none = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const double feasible = std::array{0.08, 0.2, 0.5}[seed % 3];
    const RandomTable random(seed, {.most_lines = 6, .feasible = feasible});
    StrokeProblem problem = random.problem();
    if (seed % 2) problem.possible = random.possible();
    if (seed % 2 && problem.possible.empty()) continue;
    const StrokeLimits limits;
    const StrokeWeights weights;
    const Progress progress;
    StrokeWork work(problem, weights, limits, progress);
    if (!work.hopeless().empty()) continue;
    EXPECT_TRUE(search_best_first(work));
    const auto cheapest = cheapest_by_table(random.table(), weights);
    EXPECT_EQ(work.has_plan(), cheapest.has_value()) << seed;
    if (cheapest) {
      EXPECT_NEAR(work.cheapest(), *cheapest, 1e-9) << seed;
      EXPECT_NEAR(cost_of(work.book(), work.plan()), *cheapest, 1e-9);
      EXPECT_LE(work.proven(), *cheapest + 1e-9);
    }
    ++(cheapest ? plans : none);
  }
  EXPECT_GT(plans, 150);
  EXPECT_GT(none, 30);
}

TEST(BestFirst, EndsAtItsLimit) {
  const RandomTable random(5, {.most_lines = 7, .feasible = 0.5});
  const StrokeProblem problem = random.problem();
  StrokeLimits limits;
  limits.stages = 1;
  const StrokeWeights weights;
  const Progress progress;
  StrokeWork work(problem, weights, limits, progress);
  EXPECT_FALSE(search_best_first(work));
}

/// What the bound cannot know: the last stroke takes another punch. All but one of the 2^20 stages
/// promise less than a plan costs, and are looked at before the last; but from time to time the
/// search goes down to a whole plan.
TEST(BestFirst, HasAPlanLongBeforeItIsProven) {
  constexpr int kLines = 20;
  StrokeProblem problem;
  problem.lines = kLines;
  problem.choices = [](const LineSet& formed) {
    std::vector<StrokeChoice> choices;
    for (int line = 0; line < kLines; ++line)
      for (const int punch : {0, 1})
        if (!holds(formed, line)) choices.push_back({only(kLines, line), punch});
    return choices;
  };
  problem.check = [](const LineSet& formed, const StrokeChoice& choice) -> StrokeVerdict {
    return {(choice.punch == 1) == (count(formed) == kLines - 1), {}};
  };
  problem.possible = problem.choices(no_lines(kLines));
  StrokeLimits limits;
  limits.stages = 2000;
  const StrokeWeights weights;
  const Progress progress;
  StrokeWork work(problem, weights, limits, progress);
  EXPECT_FALSE(search_best_first(work));
  EXPECT_NEAR(work.proven(), kLines * weights.stroke, 1e-9);
  ASSERT_TRUE(work.has_plan());
  EXPECT_NEAR(work.cheapest(), kLines * weights.stroke + weights.tool_change, 1e-9);
  EXPECT_EQ(work.plan().size(), std::size_t{kLines});
}

}  // namespace
}  // namespace planish::test
