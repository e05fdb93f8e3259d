#include "fewer_set_ups.hpp"

#include "brake/checked_order.hpp"
#include "brake/stroke_room.hpp"
#include "plan_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace planish::test {
namespace {

using namespace brake_detail;

/// The least that any order of four bends costs, one stroke each, with every set-up it takes.
double cheapest_of_all(Checked& part) {
  std::vector<int> order{0, 1, 2, 3};
  double least = 1e9;
  do {
    const CheckedOrder checked = part.check(one_by_one(order));
    if (checked.feasible()) least = std::min(least, checked.cost);
  } while (std::ranges::next_permutation(order).found);
  return least;
}

/// A shop with a few segments: of the short lines of a box those are pressed first that the row of
/// the long ones presses while nothing is in its way; or the rows stand side by side.
TEST(FewerSetUps, AreFoundWhicheverSegmentsThereAre) {
  std::mt19937 random(39);
  int cheaper = 0, plans = 0;
  for (int shop = 0; shop < 24; ++shop) {
    std::vector<double> segments{70};
    for (int i = 0; i < 3; ++i)
      segments.push_back(5.0 * std::uniform_int_distribution<int>(1, 9)(random));
    Checked part(box({70.0, 45.0, 30.0}),
                 plain_tools({.segments = segments}, {.segments = segments}));
    const double least = cheapest_of_all(part);
    const Plan plan = part.plan();
    if (least > 1e8) {
      EXPECT_TRUE(plan.strokes.empty());
      continue;
    }
    ++plans;
    EXPECT_LE(plan.cost, least + 1e-9) << shop;
    const auto as_listed = part.check(one_by_one({0, 1, 2, 3}));
    cheaper += as_listed.feasible() && as_listed.cost > plan.cost + 1.0 ? 1 : 0;
    EXPECT_EQ(plan.status == PlanStatus::optimal, plan.tool_changes == 0) << shop;
  }
  EXPECT_GT(plans, 12);
  EXPECT_GT(cheaper, 3) << "the order matters";
}

/// Nothing is as cheap as what is asked for, or can be made at all.
TEST(FewerSetUps, AreNotMadeUp) {
  Room room(box({70.0, 45.0, 30.0}), plain_tools());
  const StrokeProblem problem = problem_of(room.cache());
  const double least = search_strokes(problem, room.inputs().options.weights)->cost;
  EXPECT_TRUE(with_fewer_set_ups(room.cache(), problem, least, {}).empty());
  const auto found = with_fewer_set_ups(room.cache(), problem, least + 0.5, {});
  ASSERT_EQ(found.size(), 4u);
  LineSet formed = no_lines(4);
  for (const StrokeChoice& stroke : found) {
    EXPECT_TRUE(check(room.cache(), formed, stroke).feasible);
    formed = joined(formed, stroke.lines);
  }
  EXPECT_EQ(formed, all_lines(4));
  EXPECT_TRUE(
      with_fewer_set_ups(room.cache(), problem, least + 0.5, Progress({}, [] { return true; }))
          .empty());
}

}  // namespace
}  // namespace planish::test
