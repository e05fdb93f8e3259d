#include "brake/random_table.hpp"
#include "stroke_work.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace planish::test {
namespace {

using namespace brake_detail;

/// With all patience each guide finds a plan exactly if there is one, and it can be made.
TEST(DepthFirst, FindsAPlanIfThereIsOne) {
  int plans = 0, none = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const double feasible = std::array{0.08, 0.15, 0.4}[seed % 3];
    const RandomTable random(seed, {.most_lines = 6, .feasible = feasible});
    StrokeProblem problem = random.problem();
    for (int line = 0; line < problem.lines; ++line)
      problem.depth.push_back((line * 7) % 5);
    for (const Guide guide :
         {Guide::cost, Guide::outside_in, Guide::first_line, Guide::last_line}) {
      const StrokeLimits limits;
      const StrokeWeights weights;
      const Progress progress;
      StrokeWork work(problem, weights, limits, progress);
      EXPECT_TRUE(search_depth_first(work, {}, 1'000'000, guide));
      EXPECT_EQ(work.has_plan(), cheapest_by_table(random.table(), weights).has_value()) << seed;
      std::uint64_t formed = 0;
      for (const int stroke : work.plan()) {
        const StrokeChoice& choice = work.book().choice(stroke).choice;
        EXPECT_TRUE(
            std::ranges::any_of(random.table().by_stage[formed], [&](const StrokeChoice& offered) {
              return offered.lines == choice.lines && set_up_of(offered) == set_up_of(choice);
            }));
        formed |= choice.lines[0];
      }
      ++(work.has_plan() ? plans : none);
    }
  }
  EXPECT_GT(plans, 200);
  EXPECT_GT(none, 100);
}

/// Where every stroke can be made the guide alone decides the order.
std::vector<int> order_of(Guide guide, const std::vector<int>& depth) {
  StrokeProblem problem;
  problem.lines = static_cast<int>(depth.size());
  problem.depth = depth;
  problem.choices = [&](const LineSet& formed) {
    std::vector<StrokeChoice> choices;
    for (int line = 0; line < std::ssize(depth); ++line)
      if (!holds(formed, line))
        choices.push_back({{std::uint64_t{1} << line}, 0, 0, true, 0, true});
    return choices;
  };
  const StrokeLimits limits;
  const StrokeWeights weights;
  const Progress progress;
  StrokeWork work(problem, weights, limits, progress);
  search_depth_first(work, {}, 0, guide);
  std::vector<int> order;
  for (const int stroke : work.plan())
    order.push_back(first_line(work.book().choice(stroke).choice.lines));
  return order;
}

TEST(DepthFirst, GoesTheWayItIsGuided) {
  const std::vector<int> depth{2, 0, 1, 3};
  EXPECT_EQ(order_of(Guide::first_line, depth), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(order_of(Guide::last_line, depth), (std::vector<int>{3, 2, 1, 0}));
  EXPECT_EQ(order_of(Guide::outside_in, depth), (std::vector<int>{1, 2, 0, 3}));
  EXPECT_EQ(order_of(Guide::cost, depth), (std::vector<int>{0, 1, 2, 3}));
}

/// Without patience it goes on only while every stroke can be made.
TEST(DepthFirst, TurnsBackOnlyWithinItsPatience) {
  StrokeProblem problem;
  problem.lines = 2;  // the first line first, and the second cannot follow
  problem.choices = [](const LineSet& formed) {
    std::vector<StrokeChoice> choices;
    if (formed[0] == 0) choices = {{{1}, 0, 0, true, 0, true}, {{2}, 1, 0, true, 0, true}};
    if (formed[0] == 2) choices = {{{1}, 0, 0, true, 0, true}};
    return choices;
  };
  for (const std::int64_t patience : {0, 100}) {
    const StrokeLimits limits;
    const StrokeWeights weights;
    const Progress progress;
    StrokeWork work(problem, weights, limits, progress);
    EXPECT_EQ(search_depth_first(work, {}, patience, Guide::first_line), patience > 0);
    EXPECT_EQ(work.has_plan(), patience > 0);
  }
}

}  // namespace
}  // namespace planish::test
