#include "describe.hpp"

#include "brake/hemming_tools.hpp"
#include "brake/stroke_room.hpp"
#include "closing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Seen from the other side of the machine, segments stand the other way round.
TEST(Describe, TellsRowsAsTheOperatorSeesThem) {
  BoxSize size;
  size.length = 120.0;
  const BrakeTools tools = plain_tools(PlainPunch{.segments = {40, 50, 20, 10}});
  Room room(box(size), tools);
  const LineSet flat = room.lines({});
  std::vector<Stroke> both;
  for (const StrokeChoice& choice : room.ways(1, {}))
    both.push_back(describe(room.cache(), flat, choice));
  ASSERT_EQ(both.size(), 2u);
  ASSERT_EQ(both[0].punch_rows.size(), 1u);
  ASSERT_EQ(both[1].punch_rows.size(), 1u);
  std::vector<double> turned = both[1].punch_rows.front().segments;
  std::ranges::reverse(turned);
  EXPECT_EQ(both[0].punch_rows.front().segments, turned);
  ASSERT_GT(turned.size(), 1u);
  EXPECT_NE(turned.front(), turned.back());
}

/// What is told of an L in closed form, towards both sides.
TEST(Describe, TellsAnL) {
  PlanOptions options;
  options.tensile_strength = 400.0;
  Room room(l_bracket(), plain_tools(), options);  // 40 wide, t 2
  const std::vector<StrokeChoice> ways = choices(room.cache(), room.lines({}));
  ASSERT_EQ(ways.size(), 2u);
  std::vector<FlangeId> to_gauge;
  for (const StrokeChoice& choice : ways) {
    const Stroke stroke = describe(room.cache(), room.lines({}), choice);
    EXPECT_EQ(stroke.bends, std::vector<BendId>{BendId(0)});
    EXPECT_FALSE(stroke.press_line || stroke.flattening || stroke.gauge);
    EXPECT_NEAR(stroke.angle.degrees(), 90.0, 1e-9);
    EXPECT_EQ(stroke.punch, "P");
    EXPECT_EQ(stroke.die, "D");
    EXPECT_NEAR(stroke.force, 40.0 * 1.42 * 400.0 * 4.0 / 12.0 / 1000.0, 1e-9);
    EXPECT_NEAR(stroke.gauge_direction.dot(room.inputs().directions[choice.direction]), 1.0, 1e-6);
    ASSERT_TRUE(stroke.to_gauge);
    to_gauge.push_back(*stroke.to_gauge);
    // 40 mm less a shortfall of 2 at each end: 40 in one segment, over the whole line.
    ASSERT_EQ(stroke.punch_rows.size(), 1u);
    EXPECT_EQ(stroke.punch_rows.front().segments, std::vector<double>{40.0});
    EXPECT_NEAR(stroke.punch_rows.front().from, 0.0, 1e-9);
    EXPECT_EQ(stroke.die_rows.front().segments, std::vector<double>{40.0});
  }
  EXPECT_NE(to_gauge[0], to_gauge[1]);
}

/// A hem is bent as far as the tools go and then closed: what is left of its angle, between flat
/// tools, four times the force over the V that the thickness wants, and neither gauge nor
/// clearance.
TEST(Describe, TellsTheClosingOfAHem) {
  const Sheet sheet = strip(
      {Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up}, Straight{60}}, 50, 1.0);
  const BrakeTools tools = hemming_tools();
  PlanOptions options;
  options.tensile_strength = 400.0;
  const auto flat = flat_sheet(sheet);
  const Angle bent = angle_before_closing(tools, options);
  auto work = workpiece_of(sheet, flat->layout, {1.0, bent});
  ASSERT_TRUE(work);
  const StrokeInputs inputs = stroke_inputs(std::move(*work), tools, options);
  StageCache cache(inputs);
  LineSet formed = no_lines(2);
  const std::vector<StrokeChoice> first = choices(cache, formed);
  ASSERT_FALSE(first.empty());
  const Stroke bending = describe(cache, formed, first.front());
  EXPECT_FALSE(bending.flattening);
  EXPECT_NEAR(bending.angle.degrees(), bent.degrees(), 1e-9);
  EXPECT_EQ(bending.punch, "P");
  insert(formed, 0);
  const std::vector<StrokeChoice> second = choices(cache, formed);
  ASSERT_FALSE(second.empty());
  for (const StrokeChoice& choice : second) {
    const Stroke closing_it = describe(cache, formed, choice);
    EXPECT_TRUE(closing_it.flattening);
    EXPECT_NEAR(closing_it.angle.degrees(), 180 - bent.degrees(), 1e-9);
    EXPECT_EQ(closing_it.punch, "F");
    EXPECT_EQ(closing_it.die, "F");
    EXPECT_FALSE(closing_it.gauge);
    EXPECT_EQ(closing_it.clearance, 0.0);
    // 6 T of V: 4 · 1.42 R T² / V over 50 mm.
    EXPECT_NEAR(closing_it.force, 50.0 * 4 * 1.42 * 400.0 / 6.0 / 1000.0, 1e-9);
    EXPECT_EQ(closing_it.bends, bending.bends);
  }
}

/// The force is that of all lines pressed, each as long as its pieces; places of rows are told from
/// the end of what is pressed.
TEST(Describe, TellsTheForceOfTheWholeLine) {
  PlanOptions options;
  options.tensile_strength = 400.0;
  const Opened part;  // 60 wide, t 2
  for (const double slot : {8.0, 20.0}) {
    Room room(slot_across_bend(slot, part), plain_tools(), options);
    const auto ways = choices(room.cache(), room.lines({}));
    ASSERT_EQ(ways.size(), 2u);
    const Stroke stroke = describe(room.cache(), room.lines({}), ways.front());
    EXPECT_NEAR(stroke.force, (60.0 - slot) * 1.42 * 400.0 * 4.0 / 12.0 / 1000.0, 1e-9);
    // One row over both pieces and the slot, in its middle: 60 less what may be short at the ends.
    ASSERT_EQ(stroke.punch_rows.size(), 1u);
    double length = 0.0;
    for (const double segment : stroke.punch_rows.front().segments)
      length += segment;
    EXPECT_NEAR(stroke.punch_rows.front().from, 0.5 * (60.0 - length), 1e-6);
  }
}

/// Where no segments stand the stroke is told without them, and without a clearance.
TEST(Describe, LeavesOutTheRowsOfAStrokeThatCannotBeMade) {
  // Longer than the line, beside whose ends walls stand.
  BrakeTools tools = plain_tools();
  tools.punches[0].segments = {200};
  Room room(box(), tools);
  const LineSet walls = room.lines({1, 3});
  const std::vector<StrokeChoice> left = choices(room.cache(), walls);
  ASSERT_FALSE(left.empty());
  EXPECT_FALSE(check(room.cache(), walls, left.front()).feasible);
  const Stroke stroke = describe(room.cache(), walls, left.front());
  EXPECT_TRUE(stroke.punch_rows.empty());
  EXPECT_TRUE(stroke.die_rows.empty());
  EXPECT_EQ(stroke.clearance, 0.0);
  // The scene shows the rows as the line would need them.
  const StrokeScene shown = scene(room.cache(), walls, left.front());
  ASSERT_EQ(shown.punch.size(), 1u);
  EXPECT_NEAR(shown.punch.front().length, 200.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
