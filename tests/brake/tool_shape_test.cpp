#include "tool_shape.hpp"

#include "brake/stroke_room.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr double kChord = 0.003;  // mm: arcs of tools are chords within 0.002

double area_of(const Obstacle& obstacle) {
  double area = 0.0;
  for (const Convex& piece : obstacle.pieces)
    area += ring_area(piece);
  return area;
}

Punch deep_goose_neck() {
  Punch neck = punch();
  neck.profile = {{0, 0},    {5, 5.96},  {5, 25},   {-12, 45}, {-12, 80}, {14, 100},
                  {14, 150}, {-45, 150}, {-45, 40}, {-8, 18},  {-8, 9.53}};
  return neck;
}

/// A tip of radius t and angle A is t (1/sin(A/2) − 1) higher than its corner.
TEST(ToolShape, LowersAPunchUntilItsRoundTipTouches) {
  for (const double degrees : {30.0, 60.0, 88.0})
    for (const double tip : {0.2, 1.0, 3.0}) {
      const Punch made = punch({Angle::degrees(degrees), 10.0, 150.0, tip});
      const double by = tip * (1.0 / std::sin(0.5 * made.angle.radians()) - 1.0);
      EXPECT_NEAR(lowered(made), by, 1e-9);
      const ToolSection section = section_of(made);
      double lowest = 1e9, highest = -1e9;
      for (const Vec2& p : section.outline) {
        lowest = std::min(lowest, p.y());
        highest = std::max(highest, p.y());
        // On the circle of the tip, wherever the outline is lower than its ends.
        if (p.y() < tip * (1.0 - std::sin(0.5 * made.angle.radians())) - 1e-9) {
          EXPECT_NEAR((p - Vec2(0, tip)).norm(), tip, 1e-9);
        }
      }
      EXPECT_NEAR(lowest, 0.0, kChord);
      EXPECT_NEAR(highest, 150.0 - by, 1e-9);
      EXPECT_GT(ring_area(section.outline), 0.0);
    }
  Punch sharp = punch();
  sharp.tip_radius = 0.0;
  EXPECT_EQ(lowered(sharp), 0.0);
  EXPECT_EQ(section_of(sharp).outline.size(), 5u);
}

/// The shoulder's circle touches the die's top and the flank of its V.
TEST(ToolShape, RoundsTheShouldersOfADie) {
  for (const double degrees : {30.0, 80.0, 88.0}) {
    const Die made = die({16.0, Angle::degrees(degrees), 2.0});
    const Shoulder shoulder = shoulder_of(made);
    EXPECT_NEAR(shoulder.radius, 2.0, 1e-9);
    EXPECT_NEAR(shoulder.height, -2.0, 1e-9);
    const double half = 0.5 * made.angle.radians();
    const Vec2 center(shoulder.across, shoulder.height);
    const Segment flank{{8, 0}, {8 - 4 * std::sin(half), -4 * std::cos(half)}};
    EXPECT_NEAR(std::abs(cross((flank.b - flank.a).normalized(), center - flank.a)), 2.0, 1e-9);
    EXPECT_GT(shoulder.across, 8.0);
    // Both sides are rounded alike.
    EXPECT_TRUE(is_symmetric(section_of(made)));
    double top = -1e9;
    for (const Vec2& p : section_of(made).outline) {
      top = std::max(top, p.y());
      EXPECT_GT((p - Vec2(8, 0)).norm(), 0.1);
      EXPECT_GT((p - Vec2(-8, 0)).norm(), 0.1);
    }
    EXPECT_NEAR(top, 0.0, 1e-9);
  }
  Die sharp = die();
  sharp.shoulder_radius = 0.0;
  EXPECT_NEAR(shoulder_of(sharp).across, 0.5 * sharp.opening, 1e-12);
  EXPECT_EQ(shoulder_of(sharp).radius, 0.0);
}

TEST(ToolShape, ShrinksABodyByWhatMayBePenetrated) {
  const ToolSection block = section_of(ToolProfile{{-20, 0}, {20, 0}, {20, 60}, {-20, 60}}, 5.0);
  EXPECT_EQ(block.outline.front().y(), -5.0);
  const Obstacle deep = obstacle_of(block, 2.0, 0.0), whole = obstacle_of(block, 2.0, 1.5);
  EXPECT_NEAR(area_of(deep), 36.0 * 56.0, 1e-6);
  EXPECT_EQ(deep.keep, 0.0);
  EXPECT_NEAR(area_of(whole), 40.0 * 60.0, 1e-6);
  EXPECT_EQ(whole.keep, 1.5);
  EXPECT_EQ(whole.keeps, std::vector<double>(whole.pieces.size(), 1.5));
  EXPECT_NEAR(whole.box.lo.y(), -5.0, 1e-12);
  EXPECT_NEAR(whole.box.hi.y(), 55.0, 1e-12);
  EXPECT_TRUE(obstacle_of({}, 0.0, 1.0).pieces.empty());
}

void expect_boxes(const Obstacle& obstacle) {
  Box2 all;
  ASSERT_EQ(obstacle.boxes.size(), obstacle.pieces.size());
  for (std::size_t i = 0; i < obstacle.pieces.size(); ++i) {
    EXPECT_EQ(obstacle.boxes[i].lo, box_of(obstacle.pieces[i]).lo);
    EXPECT_EQ(obstacle.boxes[i].hi, box_of(obstacle.pieces[i]).hi);
    all.add(obstacle.boxes[i]);
  }
  EXPECT_EQ(obstacle.box.lo, all.lo);
  EXPECT_EQ(obstacle.box.hi, all.hi);
}

TEST(ToolShape, MovesMirrorsAndUnitesWithAllBoxes) {
  const Obstacle neck = obstacle_of(section_of(deep_goose_neck()), 0.05, 0.0);
  const Obstacle far = moved(neck, {100, -30}), mirror = mirrored(neck);
  expect_boxes(neck);
  expect_boxes(far);
  expect_boxes(mirror);
  EXPECT_NEAR(far.box.lo.x(), neck.box.lo.x() + 100.0, 1e-9);
  EXPECT_NEAR(far.box.hi.y(), neck.box.hi.y() - 30.0, 1e-9);
  EXPECT_NEAR(mirror.box.lo.x(), -neck.box.hi.x(), 1e-12);
  EXPECT_NEAR(mirror.box.hi.x(), -neck.box.lo.x(), 1e-12);
  Obstacle kept = far;
  kept.keep = 3.0;
  kept.keeps.assign(kept.pieces.size(), 3.0);
  const Obstacle both = united(neck, kept);
  expect_boxes(both);
  EXPECT_EQ(both.pieces.size(), neck.pieces.size() + far.pieces.size());
  EXPECT_EQ(both.keep, 3.0);
  EXPECT_EQ(both.keeps.front(), 0.0);
  EXPECT_EQ(both.keeps.back(), 3.0);
}

TEST(ToolShape, KnowsItsMirrorImage) {
  EXPECT_TRUE(is_symmetric(section_of(punch())));
  EXPECT_FALSE(is_symmetric(section_of(deep_goose_neck())));
  EXPECT_FALSE(is_symmetric(section_of(ToolProfile{{0, 0}, {10, 0}, {0, 10}})));
}

/// Whether a place is in the wedge of a tip, prolonged.
bool in_wedge(const Punch& of, const Vec2& p) {
  const double half = 0.5 * of.angle.radians();
  const Vec2 tip(0.0, -lowered(of));
  return std::abs((p - tip).x()) <= (p - tip).y() * std::tan(half) + 1e-6;
}

/// A straight punch is all wedge; of a goose neck what stands out is what lies beyond the flanks.
TEST(ToolShape, TellsWhatStandsOutBeyondTheTip) {
  EXPECT_TRUE(obstacle_beside_tip(punch(), 1.0).pieces.empty());
  const Punch neck = deep_goose_neck();
  const Obstacle beside = obstacle_beside_tip(neck, 1.0);
  ASSERT_FALSE(beside.pieces.empty());
  EXPECT_EQ(beside.keep, 1.0);
  expect_boxes(beside);
  for (const Convex& piece : beside.pieces)
    for (const Vec2& p : piece)
      EXPECT_TRUE(!in_wedge(neck, p) ||
                  in_wedge(neck, p + Vec2(1e-5, 0)) != in_wedge(neck, p - Vec2(1e-5, 0)));
  // By points all over the section: in one of the pieces exactly if it is not in the wedge.
  const Obstacle whole = obstacle_of(section_of(neck), 0.0, 1.0);
  const auto covers = [](const Obstacle& of, const Vec2& p) {
    return std::ranges::any_of(of.pieces,
                               [&](const Convex& piece) { return separation(piece, {p}) < -1e-3; });
  };
  int outside = 0;
  for (double x = -46.05; x < 20; x += 0.7)
    for (double y = 0.3; y < 150; y += 1.3) {
      if (!covers(whole, {x, y})) continue;
      const bool beyond = !in_wedge(neck, {x, y});
      EXPECT_EQ(covers(beside, {x, y}), beyond) << x << " " << y;
      outside += beyond ? 1 : 0;
    }
  EXPECT_GT(outside, 20);
}

}  // namespace
}  // namespace planish::test
