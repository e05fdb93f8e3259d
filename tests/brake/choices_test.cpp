#include "choices.hpp"

#include "brake/hemming_tools.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Two flaps on one edge are pressed together; each alone as well.
TEST(Choices, PressBendsOnOneLineTogether) {
  Room room(two_flaps(), plain_tools());
  const LineSet flat = room.lines({});
  bool together = false, alone = false;
  for (const StrokeChoice& choice : choices(room.cache(), flat)) {
    EXPECT_TRUE(check(room.cache(), flat, choice).feasible);
    if (count(choice.lines) == 2) {
      together = true;
      const Stroke stroke = describe(room.cache(), flat, choice);
      EXPECT_EQ(stroke.bends.size(), 2u);
      // 80 mm of line under a V of 12: 1.42 · 450 / 12 N/mm.
      EXPECT_NEAR(stroke.force, 80.0 * 1.42 * 450.0 / 12.0 / 1000.0, 1e-9);
      // 100 mm less one thickness at each end, in segments of 10 … : 98 takes 100.
      ASSERT_EQ(stroke.punch_rows.size(), 1u);
      const auto& segments = stroke.punch_rows.front().segments;
      EXPECT_NEAR(std::accumulate(segments.begin(), segments.end(), 0.0), 100.0, 1e-9);
    }
    alone |= count(choice.lines) == 1;
  }
  EXPECT_TRUE(together && alone);
  EXPECT_EQ(choices(room.cache(), room.lines({1})).size(), 2u);
}

/// What is told possible covers what any stage offers: same tools, side and direction, its lines
/// and perhaps more.
TEST(Choices, AreCoveredByWhatIsPossible) {
  BrakeTools tools = plain_tools();
  tools.punches.push_back(punch({Angle::degrees(60), 14.0}));
  for (const Sheet& sheet : {box(), staircase(2), u_channel()}) {
    Room room(sheet, tools);
    const std::vector<StrokeChoice> all = possible(room.inputs());
    for (std::uint64_t stage = 0; stage + 1 < std::uint64_t{1} << room.inputs().lines(); ++stage) {
      const std::vector<StrokeChoice> offered = choices(room.cache(), {stage});
      // Each line that is left, with both punches and towards both sides.
      EXPECT_EQ(std::ssize(offered), 4 * (room.inputs().lines() - count({stage})));
      for (const StrokeChoice& choice : offered) {
        EXPECT_TRUE(disjoint(choice.lines, {stage}));
        EXPECT_TRUE(std::ranges::any_of(all, [&](const StrokeChoice& row) {
          return within(choice.lines, row.lines) && row.punch == choice.punch &&
                 row.die == choice.die && row.direction == choice.direction &&
                 row.reference_up == choice.reference_up;
        }));
      }
    }
  }
}

/// From the outside in: on one side of what is pressed everything is formed. Along a strip that is
/// all before the bend or all after it.
TEST(Choices, KnowWhatIsOutermost) {
  Room room(staircase(2), plain_tools());
  for (std::uint64_t stage = 0; stage < 16; ++stage) {
    std::vector<int> formed;
    for (int bend = 1; bend <= 4; ++bend)
      if (stage >> (bend - 1) & 1) formed.push_back(bend);
    for (int bend = 1; bend <= 4; ++bend) {
      if (stage >> (bend - 1) & 1) continue;
      bool before = true, after = true;
      for (int other = 1; other <= 4; ++other) {
        if (other < bend) before = before && (stage >> (other - 1) & 1);
        if (other > bend) after = after && (stage >> (other - 1) & 1);
      }
      StrokeChoice choice;
      choice.lines = room.lines({bend});
      EXPECT_EQ(is_outermost(room.cache(), room.lines(formed), choice), before || after);
    }
  }
}

/// A hem is offered once it is bent; closing it takes no gauge and both flat tools.
TEST(Choices, OfferToCloseAHemThatIsBent) {
  const BrakeTools tools = hemming_tools();
  const Sheet sheet = hem();
  auto work = workpiece_of(sheet, flat_sheet(sheet)->layout, {1.0, Angle::degrees(150)});
  const StrokeInputs inputs = stroke_inputs(std::move(*work), tools, {});
  StageCache cache(inputs);
  for (const StrokeChoice& choice : choices(cache, {0}))
    EXPECT_EQ(members(choice.lines), std::vector<int>{0});
  const auto closing = choices(cache, {1});
  EXPECT_EQ(closing.size(), 2u);
  for (const StrokeChoice& choice : closing) {
    EXPECT_EQ(members(choice.lines), std::vector<int>{1});
    EXPECT_TRUE(choice.gauged);
    EXPECT_EQ(tools.punches[choice.punch].id, "F");
    EXPECT_EQ(tools.dies[choice.die].id, "F");
  }
}

}  // namespace
}  // namespace planish::test
