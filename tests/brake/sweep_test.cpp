#include "sweep.hpp"

#include "brake/random_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr int kLooks = 1000;

/// Nothing slips through between turns: whatever a dense look finds is found, and what is found
/// can be seen.
TEST(Sweep, FindsWhatADenseLookFinds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int hits = 0, clear = 0;
  for (int i = 0; i < 400; ++i) {
    const PressMotion motion = random_motion(random);
    const double most = 0.8 + 0.8 * share(random);
    const Vec2 corner(5.0 + 60.0 * share(random), 60.0 * share(random) - 20.0);
    const double width = 0.05 + 3.0 * share(random), height = 0.05 + 10.0 * share(random);
    const Convex section = hull_of({corner, corner + Vec2(width, 0.3), corner + Vec2(width, height),
                                    corner + Vec2(0.0, height)});
    PlainPunch plain;
    plain.half_width = 3.0 + 30.0 * share(random);
    plain.height = 60.0;
    Obstacle obstacle = i % 2 ? obstacle_of(section_of(punch(plain)), kPenetration, 0.0)
                              : obstacle_of(section_of(die()), kPenetration, i % 4 ? 0.0 : 2.0);
    obstacle.moves = i % 2 == 0;
    const Moving moving = turned_with_side(motion, section);
    const auto gap = [&](double turn) {
      Convex here = moving.at(turn);
      for (Vec2& p : here)
        p.y() -= obstacle.moves ? motion.die_height(turn) : 0.0;
      double least = 1e9;
      for (const Convex& piece : obstacle.pieces)
        least = std::min(
            least, separation(here, piece) > 0.0 ? distance(here, piece) : separation(here, piece));
      return least - obstacle.keep;
    };
    const auto found = hit(motion, moving, obstacle, most);
    if (found) {
      EXPECT_LE(gap(*found), 1e-9);
      ++hits;
      continue;
    }
    ++clear;
    for (int look = 0; look <= kLooks; ++look)
      EXPECT_GT(gap(most * look / kLooks), -kFollowed) << i;
    const Closest near = closest(motion, moving, obstacle, most, 1e3);
    double least = 1e9;
    for (int look = 0; look <= kLooks; ++look)
      least = std::min(least, gap(most * look / kLooks) + obstacle.keep);
    EXPECT_LE(near.distance, least + kMeasured);
    EXPECT_GT(near.distance, least - 0.1);  // of 100 mm · 0.8 rad / 1000 between two looks
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(clear, 100);
}

/// A flange cut off aslant meets the punch from where it is long enough on: the blocked stretch
/// ends where the section's corner just reaches ε into the punch.
TEST(Sweep, FindsWhereAlongTheLineAWallIsInTheWay) {
  const PressMotion motion({1.0, 1.5708 * 1.44, 0.44}, shoulder_of(die()));
  PlacedPart part;
  part.left = true;
  Block3 wall;  // upright at y 30 … 31, its top from height 0 at x = 0 to 60 at x = 100
  wall.lower = {{0, 31, -0.001}, {100, 31, 0}, {100, 31, 60}};
  wall.upper = {{0, 30, -0.001}, {100, 30, 0}, {100, 30, 60}};
  part.blocks = {wall};
  part.sections = {section(wall, 0, 100)};
  part.hull = part.sections.front();
  const double b = 10.0;
  PlainPunch plain;
  plain.half_width = b;
  const Obstacle obstacle = obstacle_of(section_of(punch(plain)), kPenetration, 0.0);
  const double most = std::acos(0.0);
  const auto blocked = blocked_along(motion, part, obstacle, obstacle, most);
  ASSERT_EQ(blocked.size(), 1u);
  // At 90° the corner (30, h) comes to y = r s + s (30 − BA/2) − s h, with r = 1.
  const double height = 1.0 + 30.0 - 0.5 * motion.bend().allowance -
                        (b - kPenetration) * std::sqrt(2.0);
  EXPECT_NEAR(blocked.front().lo, height / 0.6, 0.02);
  EXPECT_NEAR(blocked.front().hi, 100.0, 0.02);
}

/// A wall that is in the way from x = 30 to 70 on, its sections there as high as 60.
struct WallInTheWay {
  PressMotion motion{{1.0, 1.5708 * 1.44, 0.44}, shoulder_of(die())};
  Obstacle obstacle = obstacle_of(section_of(punch({})), kPenetration, 0.0);
  double most = std::acos(0.0);
  PlacedPart part;

  explicit WallInTheWay(bool left) {
    part.left = left;
    Block3 wall;
    wall.lower = {{30, 31, 0}, {70, 31, 0}, {70, 31, 60}, {30, 31, 60}};
    wall.upper = {{30, 30, 0}, {70, 30, 0}, {70, 30, 60}, {30, 30, 60}};
    part.blocks = {wall};
    part.along = {30, 70};
    part.sections = {section(wall, 30, 70)};
    part.hull = part.sections.front();
  }
};

/// Where it is looked for, a wall is in the way there and nowhere else; what is on the left meets
/// the left obstacle.
TEST(Sweep, LooksWhereItIsAsked) {
  for (const bool left : {true, false}) {
    const WallInTheWay wall(left);
    const Obstacle far = moved(wall.obstacle, {500, 0});
    const auto& [on_left, on_right] = left ? std::tie(wall.obstacle, far)
                                           : std::tie(far, wall.obstacle);
    const auto blocked = [&](const Interval& within) {
      return blocked_along(wall.motion, wall.part, on_left, on_right, wall.most, within);
    };
    const auto everywhere = blocked(kEverywhere);
    ASSERT_EQ(everywhere.size(), 1u);
    EXPECT_NEAR(everywhere.front().lo, 30, 0.02);
    EXPECT_NEAR(everywhere.front().hi, 70, 0.02);
    EXPECT_TRUE(blocked({0, 29}).empty());
    EXPECT_TRUE(blocked({71, 90}).empty());
    EXPECT_FALSE(blocked({35, 40}).empty());
    EXPECT_FALSE(blocked({0, 31}).empty());
    const auto hits = [&](double lo, double hi) {
      return hit_within(wall.motion, wall.part, on_left, on_right, {lo, hi}, wall.most).has_value();
    };
    EXPECT_TRUE(hits(0, 100));
    EXPECT_TRUE(hits(40, 45));
    EXPECT_TRUE(hits(0, 31));
    EXPECT_TRUE(hits(69, 90));
    EXPECT_FALSE(hits(0, 29));
    EXPECT_FALSE(hits(71, 90));
    EXPECT_TRUE(blocked_along(wall.motion, wall.part, far, far, wall.most).empty());
  }
}

/// Strips of the zone that is pressed are in the way along their own range: those of the left in
/// that of the left obstacle.
TEST(Sweep, FindsStripsThatAreInTheWay) {
  const WallInTheWay wall(true);
  PlacedPart zone;
  zone.strips = {{0.2, 1.0, true, {10, 20}}, {0.2, 1.0, false, {40, 50}}};
  zone.along = {10, 50};
  // A bar across the middle, at the height of the sheet.
  const Obstacle bar = obstacle_of({{{-5, -0.5}, {5, -0.5}, {5, 0.5}, {-5, 0.5}}}, kPenetration,
                                   0.0);
  const Obstacle far = moved(bar, {500, 0});
  auto blocked = blocked_along(wall.motion, zone, bar, far, wall.most);
  ASSERT_EQ(blocked.size(), 1u);
  EXPECT_NEAR(blocked[0].lo, 10, 1e-9);
  EXPECT_NEAR(blocked[0].hi, 20, 1e-9);
  blocked = blocked_along(wall.motion, zone, far, bar, wall.most);
  ASSERT_EQ(blocked.size(), 1u);
  EXPECT_NEAR(blocked[0].lo, 40, 1e-9);
  EXPECT_EQ(blocked_along(wall.motion, zone, bar, bar, wall.most).size(), 2u);
  EXPECT_EQ(blocked_along(wall.motion, zone, bar, bar, wall.most, {0, 30}).size(), 1u);
  EXPECT_TRUE(hit_within(wall.motion, zone, bar, far, {15, 16}, wall.most));
  EXPECT_FALSE(hit_within(wall.motion, zone, bar, far, {21, 39}, wall.most));
  EXPECT_FALSE(hit_within(wall.motion, zone, bar, far, {41, 49}, wall.most));
  EXPECT_TRUE(hit_within(wall.motion, zone, far, bar, {41, 49}, wall.most));
}

}  // namespace
}  // namespace planish::test
