#include "check.hpp"

#include "brake/right_angles.hpp"
#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Limits in closed form, derived in the plane. Everywhere: all bends turn by 90°, so both sides of
// the pressed one rise to 45° in the end; r inside radius, T thickness, ε the 0.05 mm that may be
// penetrated, s = sin 45°. The machine's origin is the lowest point of the inside skin.
//
// A side starts at its tangent point (r s, r (1 − s)), and what lies `a` beyond the tangent point
// along the inside skin and `h` above it comes to
//   y = r s + s a − s h,  z = r (1 − s) + s a + s h                                           (1)

namespace planish::test {
namespace {

constexpr double kEpsilon = 0.05;  // mm that may be penetrated (MATH of the press brake)

Turn up(double radius) { return {Angle::degrees(90), radius, BendDirection::up}; }
Turn down(double radius) { return {Angle::degrees(90), radius, BendDirection::down}; }

/// leg | web | second leg, both bends up.
struct U {
  double leg = 30.0, web = 60.0, second = 40.0, radius = 2.0, thickness = 1.5, width = 80.0;
  Sheet sheet() const {
    return strip({Straight{leg}, up(radius), Straight{web}, up(radius), Straight{second}}, width,
                 thickness);
  }
};

/// The punch is 2 b wide. While the second bend closes, the top of the first leg swings in: its
/// inner corner lies a = web + r beyond the tangent point and h = r + leg above the skin, and comes
/// to y = r s + s (web + r) − s (r + leg). It may be ε deep in the punch: y ≥ b − ε, so
///   leg ≤ web + r − (b − ε) / s.
TEST(ClosedForms, LongestLegOfAUThatAStraightPunchCloses) {
  for (const double b : {6.0, 10.0, 14.0})
    for (const double radius : {1.0, 3.0}) {
      U u;
      u.radius = radius;
      const double longest = u.web + radius - (b - kEpsilon) / kSin45;
      for (const double step : {-kStep, kStep}) {
        u.leg = longest + step;
        PlainPunch plain;
        plain.half_width = b;
        Room room(u.sheet(), plain_tools(plain));
        EXPECT_EQ(room.can_press(2, {1}), step < 0.0) << b << " " << radius << " " << step;
        // The other order: the second leg is short.
        EXPECT_TRUE(room.can_press(1, {2}));
        EXPECT_TRUE(room.can_press(1, {}));
        EXPECT_TRUE(room.can_press(2, {}));
      }
    }
}

/// Springback σ turns further: with h = 45° + σ/2, ρ = BA/(90° + σ) and r' = ρ − K T the corner
/// comes to y = r' sin h + cos h (web + r) − sin h (r + leg).
TEST(ClosedForms, SpringbackShortensTheLeg) {
  const double spring = 4.0, b = 10.0, k = 0.44;
  U u;
  const double alpha = std::numbers::pi / 2.0, turn = alpha + spring * std::numbers::pi / 180.0;
  const double bent = alpha * (u.radius + k * u.thickness) / turn - k * u.thickness;
  const double h = 0.5 * turn;
  const double longest = (bent * std::sin(h) + std::cos(h) * (u.web + u.radius) - (b - kEpsilon)) /
                             std::sin(h) -
                         u.radius;
  PlanOptions options;
  options.springback = Angle::degrees(spring);
  for (const double step : {-kStep, kStep}) {
    u.leg = longest + step;
    Room room(u.sheet(), plain_tools(), options);
    EXPECT_EQ(room.can_press(2, {1}), step < 0.0) << step;
  }
}

/// A clearance c keeps the corner of the leg at y ≥ b + c: leg ≤ web + r − (b + c) / s.
TEST(ClosedForms, ClearanceShortensTheLeg) {
  const double b = 10.0, clearance = 2.5;
  PlanOptions options;
  options.clearance = clearance;
  U u;
  for (const double step : {-kStep, kStep}) {
    u.leg = u.web + u.radius - (b + clearance) / kSin45 + step;
    Room room(u.sheet(), plain_tools(), options);
    EXPECT_EQ(room.can_press(2, {1}), step < 0.0) << step;
  }
}

/// The outer corner of the first leg, a = web + r + T, h = r + leg, rises to
/// z = r (1 − s) + s (a + h), at most ε into the beam that hangs at Z above the tip. Rounded, the
/// tip and the beam are lower by t (1 / sin(A/2) − 1).
TEST(ClosedForms, DeepestChannelBelowTheUpperBeam) {
  PlainPunch plain;
  plain.height = 100.0;
  BrakeTools tools = plain_tools(plain);
  tools.machine.upper_beam = {{-200, 100}, {200, 100}, {200, 300}, {-200, 300}};
  const double lower = plain.tip_radius / std::sin(0.5 * plain.angle.radians()) - plain.tip_radius;
  U u;
  u.web = 90.0;
  const double beam = 100.0 - lower;
  const double longest = (beam + kEpsilon - u.radius * (1.0 - kSin45)) / kSin45 -
                         (u.web + u.radius + u.thickness) - u.radius;
  for (const double step : {-kStep, kStep}) {
    u.leg = longest + step;
    Room room(u.sheet(), tools);
    EXPECT_EQ(room.can_press(2, {1}), step < 0.0) << step;
  }
}

/// Z: the first bend goes down, so the sheet is turned over and the first flange hangs beside the
/// die, B wide on each side. At the start the die's corner is at (B, −T), and the inside of the
/// formed bend an arc about (BA/2 + web, −T − r) in which the corner pokes; later the flange turns
/// away. The point of the arc at the angle φ from the vertical is r (1 − cos φ) below the die's top
/// and B − BA/2 − web − r sin φ inside its flank: nothing is deeper than ε if the second is at
/// most ε where the first is, so web ≥ B − ε − BA/2 − √(2 r ε − ε²).
double narrowest_beside_die(double half, double radius, double t, double k) {
  const double half_zone = 0.25 * std::numbers::pi * (radius + k * t);
  return half - kEpsilon - half_zone - std::sqrt(2.0 * radius * kEpsilon - kEpsilon * kEpsilon);
}

TEST(ClosedForms, NarrowestWebOfAZBesideTheDie) {
  const double t = 1.0, half = 18.0;
  PlainDie lower;
  lower.half_width = half;
  lower.opening = 6.0;
  lower.shoulder_radius = 1.0;
  for (const double radius : {1.0, 2.0})
    for (const double step : {-kStep, kStep}) {
      const double web = narrowest_beside_die(half, radius, t, 0.44) + step;
      Room room(strip({Straight{30}, down(radius), Straight{web}, up(radius), Straight{40}}, 50, t),
                plain_tools({}, lower));
      EXPECT_EQ(room.can_press(2, {1}), step > 0.0) << step;
      EXPECT_EQ(room.can_press(1, {2}), step > 0.0) << step;
      EXPECT_TRUE(room.can_press(1, {}));
    }
}

/// Hat: brim | up | side | down | top | down | side | up | brim. With the brims bent up first, the
/// top's bends are pressed with the sheet turned over; the brim hangs down beside the die as the
/// flange of the Z does.
TEST(ClosedForms, LowestSideOfAHatBesideTheDie) {
  const double radius = 1.0, t = 1.0, half = 18.0;
  PlainDie lower;
  lower.half_width = half;
  lower.opening = 6.0;
  lower.shoulder_radius = 1.0;
  for (const double step : {-kStep, kStep}) {
    const double side = narrowest_beside_die(half, radius, t, 0.44) + step;
    const Sheet sheet = strip({Straight{20}, up(radius), Straight{side}, down(radius), Straight{80},
                               down(radius), Straight{side}, up(radius), Straight{20}},
                              50, t);
    Room room(sheet, plain_tools({}, lower));
    EXPECT_EQ(room.can_press(2, {1, 4}), step > 0.0) << step;
    EXPECT_EQ(room.can_press(3, {1, 2, 4}), step > 0.0) << step;
  }
}

/// C with lips (the section of a box with return flanges): lip | leg | web | leg | lip. When the
/// last web bend closes, the lip of the other leg points back over the punch. Its upper corner lies
/// a = web − lip beyond the tangent point (the lip begins where the leg's bend ends, one radius
/// in from the leg's face) and h = 2 r + leg + T above the skin: r + a − h ≥ (b − ε) / s.
TEST(ClosedForms, LongestReturnFlangeThatAStraightPunchPasses) {
  const double b = 8.0, radius = 1.5, t = 1.5, web = 90.0, leg = 30.0;
  PlainPunch plain;
  plain.half_width = b;
  const double longest = radius + web - (2.0 * radius + leg + t) - (b - kEpsilon) / kSin45;
  ASSERT_GT(longest, 20.0);
  for (const double step : {-kStep, kStep}) {
    const Sheet sheet = strip({Straight{longest + step}, up(radius), Straight{leg}, up(radius),
                               Straight{web}, up(radius), Straight{40}, up(radius), Straight{12}},
                              60, t);
    PlainDie lower;
    lower.opening = 9.0;
    Room room(sheet, plain_tools(plain, lower));
    EXPECT_EQ(room.can_press(3, {1, 2, 4}), step < 0.0) << step;
  }
}

/// A V is deep enough if the outside of the bend does not reach its bottom. The lowest point lies
/// T below the inside skin; the die's top is at D = q + r − (r + T + q) / s + W, so the bend is
/// T + D below it. A flat bottom at depth P takes P ≥ T + D − ε.
TEST(ClosedForms, ShallowestVThatTakesTheBend) {
  const double radius = 2.0, t = 2.0, q = 1.5, v = 8.0;
  const double angle = 80.0 * std::numbers::pi / 180.0;
  const double reach = v + q / std::tan(std::numbers::pi / 4 + angle / 4.0);
  const double depth = t + q + radius - (radius + t + q) / kSin45 + reach;
  ASSERT_GT(depth, 4.0);
  for (const double step : {-kStep, kStep}) {
    BrakeTools tools = plain_tools();
    const double bottom = depth - kEpsilon + step, in = v - bottom * std::tan(0.5 * angle);
    tools.dies[0].opening = 2.0 * v;
    tools.dies[0].shoulder_radius = q;
    tools.dies[0].profile = {{-v, 0}, {-30, 0}, {-30, -100},   {30, -100},
                             {30, 0}, {v, 0},   {in, -bottom}, {-in, -bottom}};
    Room room(strip({Straight{60}, up(radius), Straight{60}}, 50, t), tools);
    EXPECT_EQ(room.can_press(1, {}), step > 0.0) << step;
  }
}

}  // namespace
}  // namespace planish::test
