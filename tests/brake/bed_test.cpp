#include "bed.hpp"

#include "brake/hemming_tools.hpp"
#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace planish::test {
namespace {

using namespace brake_detail;

double end_of(const std::vector<SegmentRow>& rows) {
  const SegmentRow& last = rows.back();
  return last.from + std::accumulate(last.segments.begin(), last.segments.end(), 0.0);
}

std::vector<double> segments_of(const std::vector<SegmentRow>& rows) {
  std::vector<double> all;
  for (const SegmentRow& row : rows)
    all.insert(all.end(), row.segments.begin(), row.segments.end());
  return all;
}

Plan planned(const Sheet& sheet, const BrakeTools& tools, const PlanOptions& options = {}) {
  const auto flat = flat_sheet(sheet);
  EXPECT_TRUE(flat);
  auto plan = plan_bending(sheet, flat->layout, tools, options);
  EXPECT_TRUE(plan) << plan.error().message;
  return *plan;
}

BrakeTools slim_tools() { return plain_tools({Angle::degrees(80), 4.0}, {.half_width = 9.0}); }

/// A U of two equal bends, 100 long: both are pressed at one station.
TEST(Bed, OneStationPressesWhatItsSegmentsPress) {
  const Plan plan = planned(u_channel(), slim_tools());
  ASSERT_EQ(plan.strokes.size(), 2u);
  ASSERT_EQ(plan.stations.size(), 1u);
  EXPECT_EQ(plan.stations[0].strokes, (std::vector<int>{0, 1}));
  EXPECT_EQ(plan.tool_changes, 0);
  for (const Stroke& stroke : plan.strokes)
    EXPECT_EQ(stroke.punch_rows.front().segments, plan.stations[0].punch_rows.front().segments);
}

/// What a stroke is told is what stands on the bed, turned as the operator sees it; every stroke
/// has one station, and no segment stands twice.
TEST(Bed, StandsWhatTheStrokesTell) {
  int stations = 0;
  for (const Sheet& sheet :
       {box({70.0, 45.0, 30.0}), box({60.0, 60.0, 55.0}), staircase(3), z_profile()}) {
    const BrakeTools tools = slim_tools();
    const Plan plan = planned(sheet, tools);
    ASSERT_EQ(plan.status, PlanStatus::optimal);
    std::vector<int> served;
    std::map<int, std::vector<double>> used;
    for (const Station& station : plan.stations) {
      ++stations;
      EXPECT_GE(station.punch_rows.front().from, 0.0);
      EXPECT_LE(end_of(station.punch_rows), tools.machine.length);
      served.insert(served.end(), station.strokes.begin(), station.strokes.end());
      for (const double segment : segments_of(station.punch_rows))
        used[station.set_up].push_back(segment);
      for (const int s : station.strokes) {
        const Stroke& stroke = plan.strokes[s];
        EXPECT_EQ(stroke.punch, station.punch);
        EXPECT_EQ(segments_of(stroke.punch_rows), segments_of(station.punch_rows));
        EXPECT_EQ(segments_of(stroke.die_rows), segments_of(station.die_rows));
        // Punch and die stand to each other as on the bed.
        EXPECT_NEAR(stroke.die_rows.front().from - stroke.punch_rows.front().from,
                    station.die_rows.front().from - station.punch_rows.front().from, 1e-6);
      }
    }
    std::ranges::sort(served);
    std::vector<int> all(plan.strokes.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(served, all);
    for (auto& [set_up, segments] : used) {
      std::vector<double> owned = tools.punches[0].segments;
      for (const double segment : segments) {
        const auto found = std::ranges::find(owned, segment);
        ASSERT_NE(found, owned.end()) << segment << " stands twice";
        owned.erase(found);
      }
    }
  }
  EXPECT_GT(stations, 4);
}

/// A box of 70 × 45 whose long sides are bent first: the short ones then stand between walls, and
/// take a row of 45 at most. With other segments than those of the long row both stand together; if
/// one has to be laid twice, that is another set-up.
TEST(Bed, SegmentsStandOnce) {
  const Sheet sheet = box({70.0, 45.0, 30.0});
  PlanOptions options;
  options.begin_with = {BendId(0), BendId(2)};
  const std::vector<double> both{50, 15, 40}, shared{40, 20, 5};
  const Plan together = planned(sheet, plain_tools({.segments = both}, {.segments = both}),
                                options);
  EXPECT_EQ(together.tool_changes, 0);
  ASSERT_EQ(together.stations.size(), 2u);
  const Plan apart = planned(sheet, plain_tools({.segments = shared}, {.segments = shared}),
                             options);
  ASSERT_EQ(apart.stations.size(), 2u);
  EXPECT_EQ(apart.tool_changes, 1);
  EXPECT_EQ(apart.stations.back().set_up, 1);
  EXPECT_EQ(apart.status, PlanStatus::feasible) << "another order may need one set-up";
  EXPECT_NEAR(apart.cost, together.cost + options.weights.tool_change, 1e-9);
}

/// The shortest bed on which a box of 70 × 45 takes one set-up, to a millimetre.
double shortest_bed(const PlanOptions& options) {
  BrakeTools tools = plain_tools();
  double little = 100.0, enough = 500.0;
  while (enough - little > 1.0) {
    tools.machine.length = std::round(0.5 * (little + enough));
    const Plan plan = planned(box({70.0, 45.0, 30.0}), tools, options);
    (plan.tool_changes == 0 ? enough : little) = tools.machine.length;
  }
  return enough;
}

double taken(const Plan& plan) {
  return end_of(plan.stations.back().punch_rows) - plan.stations.front().punch_rows[0].from;
}

/// Two stations of a box stand so far apart that the box does not reach from one to the other; a
/// bed that is too short for both takes two set-ups, and on a long one they stand farther apart.
TEST(Bed, StationsKeepTheWorkpieceClear) {
  PlanOptions options;
  options.begin_with = {BendId(0), BendId(2)};
  BrakeTools tools = plain_tools();
  tools.machine.length = shortest_bed(options);
  const Plan tight = planned(box({70.0, 45.0, 30.0}), tools, options);
  ASSERT_EQ(tight.stations.size(), 2u);
  // Rows of 65 and 40; the flat box is 70 + 2 · 30 long and more, its walls count twice.
  EXPECT_GT(taken(tight), 65.0 + 40.0);
  EXPECT_NEAR(taken(tight), tools.machine.length, 2.0);
  tools.machine.length = 3000.0;
  const Plan wide = planned(box({70.0, 45.0, 30.0}), tools, options);
  EXPECT_NEAR(taken(wide), taken(tight) + 100.0, 2.0);
}

/// Tools of other heights or openings would meet while these press; flat ones for a hem too.
TEST(Bed, OtherVsAndHemsTakeASetUpOfTheirOwn) {
  const Turn up{Angle::degrees(90), 1.0, BendDirection::up};
  const Sheet hemmed = strip({Straight{15}, Turn{Angle::degrees(180), 0.5, BendDirection::up},
                              Straight{60}, up, Straight{40}},
                             50, 1.0);
  const Plan plan = planned(hemmed, hemming_tools());
  ASSERT_EQ(plan.status, PlanStatus::optimal);
  EXPECT_EQ(plan.tool_changes, 1);
  for (const Station& station : plan.stations)
    for (const int s : station.strokes)
      EXPECT_EQ(plan.strokes[s].flattening, station.set_up == 1);
}

}  // namespace
}  // namespace planish::test
