#include "sweep.hpp"

#include "brake/random_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
    EXPECT_LE(near.distance, least + 1e-9);
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

}  // namespace
}  // namespace planish::test
