#include "brake/checked_order.hpp"
#include "brake/hemming_tools.hpp"
#include "brake/right_angles.hpp"

#include <planish/brake/order.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;

Turn up_by_90(double radius = 2.0) { return {Angle::degrees(90), radius, BendDirection::up}; }

BrakeTools narrow_tools() {
  return plain_tools({Angle::degrees(80), 4.0},
                     {10.0, Angle::degrees(80), 1.0, 9.0, 100.0, {300, 50, 20, 10}});
}

TEST(CheckOrder, OfAPlanCostsWhatThePlanCosts) {
  BrakeTools two = narrow_tools();
  two.punches.push_back(punch({Angle::degrees(60), 6.0, 150.0, 0.4}));
  two.punches.back().id = "P2";
  for (const BrakeTools& tools : {narrow_tools(), two})
    for (Sheet sheet : {l_bracket(), u_channel(), z_profile(), box(), staircase(3)}) {
      Checked part(std::move(sheet), tools);
      const Plan plan = part.plan();
      ASSERT_EQ(plan.status, PlanStatus::optimal);
      std::vector<OrderedStroke> order;
      for (const Stroke& stroke : plan.strokes)
        order.push_back(ordered(stroke));
      const CheckedOrder checked = part.check(order);
      EXPECT_TRUE(checked.feasible());
      EXPECT_DOUBLE_EQ(checked.cost, plan.cost);
      EXPECT_EQ(checked.turn_overs, plan.turn_overs);
      EXPECT_EQ(checked.rotations, plan.rotations);
      ASSERT_EQ(checked.strokes.size(), plan.strokes.size());
      for (std::size_t i = 0; i < plan.strokes.size(); ++i)
        EXPECT_EQ(checked.strokes[i].stroke.bends, plan.strokes[i].bends);
    }
}

/// Every order of a part's bends against a search that may only begin with it.
void compare_all_orders(Sheet sheet, const BrakeTools& tools) {
  Checked part(std::move(sheet), tools);
  Room room(part.sheet, tools);
  std::vector<int> bends;
  for (const BendId bend : part.sheet.bends.ids())
    bends.push_back(index_of(bend));
  int possible = 0, blocked = 0;
  do {
    StrokeProblem problem;
    problem.lines = static_cast<int>(bends.size());
    problem.choices = [&](const LineSet& formed) { return choices(room.cache(), formed); };
    problem.check = [&](const LineSet& formed, const StrokeChoice& choice) {
      return check(room.cache(), formed, choice);
    };
    for (const int bend : bends)
      problem.begin_with.push_back(room.line_of(bend + 1));
    const auto search = search_strokes(problem);
    ASSERT_TRUE(search);
    const CheckedOrder checked = part.check(one_by_one(bends));
    EXPECT_EQ(checked.feasible(), search->status == PlanStatus::optimal);
    if (checked.feasible()) {
      // What the search does not count: set-ups more, for want of segments.
      const int more = checked.tool_changes - search->tool_changes;
      EXPECT_GE(more, 0);
      EXPECT_DOUBLE_EQ(checked.cost, search->cost + more * StrokeWeights().tool_change);
    }
    (checked.feasible() ? possible : blocked) += 1;
    // Each stroke by itself, with all before it formed.
    std::vector<int> formed;
    for (std::size_t i = 0; i < bends.size(); ++i) {
      EXPECT_EQ(checked.strokes[i].blocked.has_value(), !room.can_press(bends[i] + 1, formed));
      formed.push_back(bends[i] + 1);
    }
  } while (std::ranges::next_permutation(bends).found);
  EXPECT_GT(possible, 0);
  EXPECT_GT(blocked, 0);
}

TEST(CheckOrder, BlocksWhatNoSearchFindsInAU) {
  const double longest = 60.0 + 2.0 - (10.0 - 0.05) / kSin45;  // closed_forms_test.cpp
  compare_all_orders(
      strip({Straight{longest + 5}, up_by_90(), Straight{60}, up_by_90(), Straight{30}}, 80, 1.5),
      plain_tools());
}

/// Once both inner bends are formed, what hangs behind an outer one is in the way of the die.
TEST(CheckOrder, BlocksWhatNoSearchFindsInAHat) {
  const Turn down{Angle::degrees(90), 1.0, BendDirection::down};
  const Turn up{Angle::degrees(90), 1.0, BendDirection::up};
  compare_all_orders(strip({Straight{20}, up, Straight{30}, down, Straight{40}, down, Straight{30},
                            up, Straight{20}},
                           40, 1.0),
                     narrow_tools());
}

/// The long bends need a row of 100, which has no room between both short walls.
TEST(CheckOrder, BlocksWhatNoSearchFindsInABox) {
  BrakeTools tools = narrow_tools();
  tools.punches[0].segments = {60, 40, 5};
  compare_all_orders(box(), tools);
}

/// The first leg a little too long to be bent first: told what it hits; what follows is told too.
TEST(CheckOrder, SaysWhatHitsAndGoesOn) {
  const double longest = 60.0 + 2.0 - (10.0 - 0.05) / kSin45, beyond = 5.0;
  Checked part(
      strip({Straight{longest + beyond}, up_by_90(), Straight{60}, up_by_90(), Straight{30}}, 80,
            1.5),
      plain_tools());
  const CheckedOrder checked = part.check(one_by_one({0, 1}));
  ASSERT_EQ(checked.strokes.size(), 2u);
  EXPECT_FALSE(checked.strokes[0].blocked);
  ASSERT_TRUE(checked.strokes[1].blocked);
  const BlockedBend& blocked = *checked.strokes[1].blocked;
  EXPECT_EQ(blocked.bend, BendId(1));
  EXPECT_EQ(blocked.hits, (ToolName{ToolKind::punch, "P"}));
  EXPECT_EQ(blocked.with, FlangeId(0));
  EXPECT_NEAR(blocked.depth, 0.05 + beyond * kSin45, 0.01);
  ASSERT_TRUE(blocked.at_turn);
  EXPECT_NEAR(blocked.at_turn->degrees(), 90.0, 0.5);
  EXPECT_FALSE(checked.strokes[1].scene.punch.empty());
}

/// A lip at the end of such a leg points into the punch: it is much deeper than the leg, which is
/// named where there is no lip.
TEST(CheckOrder, NamesTheDeepestOfAllThatHit) {
  const double leg = 60.0 + 2.0 - (10.0 - 0.05) / kSin45 + 1.0, depth_of_leg = 0.05 + kSin45;
  const auto blocked = [](const std::vector<StripPart>& parts, const std::vector<int>& order) {
    Checked part(strip(parts, 80, 1.5), plain_tools());
    const CheckedOrder checked = part.check(one_by_one(order));
    EXPECT_TRUE(checked.strokes.back().blocked);
    return checked.strokes.back().blocked.value_or(BlockedBend());
  };
  const BlockedBend plain = blocked(
      {Straight{leg}, up_by_90(), Straight{60}, up_by_90(), Straight{30}}, {0, 1});
  EXPECT_EQ(plain.with, FlangeId(0));
  EXPECT_NEAR(plain.depth, depth_of_leg, 0.01);
  const BlockedBend lipped = blocked(
      {Straight{12}, up_by_90(), Straight{leg}, up_by_90(), Straight{60}, up_by_90(), Straight{30}},
      {0, 1, 2});
  EXPECT_EQ(lipped.hits, (ToolName{ToolKind::punch, "P"}));
  EXPECT_EQ(lipped.with, FlangeId(0));
  EXPECT_GT(lipped.depth, depth_of_leg + 3.0);
}

TEST(CheckOrder, LetsWhatIsLeftOutFollow) {
  Checked part(box(), narrow_tools());
  const CheckedOrder checked = part.check(one_by_one({2}));
  ASSERT_EQ(checked.strokes.size(), 4u);
  EXPECT_TRUE(checked.feasible());
  EXPECT_EQ(checked.strokes[0].stroke.bends, std::vector{BendId(2)});
  std::vector<BendId> bends;
  for (const CheckedStroke& stroke : checked.strokes)
    bends.insert(bends.end(), stroke.stroke.bends.begin(), stroke.stroke.bends.end());
  std::ranges::sort(bends);
  EXPECT_EQ(bends, (std::vector{BendId(0), BendId(1), BendId(2), BendId(3)}));
}

TEST(CheckOrder, PressesWhatLiesOnNoLineOneAfterTheOther) {
  Checked part(u_channel(), narrow_tools());
  const CheckedOrder checked = part.check({{{BendId(1), BendId(0)}}});
  ASSERT_EQ(checked.strokes.size(), 2u);
  EXPECT_TRUE(checked.feasible());
}

TEST(CheckOrder, RefusesStrokesThatAreNone) {
  Checked part(u_channel(), narrow_tools());
  const auto code = [&](const std::vector<OrderedStroke>& order) {
    const auto checked = part.checker->check(order);
    return checked ? std::string() : std::string(code_name(checked.error().code));
  };
  EXPECT_EQ(code(one_by_one({0, 1})), "");
  EXPECT_EQ(code(one_by_one({0, 0})), "bad_option");
  EXPECT_EQ(code({{{BendId(0)}, 1}}), "bad_option");                   // no press lines
  EXPECT_EQ(code({{{BendId(0)}, std::nullopt, true}}), "bad_option");  // no hem
  EXPECT_EQ(code({{{}}}), "bad_option");
}

TEST(CheckOrder, SaysWhichStrokePressesABendAgain) {
  Checked part(u_channel(), narrow_tools());
  const auto checked = part.checker->check(one_by_one({1, 1}));
  ASSERT_FALSE(checked);
  const Error& error = checked.error();
  EXPECT_EQ(error.places, (std::vector<Place>{place::stroke(2), place::bend("B2")}));
  EXPECT_EQ(error.where, "order");
  EXPECT_TRUE(error.message.starts_with("Stroke 2 presses bend B2 again.")) << error.message;
  EXPECT_EQ(error.remedies.size(), 1u);
}

TEST(CheckOrder, EndsWhenItIsStopped) {
  Checked part(u_channel(), narrow_tools());
  Progress stopped;
  stopped.cancelled = [] { return true; };
  const auto checked = part.checker->check(one_by_one({0, 1}), stopped);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, code::cancelled);
}

TEST(CheckOrder, KnowsThatAHemIsBentBeforeItIsClosed) {
  Checked part(hem(), hemming_tools());
  const CheckedOrder checked = part.check({{{BendId(0)}, std::nullopt, true}, {{BendId(0)}}});
  ASSERT_EQ(checked.strokes.size(), 2u);
  ASSERT_TRUE(checked.strokes[0].blocked);
  EXPECT_FALSE(checked.strokes[0].blocked->hits);
  ASSERT_TRUE(checked.strokes[0].blocked->why);
  EXPECT_EQ(checked.strokes[0].blocked->why->code, "hem_not_bent");
  EXPECT_FALSE(checked.strokes[1].blocked);
}

/// Why a stroke is blocked where nothing is hit: a code.
std::string_view reason(const CheckedStroke& stroke) {
  return stroke.blocked && stroke.blocked->why ? stroke.blocked->why->code : std::string_view();
}

/// Segments of the flat punch add up to 10 of 20 mm: they keep a bent hem from being closed.
TEST(CheckOrder, KeepsTheReasonWhyABentHemCannotBeClosed) {
  BrakeTools tools = hemming_tools();
  tools.punches.back().segments = {10.0};
  Checked part(hem(), tools);
  const OrderedStroke bent{{BendId(0)}}, closed{{BendId(0)}, std::nullopt, true};
  const CheckedOrder last = part.check({bent, closed}), first = part.check({closed, bent});
  ASSERT_EQ(last.strokes.size(), 2u);
  EXPECT_FALSE(last.strokes[0].blocked);
  EXPECT_EQ(reason(last.strokes[1]), "no_segments");
  ASSERT_EQ(first.strokes.size(), 2u);
  EXPECT_EQ(reason(first.strokes[0]), "hem_not_bent");
}

/// Before anything is formed, too.
TEST(CheckOrder, KeepsTheReasonWhyABendCannotBePressed) {
  BrakeTools tools = narrow_tools();
  tools.punches.front().segments = {1000.0};
  tools.machine.length = 900.0;
  Checked part(u_channel(), tools);
  const CheckedOrder checked = part.check(one_by_one({0, 1}));
  ASSERT_EQ(checked.strokes.size(), 2u);
  for (const CheckedStroke& stroke : checked.strokes)
    EXPECT_EQ(reason(stroke), "no_segments");
}

}  // namespace
}  // namespace planish::test
