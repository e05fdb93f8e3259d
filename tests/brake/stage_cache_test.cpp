#include "stage_cache.hpp"

#include "blocked_way.hpp"
#include "brake/hemming_tools.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace planish::test {
namespace {

using namespace brake_detail;

BrakeTools tools_with_gauge(BrakeTools tools) {
  tools.machine.upper_beam = {{-30, 150}, {30, 150}, {30, 400}, {-30, 400}};
  tools.machine.gauge = BackGauge{5, 300, 10, {{0, 0}, {0, -20}, {60, -20}, {60, 0}}};
  return tools;
}

void tell(std::ostream& out, const std::vector<SegmentRow>& rows) {
  for (const SegmentRow& row : rows) {
    out << " | " << row.from << ":";
    for (const double length : row.segments)
      out << " " << length;
  }
}

void tell(std::ostream& out, const LineSet& set) {
  for (const int line : members(set))
    out << " " << line;
}

/// All that a cache answers about a stage, in words.
std::string answers(StageCache& cache, const LineSet& formed) {
  std::ostringstream out;
  out.precision(17);
  for (const StrokeChoice& choice : choices(cache, formed)) {
    out << "press";
    tell(out, choice.lines);
    out << " by " << choice.punch << choice.die << choice.direction << choice.reference_up
        << (choice.gauged ? " gauged" : "");
    const StrokeVerdict verdict = check(cache, formed, choice);
    if (!verdict.feasible && verdict.because) {
      out << " not because of";
      tell(out, *verdict.because);
    }
    const Stroke stroke = describe(cache, formed, choice);
    out << " clear by " << stroke.clearance << " at "
        << (stroke.gauge ? stroke.gauge->distance : -1.0);
    tell(out, stroke.punch_rows);
    tell(out, stroke.die_rows);
    const StrokeScene shown = scene(cache, formed, choice);
    out << " " << shown.across << " " << shown.moments.back().die << " " << shown.punch.front().from
        << "\n";
  }
  for (int line = 0; line < cache.inputs().lines(); ++line) {
    const auto& closes = cache.inputs().work.lines[line].closes;
    if (holds(formed, line) || (closes && !holds(formed, *closes))) continue;
    const BlockedBend nearest = blocked(cache, formed, line);
    out << (nearest.hits ? text_of(*nearest.hits) : "")
        << (nearest.why ? nearest.why->told.sentence : "") << nearest.depth << "\n";
  }
  return out.str();
}

/// The invariant: what was asked before changes no answer, nor does what was forgotten.
void expect_same_answers(const StrokeInputs& inputs) {
  std::vector<LineSet> stages;
  for (std::uint64_t stage = 0; stage < std::uint64_t{1} << inputs.lines(); ++stage) {
    const auto& lines = inputs.work.lines;
    const bool can_be = std::ranges::all_of(members({stage}), [&](int line) {
      return !lines[line].closes || (stage >> *lines[line].closes & 1) != 0;
    });
    if (can_be) stages.push_back({stage});
  }
  std::vector<std::string> fresh;
  for (const LineSet& stage : stages) {
    StageCache cache(inputs);
    fresh.push_back(answers(cache, stage));
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < 2 * stages.size(); ++i)
    order.push_back(i % stages.size());
  std::mt19937 random(5);
  for (const bool shuffled : {false, true}) {
    StageCache kept(inputs), forgetful(inputs, nullptr, 1);
    if (shuffled)
      std::ranges::shuffle(order, random);
    else
      std::ranges::sort(order, std::greater());
    for (const std::size_t i : order) {
      EXPECT_EQ(answers(kept, stages[i]), fresh[i]) << i;
      EXPECT_EQ(answers(forgetful, stages[i]), fresh[i]) << i;
    }
  }
}

TEST(StageCache, AnswersAsIfNothingHadBeenAskedBefore) {
  BrakeTools tools = tools_with_gauge(plain_tools());
  tools.punches.push_back(punch({Angle::degrees(60), 14.0}));
  PlanOptions options;
  options.clearance = 1.0;
  Room narrow(box({70.0, 45.0, 30.0}), tools), wide(z_profile(), tools, options);
  expect_same_answers(narrow.inputs());
  expect_same_answers(wide.inputs());
  // Lines are pressed together whether or not others are formed on the way from one to the other.
  Room tabs(tabs_with_lips(20.0, 12.0), tools);
  expect_same_answers(tabs.inputs());
}

TEST(StageCache, KnowsClosedHems) {
  const BrakeTools tools = tools_with_gauge(hemming_tools());
  const Sheet sheet = strip(
      {Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up}, Straight{22},
       Turn{Angle::degrees(90), 1.0, BendDirection::up}, Straight{40}},
      50, 1.0);
  const auto flat = flat_sheet(sheet);
  auto work = workpiece_of(sheet, flat->layout, {1.0, angle_before_closing(tools, {})});
  ASSERT_TRUE(work);
  expect_same_answers(stroke_inputs(std::move(*work), tools, {}));
}

/// A tree is that of the line a hem was bent at, and what lies on each side of a line is told.
TEST(StageCache, TellsWhatLiesOnBothSidesOfALine) {
  Room room(staircase(2), plain_tools());
  for (int line = 0; line < room.inputs().lines(); ++line) {
    const auto& beyond = room.cache().beyond(line);
    EXPECT_TRUE(disjoint(beyond[0], beyond[1]));
    EXPECT_EQ(count(joined(beyond[0], beyond[1])), room.inputs().lines() - 1);
    for (const int side : {0, 1}) {
      const auto reached = reached_from(room.work(), room.work().lines[line].bodies[side], line);
      for (const int other : members(beyond[side]))
        EXPECT_TRUE(reached[room.work().lines[other].bodies[0]]) << line << " " << other;
    }
  }
}

}  // namespace
}  // namespace planish::test
