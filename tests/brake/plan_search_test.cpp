#include "plan_search.hpp"

#include "brake/checked_order.hpp"
#include "brake/hemming_tools.hpp"
#include "brake/stroke_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Weights of which each sum names what it is made of.
const StrokeWeights kTellingWeights{
    .turn_over = 3.25, .rotate = 2.0625, .tool_change = 5.5, .stroke = 1.0, .ungauged = 0.015625};

struct Totals {
  int turn_overs = 0, rotations = 0, tool_changes = 0, ungauged = 0;
  double cost = 0.0;
};

/// What a sequence of strokes costs, counted from what the operator is told.
Totals totals_of(const std::vector<Stroke>& strokes, const std::vector<Station>& stations,
                 bool has_gauge, const StrokeWeights& w) {
  Totals totals;
  for (size_t i = 0; i < strokes.size(); ++i) {
    const Stroke& now = strokes[i];
    totals.ungauged += !now.flattening && !(has_gauge && now.gauge);
    if (i == 0) continue;
    const Stroke& before = strokes[i - 1];
    totals.turn_overs += now.reference_up != before.reference_up;
    totals.rotations += (now.gauge_direction - before.gauge_direction).norm() > 1e-6;
  }
  for (const Station& station : stations)
    totals.tool_changes = std::max(totals.tool_changes, station.set_up);
  totals.cost = w.stroke * static_cast<double>(strokes.size()) + w.turn_over * totals.turn_overs +
                w.rotate * totals.rotations + w.tool_change * totals.tool_changes +
                w.ungauged * totals.ungauged;
  return totals;
}

template <typename Told>
void expect_totals(const Told& told, const std::vector<Stroke>& strokes, bool has_gauge,
                   const StrokeWeights& weights) {
  const Totals totals = totals_of(strokes, told.stations, has_gauge, weights);
  EXPECT_EQ(told.turn_overs, totals.turn_overs);
  EXPECT_EQ(told.rotations, totals.rotations);
  EXPECT_EQ(told.tool_changes, totals.tool_changes);
  EXPECT_EQ(told.ungauged, totals.ungauged);
  EXPECT_NEAR(told.cost, totals.cost, 1e-9);
}

/// A plan, and its order checked, cost what their strokes cost: with and without a gauge, with a
/// hem, which takes other tools.
TEST(PlanSearch, CostsWhatItsStrokesCost) {
  const BrakeTools plain = plain_tools(
      {Angle::degrees(80), 4.0}, {10.0, Angle::degrees(80), 1.0, 9.0, 100.0, {300, 50, 20, 10}});
  BrakeTools gauged = plain, hemming = hemming_tools();
  const BackGauge gauge{10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}};
  gauged.machine.gauge = hemming.machine.gauge = gauge;
  const Turn up{Angle::degrees(90), 1.0, BendDirection::up};
  const Sheet hemmed = strip({Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up},
                              Straight{60}, up, Straight{40}},
                             50, 1.0);
  int changes = 0, without = 0, number = 0;
  for (const auto& [sheet, tools] : {std::pair{u_channel(), plain},
                                     {z_profile(), gauged},
                                     {box(), gauged},
                                     {box(), plain},
                                     {staircase(2), gauged},
                                     {hemmed, hemming}}) {
    SCOPED_TRACE(number++);
    PlanOptions options;
    options.weights = kTellingWeights;
    Checked part(sheet, tools, options);
    const Plan plan = part.plan();
    ASSERT_EQ(plan.status, PlanStatus::optimal);
    expect_totals(plan, plan.strokes, tools.machine.gauge.has_value(), kTellingWeights);
    std::vector<OrderedStroke> order;
    std::vector<Stroke> told;
    for (const Stroke& stroke : plan.strokes)
      order.push_back(ordered(stroke));
    const CheckedOrder checked = part.check(order);
    for (const CheckedStroke& stroke : checked.strokes)
      told.push_back(stroke.stroke);
    expect_totals(checked, told, tools.machine.gauge.has_value(), kTellingWeights);
    EXPECT_NEAR(checked.cost, plan.cost, 1e-9) << "the cheapest ways of the cheapest order";
    changes += plan.tool_changes;
    without += plan.ungauged;
  }
  EXPECT_GT(changes, 0);
  EXPECT_GT(without, 0);
}

/// More bends than are searched whole at once: the plan forms all, and costs what it says, at least
/// the bound.
TEST(PlanSearch, PlansManyBendsFromTheOutsideIn) {
  for (const bool first : {true, false}) {
    PlanOptions options;
    options.weights = kTellingWeights;
    options.limits.first = first;
    options.limits.stages = 3000;
    const BrakeTools tools = plain_tools({Angle::degrees(80), 4.0},
                                         {8.0, Angle::degrees(80), 1.0, 6.0});
    Room room(staircase(8), tools, options);
    ASSERT_EQ(room.work().lines.size(), 16u);
    const auto found = search_plan(room.cache(), {});
    ASSERT_TRUE(found);
    ASSERT_TRUE(found->status == PlanStatus::optimal || found->status == PlanStatus::feasible);
    LineSet formed = room.lines({});
    double cost = 0.0;
    for (size_t i = 0; i < found->strokes.size(); ++i) {
      const StrokeChoice& choice = found->strokes[i];
      EXPECT_TRUE(disjoint(formed, choice.lines)) << "no line twice";
      EXPECT_TRUE(check(room.cache(), formed, choice).feasible);
      cost += stroke_cost(choice, kTellingWeights);
      if (i > 0)
        cost += change_cost(set_up_of(found->strokes[i - 1]), set_up_of(choice), kTellingWeights);
      formed = joined(formed, choice.lines);
    }
    EXPECT_EQ(count(formed), 16);
    EXPECT_NEAR(found->cost, cost, 1e-9);
    if (!first) {
      EXPECT_LE(found->bound, found->cost + 1e-9);
      EXPECT_GE(found->bound, 16.0) << "each line takes a stroke";
    }
    EXPECT_GT(found->stages, 0);
  }
}

TEST(PlanSearch, StopsWhenAsked) {
  Room room(staircase(8), plain_tools());
  Progress stop;
  stop.cancelled = [] { return true; };
  const auto found = search_plan(room.cache(), stop);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, code::cancelled);
}

}  // namespace
}  // namespace planish::test
