#include "sweep.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

constexpr int kLooks = 1000;

PressMotion random_motion(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double t = 0.5 + 3.0 * share(random), r = 4.0 * share(random);
  const double angle = 0.3 + 1.8 * share(random);
  Die lower = die({6.0 * t + 4.0 * share(random), Angle::degrees(60), 0.5 + share(random)});
  return {{t, angle * (r + 0.44 * t), 0.44 * t}, shoulder_of(lower)};
}

Vec2 at(const Convex& section, size_t corner) { return section[corner]; }

/// Speeds are bounds: between two close turns nothing moves faster.
TEST(PressMotion, IsNotFasterThanItsBounds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const PressMotion motion = random_motion(random);
    const double turn = 0.001 + 2.4 * share(random), next = turn * (1.0 + 1e-5);
    const Convex section = {Vec2(100.0 * share(random), 60.0 * share(random) - 30.0)};
    const double moved = (at(motion.side(section, next), 0) - at(motion.side(section, turn), 0))
                             .norm();
    EXPECT_LE(moved, (next - turn) * motion.side_speed(section, next) * (1.0 + 1e-6));
    EXPECT_LE(std::abs(motion.die_height(next) - motion.die_height(turn)),
              (next - turn) * motion.die_speed(next) * (1.0 + 1e-6));
    EXPECT_LE(std::abs(motion.contact(next) - motion.contact(turn)),
              (next - turn) * motion.contact_speed(next) * (1.0 + 1e-6));
    const double half = 0.5 * motion.bend().allowance, from = half * share(random);
    const Convex a = motion.arc(from, half, turn), b = motion.arc(from, half, next);
    ASSERT_EQ(a.size(), b.size());
    for (size_t k = 0; k < a.size(); ++k)
      EXPECT_LE((a[k] - b[k]).norm(), (next - turn) * motion.arc_speed(next) * (1.0 + 1e-6));
  }
}

/// The sheet is not stretched: the bend's arc goes on in the side, and at the start both lie flat.
TEST(PressMotion, KeepsTheSheetTogether) {
  std::mt19937 random(6);
  for (int i = 0; i < 50; ++i) {
    const PressMotion motion = random_motion(random);
    const auto& [t, allowance, neutral] = motion.bend();
    const Convex end = {Vec2(0.5 * allowance, 0.0), Vec2(0.5 * allowance, -t)};
    for (const double turn : {1e-12, 1e-7, 1e-3, 0.4, 1.5}) {
      const Convex side = motion.side(end, turn);
      const double r = allowance / turn - neutral;
      if (r < 0.0) continue;
      const Vec2 inside(r * std::sin(0.5 * turn), 2.0 * r * std::pow(std::sin(0.25 * turn), 2));
      EXPECT_LT((side[0] - inside).norm(), 1e-6);
      EXPECT_NEAR((side[1] - side[0]).norm(), t, 1e-9);
    }
    EXPECT_LT((motion.side({Vec2(7, 3)}, 0.0)[0] - Vec2(7, 3)).norm(), 1e-12);
  }
}

/// The outside skin touches the shoulder's circle: their distance is the radius at every turn.
TEST(PressMotion, LaysTheSidesOnTheShoulders) {
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    const double t = 1.0 + 0.05 * i;
    const Die lower = die({8.0 * t, Angle::degrees(84), 0.4 * t});
    const Shoulder shoulder = shoulder_of(lower);
    const PressMotion motion({t, 1.5 * (t + 0.44 * t), 0.44 * t}, shoulder);
    for (const double turn : {0.0, 1e-9, 1e-4, 0.3, 0.9, 1.5}) {
      const Convex skin = motion.side({Vec2(0, -t), Vec2(200, -t)}, turn);
      const Vec2 center(shoulder.across, motion.die_height(turn) + shoulder.height);
      const Vec2 along = (skin[1] - skin[0]).normalized();
      const Vec2 to = center - skin[0];
      EXPECT_NEAR(-(along.x() * to.y() - along.y() * to.x()), shoulder.radius, 1e-8) << turn;
      // And where it says: measured along the sheet from the bend line.
      EXPECT_NEAR(along.dot(to), motion.contact(turn), 1e-8) << turn;
    }
  }
}

/// Nothing slips through between turns: whatever a dense look finds is found, and what is found
/// can be seen.
TEST(Sweep, FindsWhatADenseLookFinds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int hits = 0, clear = 0;
  for (int i = 0; i < 800; ++i) {
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
    EXPECT_LE(near.distance, least + 1e-9);
    EXPECT_GT(near.distance, least - 0.1);  // of 100 mm · 0.8 rad / 1000 between two looks
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(clear, 200);
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

}  // namespace
}  // namespace planish::test
