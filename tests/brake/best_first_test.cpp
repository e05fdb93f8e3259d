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

}  // namespace
}  // namespace planish::test
