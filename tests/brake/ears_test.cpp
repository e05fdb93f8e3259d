#include "brake/stroke_room.hpp"

#include <planish/brake/plan.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kThickness = 1.0;
constexpr double kUnderLip = 30.0;  // above the base's upper skin

BrakeTools eared_tools(const std::optional<Ears>& ears) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0});
  tools.punches[0].ears = ears;
  return tools;
}

bool presses_last(double lip, const std::optional<Ears>& ears) {
  Room room(lipped_base(lip), eared_tools(ears));
  return room.can_press(1, {2, 3});
}

/// The lip ends 120 − lip from the line's other end. The row may end a shortfall of T before the
/// line does; its body then has to end before the lip.
TEST(Ears, ReachPastALip) {
  constexpr double kLip = 15.0, kPenetrates = 0.05;
  const double needed = kLip - kThickness - kPenetrates;
  for (const double step : {-0.1, 0.1}) {
    const Ears ears{50.0, 50.0, 25.0, needed + step};
    EXPECT_EQ(presses_last(kLip, ears), step > 0.0) << step;
  }
  EXPECT_FALSE(presses_last(kLip, std::nullopt));
}

/// The foot goes below the lip. Its front edge, 6 in front of the line, is at the punch, 4 thick on
/// either side, when the base has turned by some 4°, and there less than 1 higher than at first.
TEST(Ears, AreAsHighAsTheLipAllows) {
  EXPECT_TRUE(presses_last(15.0, Ears{50.0, 50.0, kUnderLip - 0.2, 20.0}));
  EXPECT_FALSE(presses_last(15.0, Ears{50.0, 50.0, kUnderLip + 0.6, 20.0}));
}

/// With the gauge behind the base the wall is on one side of the operator, with the gauge behind
/// the flap on the other: one ear will do for one of them.
TEST(Ears, StandOnTheirSideOfTheOperator) {
  const auto directions = [](const Ears& ears) {
    Room room(lipped_base(15.0), eared_tools(ears));
    std::vector<int> found;
    for (const StrokeChoice& way : room.ways(1, {2, 3}))
      found.push_back(way.direction);
    return found;
  };
  const std::vector<int> left = directions({50.0, 0.0, 25.0, 20.0}),
                         right = directions({0.0, 50.0, 25.0, 20.0}),
                         both = directions({50.0, 50.0, 25.0, 20.0});
  ASSERT_EQ(left.size(), 1u);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_NE(left[0], right[0]);
  EXPECT_EQ(both.size(), 2u);
}

/// What the plan tells: the row ends in the ear under the lip, which the part hangs on.
TEST(Ears, AreNamedWhereTheyStand) {
  const Sheet sheet = lipped_base(15.0);
  const auto flat = flat_sheet(sheet);
  ASSERT_TRUE(flat);
  PlanOptions options;
  options.begin_with = {BendId(2), BendId(1), BendId(0)};
  const auto plan = plan_bending(sheet, flat->layout, eared_tools(Ears{50.0, 50.0, 25.0, 20.0}),
                                 options);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->strokes.size(), 3u);
  const Stroke& last = plan->strokes[2];
  ASSERT_EQ(last.bends, std::vector<BendId>{BendId(0)});
  EXPECT_TRUE(last.on_ears);
  EXPECT_FALSE(plan->strokes[0].on_ears);
  const SegmentRow& row = last.punch_rows.front();
  EXPECT_EQ(std::max(row.left_ear, row.right_ear), 20.0);
  const std::string text = text_of(row, [](double mm) { return std::to_string(std::lround(mm)); });
  EXPECT_NE(text.find(row.left_ear > 0.0 ? "left ear 50" : "right ear 50"), std::string::npos)
      << text;
  for (const Station& station : plan->stations)
    if (std::ranges::count(station.strokes, 2) > 0) {
      EXPECT_EQ(station.punch_rows.front().segments, row.segments);
      EXPECT_EQ(station.punch_rows.front().left_ear, row.left_ear);
    }
}

/// An ear is a segment like others where nothing is beside it, and is there once.
TEST(Ears, PressLikeOtherSegments) {
  const SegmentSums sums({40, 20});
  RowRequest request{{{0, 90}}, 0.0, {}, 1000, {50, 0, 20}};
  auto rows = tool_rows(sums, request);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].segments, (std::vector<double>{50, 40}));
  request.pieces = {{0, 60}};  // 40 + 20 is as long as it has to be, 50 + 20 is not
  rows = tool_rows(sums, request);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].ears.any());
  request.pieces = {{0, 111}};
  EXPECT_TRUE(tool_rows(sums, request).empty());
}

/// A part with lips at both ends, each over a foot: the ears, 50 each, come free where that much is
/// between the lips.
TEST(Ears, CanBePushedTogetherBetweenLips) {
  const SegmentSums sums({100, 40, 20, 10, 5});
  for (const double lip : {24.0, 26.0}) {
    RowRequest request{{{0, 150}}, 0, {{-5, lip}, {150 - lip, 155}}, 1000, {50, 50, 30}};
    request.blocked_foot = {{-5, 0}, {150, 155}};
    const auto rows = tool_rows(sums, request);
    ASSERT_EQ(rows.size(), lip < 25.0 ? 1u : 0u) << lip;
    if (!rows.empty()) {
      EXPECT_EQ(rows[0].segments, (std::vector<double>{50, 40, 10, 50}));
    }
  }
}

}  // namespace
}  // namespace planish::test
