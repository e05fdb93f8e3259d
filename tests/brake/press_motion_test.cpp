#include "press_motion.hpp"

#include "brake/random_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

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

/// The bounds of docs/math.md#stroke-clearance as they stand there: a point d from the tangent
/// point, a point of the bend's zone.
TEST(PressMotion, BoundsSidesAndBendAsTheMathematicsDoes) {
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i) {
    const PressMotion motion = random_motion(random);
    const auto& [t, allowance, neutral] = motion.bend();
    for (const double turn : {0.2, 1.1, 2.3}) {
      const double h = 0.5 * turn;
      const Vec2 tangent(0.5 * allowance, 0.0);
      const Convex points{tangent + Vec2(3, 4), tangent + Vec2(-60, 80), tangent};
      EXPECT_NEAR(motion.side_speed(points, turn),
                  100.0 / 2 + allowance * (h / 12 + 1.0 / 8) + neutral, 1e-9);
      EXPECT_NEAR(motion.arc_speed(turn), allowance * (1.0 / 8 + turn / 24) + t, 1e-9);
    }
  }
}

/// Each term of the die's height and of the contact by itself: what the shoulder's place and the
/// skins contribute is bounded by its own slope, which no bound may exceed without need.
TEST(PressMotion, BoundsTheDieByTheSlopeOfEachTerm) {
  const auto slope = [](const auto& f, double turn) {
    constexpr double kNear = 1e-5;
    return std::abs(f(turn + kNear) - f(turn - kNear)) / (2 * kNear);
  };
  for (const double turn : {0.3, 1.0, 2.0}) {
    const auto only = [&](const PressedBend& bend, const Shoulder& shoulder) {
      return PressMotion(bend, shoulder);
    };
    const double h = 0.5 * turn, c = std::cos(h), secant = std::tan(h) / (2 * c);
    // A sharp fold of a sheet without thickness: the shoulder's place alone, then its radius, then
    // the thickness.
    for (const PressMotion& motion :
         {only({0, 0, 0}, {12, 0, 0}), only({0, 0, 0}, {0, 0, 2}), only({3, 0, 0}, {0, 0, 0})})
      EXPECT_NEAR(motion.die_speed(turn),
                  slope([&](double at) { return motion.die_height(at); }, turn), 1e-6);
    EXPECT_NEAR(only({0, 0, 0}, {12, 0, 0}).contact_speed(turn), 12 * secant, 1e-9);
    // The neutral arc: BA (1 − cos h) / θ over cos h, with |((1 − cos h)/θ)′| ≤ 1/8 and at most
    // h/4.
    EXPECT_NEAR(only({0, 10, 0}, {0, 0, 0}).die_speed(turn), 10 * (0.125 / c + h / 4 * secant),
                1e-9);
    // The skin beside it: K T (1 − cos h) / cos h.
    const auto skin = [](double at) { return (1 - std::cos(at / 2)) / std::cos(at / 2); };
    EXPECT_NEAR(
        only({0, 10, 1.5}, {0, 0, 0}).die_speed(turn) - only({0, 10, 0}, {0, 0, 0}).die_speed(turn),
        1.5 * slope(skin, turn), 1e-6);
    // Of the contact by the product rule: f / cos h with |f| and |f′| of each term.
    const double rest = only({1, 10, 1.5}, {0, 0, 2}).contact_speed(turn);
    EXPECT_NEAR(rest, secant * (5 + 1.5 + 3) + (10 * h / 12 + 0.5 * (1.5 + 3)) / c, 1e-9);
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

}  // namespace
}  // namespace planish::test
