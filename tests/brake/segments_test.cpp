#include "segments.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Every sum of a few segments, by trying all subsets.
TEST(Segments, AddUpToEveryLengthThatASubsetHas) {
  const std::vector<double> segments = {200, 100, 100, 50, 40, 20, 15, 10};
  std::vector<double> all;
  for (unsigned subset = 1; subset < 1U << segments.size(); ++subset) {
    double sum = 0.0;
    for (size_t i = 0; i < segments.size(); ++i)
      if (subset >> i & 1U) sum += segments[i];
    all.push_back(sum);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const SegmentSums sums(segments);
  ASSERT_EQ(sums.sums().size(), all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(sums.sums()[i].length, all[i], 1e-9);
    const std::vector<double> chosen = sums.chosen(sums.sums()[i].chosen);
    EXPECT_NEAR(std::accumulate(chosen.begin(), chosen.end(), 0.0), all[i], 1e-9);
  }
}

TEST(Segments, AreAsShortAsTheLineLessItsShortfall) {
  const SegmentSums sums({100, 50, 20, 10});
  // 87 mm less 2 · 3.5 is 80: 50 + 20 + 10.
  auto rows = tool_rows(sums, {{{0, 87}}, 3.5, {}, 1000});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].length(), 80.0, 1e-9);
  EXPECT_NEAR(rows[0].from, 3.5, 1e-9);
  // A little more takes the 100, which stands out in the middle.
  rows = tool_rows(sums, {{{0, 87.2}}, 3.5, {}, 1000});
  EXPECT_NEAR(rows[0].length(), 100.0, 1e-9);
  EXPECT_NEAR(rows[0].from, 43.6 - 50.0, 1e-9);
  EXPECT_TRUE(tool_rows(sums, {{{0, 200}}, 3.5, {}, 1000}).empty());
  EXPECT_TRUE(tool_rows(sums, {{{0, 100}}, 3.5, {}, 90}).empty());
}

TEST(Segments, StandBetweenWallsAndBridgeGaps) {
  const SegmentSums sums({100, 60, 40, 30});
  // Walls close to both ends: 100 stands in 100 but for ε at each side, 99.8 does not take it.
  EXPECT_FALSE(tool_rows(sums, {{{2, 98}}, 1, {{-5, 0}, {100, 105}}, 1000}).empty());
  EXPECT_TRUE(tool_rows(sums, {{{2, 98}}, 1, {{-5, 0}, {99.8, 105}}, 1000}).empty());
  // Two pieces: bridged, or with a wall between two rows of what there is once.
  auto rows = tool_rows(sums, {{{0, 40}, {60, 100}}, 0, {}, 1000});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_NEAR(rows[0].length(), 100.0, 1e-9);
  rows = tool_rows(sums, {{{0, 40}, {60, 100}}, 0, {{45, 55}}, 1000});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_NEAR(rows[0].length(), 40.0, 1e-9);
  EXPECT_NEAR(rows[1].length(), 60.0, 1e-9);
  // 105 on both sides: 130 and then only 100.
  EXPECT_TRUE(tool_rows(sums, {{{0, 105}, {120, 225}}, 0, {{108, 115}}, 1000}).empty());
}

/// The last wall of a box between two that stand: the row goes between them. The walls' inner faces
/// lie where their bends have turned, beside a base of length l: r inside each tangent line is
/// bent, so the faces are l + 2 r apart. A segment of that length fits, with ε at each end. (The
/// walls are so narrow that they stand beside the punch above its tip, clear of their bends.)
TEST(Segments, OfAPunchGoBetweenTheWallsOfABox) {
  BoxSize size;
  size.height = 40.0;
  size.length = 120.0;
  size.width = 90.0;
  size.relief = 30.0;
  const double between = size.length + 2.0 * size.inside_radius;
  for (const double step : {-0.1, 0.1}) {
    PlainPunch plain;
    plain.segments = {between + 2.0 * 0.05 + step};
    BrakeTools tools = plain_tools(plain,
                                   {12.0, Angle::degrees(80), 1.5, 14.0, 100.0, {120, 90, 80}});
    Room room(box(size), tools);
    // Bends 1 and 3 are the long ones, along x; 2 and 4 stand beside their ends.
    EXPECT_EQ(room.can_press(1, {2, 4}), step < 0.0) << step;
  }
}

/// Two flaps on one edge are pressed together; each alone as well.
TEST(StrokeModel, PressesBendsOnOneLineTogether) {
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(
      Frame{},
      {polygon({{0, 0}, {40, 0}, {40, 2}, {60, 2}, {60, 0}, {100, 0}, {100, 80}, {0, 80}})});
  for (const int side : {0, 4}) {
    const Rim rim = builder.bend(builder.rim(base, side),
                                 {Angle::degrees(90), 1.0, BendDirection::up});
    builder.flange_behind(rim, {rectangle(rim.length, 30)});
  }
  Room room(builder.finish(), plain_tools());
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

/// Seen from the other side of the machine, segments stand the other way round.
TEST(StrokeModel, TellsRowsAsTheOperatorSeesThem) {
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

BrakeTools gauged_tools() {
  BrakeTools tools = plain_tools();
  tools.machine.gauge = BackGauge{10, 300, 30, {{0, 0}, {0, -20}, {80, -20}, {80, 0}}};
  return tools;
}

/// The gauge reaches the border of the flange at L + BA/2 from the bend line.
TEST(Gauge, TouchesTheBorderBehindTheBend) {
  const double half_zone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);
  const Sheet sheet = strip(
      {Straight{60}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{45}}, 80, 1.5);
  Room room(sheet, gauged_tools());
  const LineSet flat = room.lines({});
  std::vector<double> distances;
  for (const StrokeChoice& choice : choices(room.cache(), flat)) {
    EXPECT_TRUE(choice.gauged);
    const Stroke stroke = describe(room.cache(), flat, choice);
    ASSERT_TRUE(stroke.gauge);
    distances.push_back(stroke.gauge->distance);
    // The edge lies that far from the bend line in the direction of the gauge.
    const BrakeLine& line = room.work().lines[0];
    for (const Vec2& p : {stroke.gauge->edge.a, stroke.gauge->edge.b})
      EXPECT_NEAR(stroke.gauge_direction.dot(p - line.origin), stroke.gauge->distance, 1e-9);
    EXPECT_NEAR((stroke.gauge->edge.b - stroke.gauge->edge.a).norm(), 80.0, 1e-9);
  }
  std::sort(distances.begin(), distances.end());
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_NEAR(distances[0], 45.0 + half_zone, 1e-9);
  EXPECT_NEAR(distances[1], 60.0 + half_zone, 1e-9);
}

TEST(Gauge, NeedsAnEdgeInRangeAndLongEnough) {
  const auto gauged = [](double width, double flange) {
    Room room(
        strip({Straight{50}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{flange}},
              width, 1.5),
        gauged_tools());
    int ways = 0;
    for (const StrokeChoice& choice : choices(room.cache(), room.lines({})))
      ways += choice.gauged;
    return ways;
  };
  EXPECT_EQ(gauged(30.1, 50), 2);
  EXPECT_EQ(gauged(29.9, 50), 0);
  const double half_zone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);
  EXPECT_EQ(gauged(60, 300 - half_zone - 0.1), 2);
  EXPECT_EQ(gauged(60, 300 - half_zone + 0.1), 1);
}

/// A flange that was bent is no edge in the plane of the sheet any more: the finger finds nothing
/// to touch. Bent down, it is not in the plane either.
TEST(Gauge, TouchesOnlyWhatLiesInThePlane) {
  for (const BendDirection second : {BendDirection::up, BendDirection::down}) {
    Room room(strip({Straight{60}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{90},
                     Turn{Angle::degrees(90), 2, second}, Straight{25}},
                    80, 1.5),
              gauged_tools());
    int gauged = 0, ways = 0;
    for (const StrokeChoice& choice : choices(room.cache(), room.lines({2}))) {
      ++ways;
      gauged += choice.gauged;
    }
    EXPECT_EQ(ways, 2);
    EXPECT_EQ(gauged, 1);  // by the first flange, on the other side
  }
}

}  // namespace
}  // namespace planish::test
