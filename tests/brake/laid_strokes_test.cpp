#include "laid_strokes.hpp"

#include "brake/stroke_room.hpp"
#include "plan_search.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

LaidStrokes laid(Room& room) {
  const auto search = search_plan(room.cache(), {});
  EXPECT_TRUE(search);
  return laid_strokes(room.cache(), *search, {});
}

/// With segments enough the strokes are those that were found.
TEST(LaidStrokes, AreThoseFoundWhereTheBedHasRoom) {
  Room room(box({70.0, 45.0, 30.0}), plain_tools());
  const auto search = search_plan(room.cache(), {});
  ASSERT_TRUE(search);
  const LaidStrokes all = laid(room);
  EXPECT_FALSE(all.is_dearer);
  EXPECT_EQ(all.search.cost, search->cost);
  EXPECT_EQ(all.bed.set_ups, 1);
}

/// 40 + 20 + 10 and 40 + 5 do not stand at once, but the row of 70 presses the short lines too if
/// these come first.
TEST(LaidStrokes, ComeInAnotherOrderWhereThatTakesFewerSetUps) {
  const std::vector<double> segments{40, 20, 10, 5};
  Room room(box({70.0, 45.0, 30.0}), plain_tools({.segments = segments}, {.segments = segments}));
  const LaidStrokes all = laid(room);
  EXPECT_FALSE(all.is_dearer);
  EXPECT_EQ(all.search.tool_changes, 0);
  ASSERT_EQ(all.chosen.size(), 4u);
  for (const int bend : {1, 3})
    EXPECT_TRUE(holds(all.chosen[2].formed, room.line_of(bend)) ||
                holds(all.chosen[2].formed, room.line_of(bend == 1 ? 2 : 4)));
}

/// Bends that are told to come first leave no such order: what it costs more is counted, and the
/// plan is not called the cheapest.
TEST(LaidStrokes, CountEverySetUp) {
  const std::vector<double> segments{40, 20, 5};
  PlanOptions options;
  options.begin_with = {BendId(0), BendId(2)};
  Room room(box({70.0, 45.0, 30.0}), plain_tools({.segments = segments}, {.segments = segments}),
            options);
  const auto search = search_plan(room.cache(), {});
  ASSERT_TRUE(search);
  const LaidStrokes all = laid(room);
  EXPECT_TRUE(all.is_dearer);
  EXPECT_EQ(all.search.tool_changes, 1);
  EXPECT_EQ(all.search.cost, search->cost + options.weights.tool_change);
}

}  // namespace
}  // namespace planish::test
