#include "brake/random_table.hpp"
#include "stroke_work.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

/// A line is seen exactly if a stage that can be reached forms it.
TEST(Reachable, SeesWhatAnyStageForms) {
  int blocked = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const RandomTable random(seed, {.most_lines = 6, .feasible = seed % 2 ? 0.05 : 0.1});
    const StrokeProblem problem = random.problem();
    const StrokeLimits limits;
    const StrokeWeights weights;
    const Progress progress;
    StrokeWork work(problem, weights, limits, progress);
    EXPECT_TRUE(search_reachable(work));
    const std::vector<int> never = blocked_by_table(random.table());
    for (int line = 0; line < problem.lines; ++line)
      EXPECT_EQ(work.book().seen(line), !std::ranges::count(never, line)) << seed << " " << line;
    EXPECT_EQ(work.all_seen(), never.empty());
    blocked += never.empty() ? 0 : 1;
  }
  EXPECT_GT(blocked, 100);
}

TEST(Reachable, StopsWhenItIsCancelled) {
  const RandomTable random(3, {.most_lines = 7, .feasible = 0.02});
  const StrokeProblem problem = random.problem();
  const StrokeLimits limits;
  const StrokeWeights weights;
  Progress progress;
  progress.cancelled = [] { return true; };
  StrokeWork work(problem, weights, limits, progress);
  EXPECT_FALSE(search_reachable(work));
}

}  // namespace
}  // namespace planish::test
