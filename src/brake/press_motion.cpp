// How the sheet moves in a stroke of air bending: both sides rise by half the turn about an arc
// whose length stays the allowance, and the die follows so that its shoulders touch the outside.
// Written with sin(x)/x and (1 − cos)/θ, which have limits at θ = 0. What must hold: the speeds
// bound all derivatives up to the turn (math.md#stroke, math.md#stroke-clearance).
#include "press_motion.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

/// radians: an arc so short is straight, and its radius beyond what doubles subtract.
constexpr double kStraight = tolerance::kComputed;

/// sin(x)/x.
double sinc(double x) {
  constexpr double kSeries = 1e-4;  // below, x⁴/120 is less than rounding
  return std::abs(x) < kSeries ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

/// (1 − cos(θ/2)) / θ.
double versine_share(double turn) {
  const double quarter = 0.25 * turn;
  return 0.5 * std::sin(quarter) * sinc(quarter);
}

}  // namespace

double PressMotion::inside_radius(double turn) const {
  return std::max(0.0, bend_.allowance / turn - bend_.neutral);
}

/// The end of the bend on the inside skin: r (sin h, 1 − cos h) with h = θ/2, which has a limit as
/// r grows towards θ = 0.
Vec2 PressMotion::side_start(double turn) const {
  const double h = 0.5 * turn;
  if (bend_.allowance <= bend_.neutral * turn) return Vec2::Zero();
  return {0.5 * bend_.allowance * sinc(h) - bend_.neutral * std::sin(h),
          bend_.allowance * versine_share(turn) - bend_.neutral * (1.0 - std::cos(h))};
}

Convex PressMotion::side(const Convex& points, double turn) const {
  const Vec2 start = side_start(turn);
  const double c = std::cos(0.5 * turn), s = std::sin(0.5 * turn);
  Convex result = points;
  for (Vec2& p : result) {
    const double along = p.x() - 0.5 * bend_.allowance, up = p.y();
    p = {start.x() + c * along - s * up, start.y() + s * along + c * up};
  }
  return result;
}

Convex PressMotion::arc(double from, double to, double turn) const {
  const double per_length = bend_.allowance > 0.0 ? turn / bend_.allowance : 0.0;
  Convex corners;
  for (const double at : {from, to})
    for (const double depth : {0.0, bend_.thickness}) {
      const double angle = at * per_length;
      const bool flat = angle < kStraight;
      const double r = turn > 0.0 ? inside_radius(turn) : 0.0;
      const double half = std::sin(0.5 * angle);
      corners.push_back(flat ? Vec2(at, -depth)
                             : Vec2((r + depth) * std::sin(angle),
                                    2.0 * r * half * half - depth * std::cos(angle)));
    }
  return hull_of(corners);
}

/// r (1 − 1/cos h): how much lower than the inside skin's lowest point both sides, prolonged, meet.
double PressMotion::drop(double turn) const {
  if (bend_.allowance <= bend_.neutral * turn) return 0.0;
  const double h = 0.5 * turn;
  return -(bend_.allowance * versine_share(turn) - bend_.neutral * (1.0 - std::cos(h))) /
         std::cos(h);
}

/// The outside of a side is the line through the outer end of the bend at the slope h; the
/// shoulder's circle touches it from below: cos h (height of the centre − where the inside skins,
/// prolonged, meet) = across · sin h − T − radius.
double PressMotion::die_height(double turn) const {
  const double h = 0.5 * turn;
  return drop(turn) - shoulder_.height +
         (shoulder_.across * std::sin(h) - bend_.thickness - shoulder_.radius) / std::cos(h);
}

double PressMotion::contact(double turn) const {
  const double h = 0.5 * turn, r_sin = side_start(turn).x();
  const double out = r_sin + (bend_.thickness + shoulder_.radius) * std::sin(h);
  return 0.5 * bend_.allowance + (shoulder_.across - out) / std::cos(h);
}

/// |d/dθ| of the side's start: its parts are BA/2·sinc(h), BA·(1 − cos h)/θ and K·T (sin h,
/// 1 − cos h), with |sinc′| ≤ h/3 and |((1 − cos h)/θ)′| ≤ 1/8.
double PressMotion::side_speed(const Convex& points, double turn) const {
  double farthest = 0.0;
  for (const Vec2& p : points)
    farthest = std::max(farthest, (p - Vec2(0.5 * bend_.allowance, 0.0)).norm());
  const double h = 0.5 * turn;
  return 0.5 * farthest + bend_.allowance * (h / 12.0 + 0.125) + bend_.neutral;
}

/// On the neutral arc of curvature κ = θ/BA a point at the length w moves by at most w²/2 + w³κ/3
/// for a unit of κ; w ≤ BA/2. The skins besides turn about it, by at most half of θ. An arc held
/// at radius 0 only turns.
double PressMotion::arc_speed(double turn) const {
  return bend_.allowance * (0.125 + turn / 24.0) + bend_.thickness;
}

/// Derivatives of the terms of `die_height`; each grows with θ, so the last turn bounds all.
double PressMotion::die_speed(double turn) const {
  const double h = 0.5 * turn, c = std::cos(h), t = std::tan(h);
  const double secant = t / (2.0 * c);  // of 1/cos h
  const double arc = bend_.allowance * (0.125 / c + 0.25 * h * secant);
  const double skin = bend_.neutral * (0.5 * std::sin(h) / c + (1.0 - c) * secant);
  const double plane = std::abs(shoulder_.across) / (2.0 * c * c) +
                       (bend_.thickness + shoulder_.radius) * secant;
  return arc + skin + plane;
}

double PressMotion::contact_speed(double turn) const {
  const double h = 0.5 * turn, c = std::cos(h), secant = std::tan(h) / (2.0 * c);
  const double outer = bend_.thickness + shoulder_.radius;
  return secant * (std::abs(shoulder_.across) + 0.5 * bend_.allowance + bend_.neutral + outer) +
         (bend_.allowance * h / 12.0 + 0.5 * (bend_.neutral + outer)) / c;
}

}  // namespace planish::brake_detail
