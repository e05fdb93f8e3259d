#include "brake/hemming_tools.hpp"
#include "brake/stroke_room.hpp"

#include <planish/brake/order.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kPi = std::numbers::pi;
const double kSin45 = std::numbers::sqrt2 / 2.0;

Turn up_by_90(double radius = 2.0) { return {Angle::degrees(90), radius, BendDirection::up}; }

/// A sheet laid flat, with what checks its orders.
struct Checked {
  Checked(Sheet given, BrakeTools with, PlanOptions how = {})
      : sheet(std::move(given)), tools(std::move(with)), options(std::move(how)) {
    flat = *flat_sheet(sheet);
    checker.emplace(*OrderChecker::make(sheet, flat.layout, tools, options));
  }
  CheckedOrder check(const std::vector<OrderedStroke>& order) {
    auto checked = checker->check(order);
    EXPECT_TRUE(checked) << (checked ? "" : checked.error().message);
    return checked ? std::move(*checked) : CheckedOrder();
  }
  Plan plan() const { return *plan_bending(sheet, flat.layout, tools, options); }

  Sheet sheet;
  BrakeTools tools;
  PlanOptions options;
  FlatSheet flat;
  std::optional<OrderChecker> checker;
};

std::vector<OrderedStroke> one_by_one(const std::vector<int>& bends) {
  std::vector<OrderedStroke> order;
  for (const int bend : bends)
    order.push_back({{BendId(bend)}});
  return order;
}

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
    problem.choices = [&](const LineSet& formed) { return room.model().choices(formed); };
    problem.check = [&](const LineSet& formed, const StrokeChoice& choice) {
      return room.model().check(formed, choice);
    };
    for (const int bend : bends)
      problem.begin_with.push_back(room.line_of(bend + 1));
    const auto search = search_strokes(problem);
    ASSERT_TRUE(search);
    const CheckedOrder checked = part.check(one_by_one(bends));
    EXPECT_EQ(checked.feasible(), search->status == PlanStatus::optimal);
    if (checked.feasible()) {
      EXPECT_DOUBLE_EQ(checked.cost, search->cost);
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
  EXPECT_EQ(blocked.hits, "punch P");
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
  EXPECT_EQ(lipped.hits, "punch P");
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

/// A place of the pattern's inside skin in the machine, at a moment, if it hangs on the held body.
Vec3 in_machine(const StrokeScene& scene, const StrokeMoment& moment, const Vec2& p) {
  const Vec2 d = p - scene.origin;
  const double side = scene.pattern_up ? 1.0 : -1.0;
  const double x = d.dot(scene.along);
  const double y = side * (scene.along.x() * d.y() - scene.along.y() * d.x());
  const double up = moment.slope.radians();
  return {x, std::cos(up) * y + moment.by.x(), std::sin(up) * y + moment.by.y()};
}

/// L of 50 and 30, r 3, t 2, K 0.44: with the gauge at either flange and either side up.
TEST(StrokeScene, HasTheSheetInTheMachine) {
  BrakeTools tools = plain_tools();
  tools.machine.gauge = BackGauge{10, 500, 10, {{0, 5}, {0, -5}, {20, -5}, {20, 5}}};
  for (Sheet sheet : {l_bracket(), l_bracket_down()}) {
    Checked part(std::move(sheet), tools);
    const CheckedOrder checked = part.check(one_by_one({0}));
    ASSERT_TRUE(checked.feasible());
    const Stroke& stroke = checked.strokes[0].stroke;
    const StrokeScene& scene = checked.strokes[0].scene;
    ASSERT_TRUE(stroke.gauge);
    // What touches the gauge is where the gauge is, parallel to the machine, and faces up.
    const StrokeMoment &first = scene.moments.front(), &last = scene.moments.back();
    const Vec3 a = in_machine(scene, first, stroke.gauge->edge.a),
               b = in_machine(scene, first, stroke.gauge->edge.b);
    EXPECT_NEAR(a.y(), stroke.gauge->distance, 1e-9);
    EXPECT_NEAR(b.y(), stroke.gauge->distance, 1e-9);
    EXPECT_NEAR(a.z(), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(a.x() - b.x()), 40.0, 1e-9);
    EXPECT_NEAR(first.die, -2.0, 1e-9);
    // Bent: the edge is a flange's length up a slope of 45° from the end of the inside radius.
    const double allowance = kPi / 2 * (3.0 + 0.44 * 2.0);
    const double flange = stroke.gauge->distance - 0.5 * allowance;
    const Vec3 bent = in_machine(scene, last, stroke.gauge->edge.a);
    EXPECT_NEAR(last.turn.degrees(), 90.0, 1e-9);
    EXPECT_NEAR(bent.y(), (3.0 + flange) * kSin45, 1e-9);
    EXPECT_NEAR(bent.z(), 3.0 * (1.0 - kSin45) + flange * kSin45, 1e-9);
    EXPECT_NEAR(bent.x(), a.x(), 1e-9);
    // The shoulders, of radius 1.5, touch the outside from below.
    const double round = 1.5, opening = 6.0;
    const double center = opening + round * std::tan(kPi / 180 * 25);  // of a corner of 130°
    const double below = -2.0 / kSin45 + 3.0 * (1.0 - 1.0 / kSin45);   // where the outsides meet
    const double height = below + center - round / kSin45;             // of the circle's middle
    EXPECT_NEAR(last.die, height + round, 1e-9);
    // Both rows press the line but for a shortfall of a thickness at each end.
    const double from = std::min(a.x(), b.x()), to = std::max(a.x(), b.x());
    for (const auto& row : {scene.punch, scene.die}) {
      ASSERT_FALSE(row.empty());
      EXPECT_LE(row.front().from, from + 2.0);
      EXPECT_GE(row.back().from + row.back().length, to - 2.0);
      for (std::size_t i = 1; i < row.size(); ++i)
        EXPECT_NEAR(row[i].from, row[i - 1].from + row[i - 1].length, 1e-9);
    }
    EXPECT_NEAR(scene.punch.front().from - from, stroke.punch_rows.front().from, 1e-9);
  }
}

/// The return of a hem under the flat punch, from 150° on: 40 | 180° r 0.5 | 15, t 1, K 0.44.
TEST(StrokeScene, HasTheReturnOfAHemUnderThePunch) {
  Checked part(hem(), hemming_tools());
  const CheckedOrder checked = part.check({{{BendId(0)}}, {{BendId(0)}, std::nullopt, true}});
  ASSERT_TRUE(checked.feasible());
  const StrokeScene& scene = checked.strokes[1].scene;
  const double angle = 150.0 * kPi / 180, allowance = kPi * (0.5 + 0.44);
  const double r = allowance / angle - 0.44;
  const StrokeMoment &first = scene.moments.front(), &last = scene.moments.back();
  EXPECT_NEAR(first.punch, r * (1 - std::cos(angle)) + 15 * std::sin(angle) - std::cos(angle),
              1e-9);
  EXPECT_NEAR(last.punch, 2 * 0.5 + 1.0, 1e-9);
  EXPECT_NEAR(last.turn.degrees(), 30.0, 1e-9);
  EXPECT_EQ(last.die, -1.0);
  EXPECT_EQ(last.slope.radians(), 0.0);
  // The middle of the return is half its length back from the tangent line, whichever side that is.
  EXPECT_NEAR(std::abs(scene.across), 0.5 * allowance + 7.5, 1e-9);
}

TEST(CheckOrder, KnowsThatAHemIsBentBeforeItIsClosed) {
  Checked part(hem(), hemming_tools());
  const CheckedOrder checked = part.check({{{BendId(0)}, std::nullopt, true}, {{BendId(0)}}});
  ASSERT_EQ(checked.strokes.size(), 2u);
  ASSERT_TRUE(checked.strokes[0].blocked);
  EXPECT_EQ(checked.strokes[0].blocked->why, "a hem is bent before it is closed");
  EXPECT_FALSE(checked.strokes[1].blocked);
}

}  // namespace
}  // namespace planish::test
