#include "gauge.hpp"

#include "brake/gauged_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace brake_detail;

/// With a front too low for flanges.
BrakeTools edge_tools() {
  BrakeTools tools = gauged_tools();
  tools.machine.gauge->finger = {{0, 0}, {0, -4}, {80, -4}, {80, 0}};
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
  std::ranges::sort(distances);
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_NEAR(distances[0], 45.0 + half_zone, 1e-9);
  EXPECT_NEAR(distances[1], 60.0 + half_zone, 1e-9);
}

/// A flange that was bent before stands upright at the gauge: its outer face is R + T beyond its
/// tangent line, and the finger's front, 20 high, is moved up or down to where that is plane.
TEST(Gauge, TouchesTheOuterFaceOfAFormedFlange) {
  const double radius = 2.0, thickness = 1.5, web = 80.0;
  const double half_zone = 0.25 * std::numbers::pi * (radius + 0.44 * thickness);
  for (const bool same_side : {true, false}) {
    const Turn first{Angle::degrees(90), radius, BendDirection::up},
        second{Angle::degrees(90), radius, same_side ? BendDirection::up : BendDirection::down};
    const Sheet sheet = strip({Straight{30}, first, Straight{web}, second, Straight{40}}, 60,
                              thickness);
    BrakeTools tools = gauged_tools();
    tools.machine.gauge->lowest = -40.0;
    tools.machine.gauge->highest = 80.0;
    const auto stop_at_web = [&](const BrakeTools& with) {
      Room room(sheet, with);
      std::optional<GaugeStop> found;
      for (const StrokeChoice& choice : room.ways(2, {1})) {
        const Stroke stroke = describe(room.cache(), room.lines({1}), choice);
        if (stroke.to_gauge == FlangeId(1)) found = stroke.gauge;
      }
      return found;
    };
    const auto stop = stop_at_web(tools);
    ASSERT_TRUE(stop) << same_side;
    EXPECT_EQ(stop->flange, FlangeId(0));
    EXPECT_NEAR(stop->distance, web + half_zone + radius + thickness, 1e-9);
    EXPECT_NEAR(stop->height, same_side ? radius + 20.0 : -(thickness + radius), 1e-9);
    EXPECT_NEAR((stop->edge.b - stop->edge.a).norm(), 60.0, 1e-9);
    // Fingers that do not go so far touch less of it, but at least T.
    for (const double touched : {19.9, 1.51, 1.49}) {
      tools.machine.gauge->highest = same_side ? radius + touched : 80.0;
      tools.machine.gauge->lowest = same_side ? -40.0 : -(thickness + radius) + 20.0 - touched;
      const auto low = stop_at_web(tools);
      ASSERT_EQ(low.has_value(), touched > 1.5) << touched;
      if (!low) continue;
      EXPECT_NEAR(low->height,
                  same_side ? radius + touched : -(thickness + radius) + 20.0 - touched, 1e-9);
    }
    Room room(sheet, tools);
    for (const StrokeChoice& choice : room.ways(2, {1})) {
      const Stroke stroke = describe(room.cache(), room.lines({1}), choice);
      if (stroke.to_gauge == FlangeId(1)) {
        ASSERT_TRUE(stroke.ungauged);
        EXPECT_EQ(stroke.ungauged->code, "face_beyond_lift");
      }
    }
    // At the sheet their front reaches 20 down, past the bend of a flange that goes down.
    EXPECT_EQ(stop_at_web(gauged_tools()).has_value(), !same_side);
    EXPECT_FALSE(stop_at_web(edge_tools()));
  }
}

/// A strip whose sides end so far from the bend line, on both sides of it.
Sheet short_sides(double reach) {
  return strip({Straight{reach - kHalfZone}, Turn{Angle::degrees(90), 2, BendDirection::up},
                Straight{reach - kHalfZone}},
               80, 1.5);
}

BrakeTools tools_for_short_sides(double lift, const PlainPunch& upper = {.half_width = 4.0}) {
  BrakeTools tools = plain_tools(upper);  // dies of 20 to either side
  tools.machine.gauge = gauged_tools().machine.gauge;
  tools.machine.gauge->from = 5.0;
  tools.machine.gauge->highest = lift;
  return tools;
}

/// Nearer than the side of the die, a finger 20 high has to be 20 − T higher to lie on the die.
TEST(Gauge, LiftsTheFingerOntoTheDie) {
  for (const double reach : {12.0, 19.7, 20.2, 40.0})
    for (const Stroke& stroke : strokes_of(short_sides(reach), tools_for_short_sides(80.0))) {
      ASSERT_TRUE(stroke.gauge) << reach;
      EXPECT_NEAR(stroke.gauge->distance, reach, 1e-9);
      EXPECT_NEAR(stroke.gauge->height, reach < 20.0 ? 18.5 : 0.0, 1e-9) << reach;
    }
  for (const double lift : {18.4, 18.6})
    for (const Stroke& stroke : strokes_of(short_sides(12.0), tools_for_short_sides(lift))) {
      EXPECT_EQ(stroke.gauge.has_value(), lift > 18.5);
      if (!stroke.gauge) {
        EXPECT_EQ(stroke.ungauged->code, "finger_in_tool");
      }
    }
}

/// Lifted, it is beside the body of the punch. Of two punches the thin one leaves it room.
TEST(Gauge, LeavesAFingerOutOfThePunch) {
  for (const double reach : {9.8, 10.2}) {
    BrakeTools tools = tools_for_short_sides(80.0, {.half_width = 10.0});
    tools.punches.push_back(punch({.half_width = 4.0}));
    tools.punches.back().id = "thin";
    const auto strokes = strokes_of(short_sides(reach), tools);
    EXPECT_EQ(strokes.size(), 4u);
    for (const Stroke& stroke : strokes)
      EXPECT_EQ(stroke.gauge.has_value(), reach > 10.0 || stroke.punch == "thin") << reach;
  }
}

/// A finger whose body is lower behind its front touches the lower half of the edge at least.
TEST(Gauge, TouchesHalfOfTheEdgeFromTheDie) {
  for (const double lower : {0.7, 0.8}) {
    BrakeTools tools = tools_for_short_sides(80.0);
    tools.machine.gauge->finger = {{0, 0}, {0, -20}, {2, -20 - lower}, {80, -20 - lower}, {80, 0}};
    for (const Stroke& stroke : strokes_of(short_sides(12.0), tools))
      EXPECT_EQ(stroke.gauge.has_value(), lower < 0.75);
  }
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
  EXPECT_EQ(gauged(5.1, 50), 2);  // of a narrow part all its width
  EXPECT_EQ(gauged(4.9, 50), 0);
  EXPECT_EQ(gauged(60, 300 - kHalfZone - 0.1), 2);
  EXPECT_EQ(gauged(60, 300 - kHalfZone + 0.1), 1);
}

/// A flange that was bent is no edge in the plane of the sheet any more: the finger finds nothing
/// to touch. Bent down, it is not in the plane either.
TEST(Gauge, TouchesOnlyWhatLiesInThePlane) {
  for (const BendDirection second : {BendDirection::up, BendDirection::down}) {
    Room room(strip({Straight{60}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{90},
                     Turn{Angle::degrees(90), 2, second}, Straight{25}},
                    80, 1.5),
              edge_tools());
    int gauged = 0, ways = 0;
    for (const StrokeChoice& choice : choices(room.cache(), room.lines({2}))) {
      ++ways;
      gauged += choice.gauged;
    }
    EXPECT_EQ(ways, 2);
    EXPECT_EQ(gauged, 1);  // by the first flange, on the other side
  }
}

/// Of edges in reach the longest is taken, not the nearest; of what a wall hides another.
TEST(Gauge, TakesTheLongestEdge) {
  for (const double wide : {45.0, 35.0}) {
    SheetBuilder builder(1.5);
    const FaceId base = builder.flange(Frame{}, {rectangle(80, 60)});
    const Rim rim = builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up});
    builder.flange_behind(
        rim, {polygon({{0, 0}, {80, 0}, {80, 50}, {80 - wide, 50}, {80 - wide, 40}, {0, 40}})});
    Room room(builder.finish(), gauged_tools());
    const double half_zone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 1.5);
    std::vector<double> distances;
    for (const StrokeChoice& choice : choices(room.cache(), room.lines({})))
      distances.push_back(describe(room.cache(), room.lines({}), choice).gauge->distance);
    std::ranges::sort(distances);
    ASSERT_EQ(distances.size(), 2u);
    EXPECT_NEAR(distances[0], (wide > 40.0 ? 50.0 : 40.0) + half_zone, 1e-9);
    EXPECT_NEAR(distances[1], 60.0 + half_zone, 1e-9);
  }
}

/// Edges that go on, here on both sides of a seam, are one: neither is as wide as the finger.
TEST(Gauge, TakesNeighbouringEdgesForOne) {
  SheetBuilder builder(1.5);
  const FaceId base = builder.flange(Frame{}, {rectangle(50, 60)});
  const Rim rim = builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up});
  builder.flange_behind(rim, {polygon({{0, 0}, {50, 0}, {50, 40}, {25, 40}, {0, 40}})});
  Room room(builder.finish(), gauged_tools());  // fingers are 30 wide
  for (const StrokeChoice& choice : choices(room.cache(), room.lines({})))
    EXPECT_TRUE(choice.gauged);
}

/// The stop of the first bend with the web at the gauge.
std::optional<GaugeStop> stop_at_web(const OpenedPart& part, const BrakeTools& tools,
                                     bool openings = true, const std::vector<int>& formed = {}) {
  PlanOptions options;
  options.gauge_openings = openings;
  Room room(part.sheet(), tools, options);
  for (const StrokeChoice& choice : room.ways(1, formed)) {
    const Stroke stroke = describe(room.cache(), room.lines(formed), choice);
    EXPECT_EQ(stroke.gauge.has_value(), choice.gauged);
    if (stroke.to_gauge == FlangeId(0)) return stroke.gauge;
  }
  ADD_FAILURE() << "no way has the web at the gauge";
  return std::nullopt;
}

/// The nose touches the border of the opening that is next to the bend, where it is asked for.
TEST(Gauge, TouchesInAnOpeningOnRequest) {
  const OpenedPart part;
  EXPECT_FALSE(stop_at_web(part, tools_with_nose(), false));
  const auto stop = stop_at_web(part, tools_with_nose());
  ASSERT_TRUE(stop);
  EXPECT_TRUE(stop->in_opening);
  EXPECT_TRUE(stop->by_nose);
  EXPECT_NEAR(stop->distance, part.from + kHalfZone, 1e-9);
  EXPECT_NEAR((stop->edge.b - stop->edge.a).norm(), part.wide, 1e-9);
  EXPECT_EQ(stop->height, 0.0);
  BrakeTools without = tools_with_nose();
  without.machine.gauge->nose.reset();
  EXPECT_FALSE(stop_at_web(part, without));
}

TEST(Gauge, NeedsAnOpeningThatTakesTheNose) {
  const auto is_gauged = [](const OpenedPart& part, const BrakeTools& tools = tools_with_nose()) {
    return stop_at_web(part, tools).has_value();
  };
  EXPECT_TRUE(is_gauged({.wide = 10.1}));
  EXPECT_FALSE(is_gauged({.wide = 9.9}));
  EXPECT_TRUE(is_gauged({.deep = 6.1}));
  EXPECT_FALSE(is_gauged({.deep = 5.8}));
  BrakeTools tools = tools_with_nose();
  tools.machine.gauge->to = 40.0 + kHalfZone + 0.1;
  EXPECT_TRUE(is_gauged({}, tools));
  tools.machine.gauge->to -= 0.2;
  EXPECT_FALSE(is_gauged({}, tools));
  tools = tools_with_nose();
  tools.machine.gauge->from = 40.0 + kHalfZone - 0.1;
  EXPECT_TRUE(is_gauged({}, tools));
  tools.machine.gauge->from += 0.2;
  EXPECT_FALSE(is_gauged({}, tools));
  // A nose that does not rise above the sheet behind hits it.
  tools = tools_with_nose();
  tools.machine.gauge->nose->profile[3].y() = -0.2;
  tools.machine.gauge->nose->profile[4].y() = -0.2;
  EXPECT_FALSE(is_gauged({}, tools));
}

/// The inside of a flange on the far edge stands 2 beyond the web's end at 150; the nose is 80
/// long.
TEST(Gauge, SweepsTheNoseOverAllParts) {
  for (const double room : {0.1, -0.2}) {
    const OpenedPart part{.from = 152.0 - 80.0 - room, .slope = 0.0, .raised = true};
    const auto stop = stop_at_web(part, tools_with_nose(), true, {2});
    EXPECT_EQ(stop.has_value(), room > 0.0);
  }
}

/// Outer edges come first, then faces of flanges, and openings last.
TEST(Gauge, PrefersTheOutside) {
  const auto outer = stop_at_web({.slope = 0.0}, tools_with_nose());
  ASSERT_TRUE(outer);
  EXPECT_FALSE(outer->in_opening);
  EXPECT_NEAR(outer->distance, 150.0 + kHalfZone, 1e-9);
  const OpenedPart raised{.slope = 0.0, .raised = true};
  const auto low = stop_at_web(raised, tools_with_nose(), true, {2});
  ASSERT_TRUE(low);
  EXPECT_TRUE(low->in_opening);
  BrakeTools tools = tools_with_nose();
  tools.machine.gauge->highest = 80.0;
  const auto face = stop_at_web(raised, tools, true, {2});
  ASSERT_TRUE(face);
  EXPECT_FALSE(face->in_opening);
  EXPECT_NEAR(face->distance, 150.0 + kHalfZone + 2.0 + 1.5, 1e-9);
}

/// On request a finger goes into an opening that is large enough for it, where the nose does not.
TEST(Gauge, TouchesInALargeOpeningWithAFinger) {
  BrakeTools tools = tools_with_nose();
  tools.machine.gauge->finger_width = 30.0;
  EXPECT_TRUE(stop_at_web({.deep = 80.1, .wide = 50.0}, tools)->by_nose);
  const OpenedPart both{.deep = 85.0, .wide = 50.0, .slope = 0.0, .cut = 45.0};
  EXPECT_NEAR(stop_at_web(both, tools)->distance, 150.0 + kHalfZone, 1e-9);
  tools.machine.gauge->nose->profile = {{0, 0}, {0, -3}, {90, -3}, {90, 20}, {0, 20}};
  for (const double deep : {79.8, 80.1}) {
    const OpenedPart large{.deep = deep, .wide = 50.0};
    EXPECT_FALSE(stop_at_web(large, tools, false));
    const auto finger = stop_at_web(large, tools);
    ASSERT_EQ(finger.has_value(), deep > 80.0);
    if (!finger) continue;
    EXPECT_TRUE(finger->in_opening);
    EXPECT_FALSE(finger->by_nose);
  }
}

/// Between flaps that hang down on both sides, 2 away from its ends, an edge of 26 leaves just the
/// 30 that a finger needs, which stands over both ends.
TEST(Gauge, NeedsRoomForAFinger) {
  for (const double edge : {25.7, 26.1}) {
    const double a = 50.0 - 0.5 * edge, b = 50.0 + 0.5 * edge;
    SheetBuilder builder(1.5);
    const FaceId base = builder.flange(Frame{}, {polygon({{0, 0},
                                                          {100, 0},
                                                          {100, 60},
                                                          {b + 2, 60},
                                                          {b + 2, 58},
                                                          {b, 58},
                                                          {b, 60},
                                                          {a, 60},
                                                          {a, 58},
                                                          {a - 2, 58},
                                                          {a - 2, 60},
                                                          {0, 60}})});
    builder.flange_behind(
        builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up}),
        {rectangle(100, 50)});
    for (const int border : {2, 10}) {
      const Rim flap = builder.bend(builder.rim(base, border),
                                    {Angle::degrees(90), 2, BendDirection::down});
      builder.flange_behind(flap, {rectangle(flap.length, 20)});
    }
    Room room(builder.finish(), edge_tools());
    int gauged = 0;
    for (const StrokeChoice& choice : room.ways(1, {2, 3}))
      if (choice.gauged &&
          describe(room.cache(), room.lines({2, 3}), choice).gauge->distance > 60.0)
        ++gauged;
    EXPECT_EQ(gauged > 0, edge > 26.0) << edge;
  }
}

/// A base of 60, on whose far side a flange stands beside an edge that rises by `slope`.
struct SteppedEnd {
  double flange = 50.0, edge = 28.0, slope = 0.0;

  /// Where the finger, 30 wide, touches the base when the flange is formed.
  std::optional<GaugeStop> stop(double lift) const {
    SheetBuilder builder(1.5);
    const double wide = flange + 2.0 + edge;
    const FaceId base = builder.flange(Frame{}, {polygon({{0, 0},
                                                          {wide, 0},
                                                          {wide, 60 - slope},
                                                          {flange + 2, 60},
                                                          {flange + 2, 58},
                                                          {flange, 58},
                                                          {flange, 60},
                                                          {0, 60}})});
    const Turn turn{Angle::degrees(90), 2, BendDirection::up};
    builder.flange_behind(builder.bend(builder.rim(base, 0), turn), {rectangle(wide, 50)});
    builder.flange_behind(builder.bend(builder.rim(base, 6), turn), {rectangle(flange, 40)});
    BrakeTools tools = gauged_tools();
    tools.machine.gauge->highest = lift;
    Room room(builder.finish(), tools);
    for (const StrokeChoice& choice : room.ways(1, {2})) {
      const Stroke stroke = describe(room.cache(), room.lines({2}), choice);
      if (stroke.to_gauge == FlangeId(0)) return stroke.gauge;
    }
    return std::nullopt;
  }
};

/// All of a finger's width on a flange is better than some of it on an edge.
TEST(Gauge, PrefersToTouchWithAllTheWidth) {
  const auto on_flange = SteppedEnd{}.stop(80.0);
  ASSERT_TRUE(on_flange);
  EXPECT_EQ(on_flange->flange, FlangeId(2));
  const auto on_edge = SteppedEnd{}.stop(0.0);
  ASSERT_TRUE(on_edge);
  EXPECT_FALSE(on_edge->flange);
  EXPECT_NEAR(on_edge->distance, 60.0 + kHalfZone, 1e-9);
  EXPECT_NEAR((on_edge->edge.b - on_edge->edge.a).norm(), 28.0, 1e-9);
}

/// Half of the width is enough, on an edge and on a flange.
TEST(Gauge, TouchesWithHalfTheWidth) {
  EXPECT_TRUE((SteppedEnd{.edge = 15.1}.stop(0.0)));
  EXPECT_FALSE((SteppedEnd{.edge = 14.9}.stop(0.0)));
  EXPECT_TRUE((SteppedEnd{.flange = 15.1, .slope = 5.0}.stop(80.0)));
  EXPECT_FALSE((SteppedEnd{.flange = 14.9, .slope = 5.0}.stop(80.0)));
}

/// A base of 100 whose far side, 60 away, slopes but for teeth of level edge between these places.
std::optional<GaugeStop> stop_at_teeth(const std::vector<Interval>& teeth, double nearer = 0.0) {
  std::vector<Vec2> outer{{0, 0}, {100, 0}, {100, 50}};
  double depth = 60.0;
  for (const Interval& tooth : teeth) {
    outer.insert(
        outer.end(),
        {{tooth.hi, depth - 4}, {tooth.hi, depth}, {tooth.lo, depth}, {tooth.lo, depth - 4}});
    depth -= nearer;
  }
  outer.emplace_back(0, 46);
  SheetBuilder builder(1.5);
  const FaceId base = builder.flange(Frame{}, {polygon(outer)});
  builder.flange_behind(
      builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up}),
      {rectangle(100, 50)});
  for (const Stroke& stroke : strokes_of(builder.finish(), gauged_tools()))
    if (stroke.to_gauge == FlangeId(0)) return stroke.gauge;
  return std::nullopt;
}

/// Fingers are 30 wide: two touch an edge from end to end, if each touches half of its width. They
/// hold the sheet square from a third of the line on.
TEST(Gauge, TellsHowFarApartItTouches) {
  const auto touched = [](const std::vector<Interval>& teeth) {
    const auto stop = stop_at_teeth(teeth);
    EXPECT_TRUE(stop);
    EXPECT_EQ(stop->is_square(), stop->touched >= 100.0 / 3.0);
    EXPECT_NEAR(stop->line, 100.0, 1e-9);
    return stop->touched;
  };
  EXPECT_NEAR(touched({{35, 64}}), 29.0, 1e-9);
  EXPECT_NEAR(touched({{20, 80}}), 60.0, 1e-9);
  EXPECT_NEAR(touched({{60, 90}, {10, 40}}), 80.0, 1e-9);
  EXPECT_NEAR(touched({{80, 95}, {10, 40}}), 85.0, 1e-9);  // half of the second finger
}

/// An edge that is off by more than 0.2 mm over the line, here of 400, is not parallel: two fingers
/// at one distance would make the bend crooked by as much.
TEST(Gauge, TouchesNoTaperedEdge) {
  for (const double taper : {0.15, 0.25}) {
    SheetBuilder builder(1.5);
    const FaceId base = builder.flange(Frame{},
                                       {polygon({{0, 0}, {400, 0}, {400, 60}, {0, 60 + taper}})});
    builder.flange_behind(
        builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up}),
        {polygon({{0, 0}, {400, 0}, {400, 50}, {0, 40}})});
    int gauged = 0;
    for (const Stroke& stroke : strokes_of(builder.finish(), gauged_tools()))
      gauged += stroke.gauge ? 1 : 0;
    EXPECT_EQ(gauged, taper < 0.2 ? 1 : 0) << taper;
  }
}

/// Teeth of 10 with gaps between them: fingers, 30 wide, bear on them from end to end, unless a gap
/// is wider than half of a finger.
TEST(Gauge, BearsOnTeeth) {
  for (const double gap : {14.0, 16.0}) {
    std::vector<Interval> teeth;
    for (double at = 0.0; at + 10.0 <= 100.0; at += 10.0 + gap)
      teeth.insert(teeth.begin(), {at, at + 10.0});
    const auto stop = stop_at_teeth(teeth);
    EXPECT_EQ(stop.has_value(), gap < 15.0) << gap;
    if (stop) {
      EXPECT_NEAR(stop->touched, teeth.front().hi - teeth.back().lo, 1e-9);
    }
  }
}

/// Teeth at one distance are better than a longer one by itself, which lies farther away.
TEST(Gauge, PrefersWhatHoldsTheSheetSquare) {
  const std::vector<Interval> teeth{{64, 98}, {32, 63}, {0, 31}};
  const auto at = [](const GaugeStop& stop) { return stop.distance - kHalfZone; };
  EXPECT_NEAR(at(stop_at_teeth({teeth[0], teeth[1]}, 2.0).value()), 60.0, 1e-9);
  SheetBuilder builder(1.5);
  const FaceId base = builder.flange(Frame{}, {polygon({{0, 0},
                                                        {100, 0},
                                                        {100, 54},
                                                        {69, 54},
                                                        {69, 50},
                                                        {66, 50},
                                                        {66, 60},
                                                        {33, 60},
                                                        {33, 50},
                                                        {31, 50},
                                                        {31, 54},
                                                        {0, 54}})});
  builder.flange_behind(
      builder.bend(builder.rim(base, 0), {Angle::degrees(90), 2, BendDirection::up}),
      {rectangle(100, 50)});
  for (const Stroke& stroke : strokes_of(builder.finish(), gauged_tools())) {
    if (stroke.to_gauge != FlangeId(0)) continue;
    ASSERT_TRUE(stroke.gauge);
    EXPECT_NEAR(at(*stroke.gauge), 54.0, 1e-9);
    EXPECT_NEAR(stroke.gauge->touched, 100.0, 1e-9);
  }
}

}  // namespace
}  // namespace planish::test
