#include "plane_piece.hpp"

#include <cmath>
#include <numbers>

namespace planish::transition_detail {
namespace {

using std::numbers::pi;

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

PlaneCurve ellipse(double rx, double ry, const Vec2& centre) {
  return [=](double t) -> PlanePoint {
    const double c = std::cos(t), s = std::sin(t);
    return {
        centre + Vec2(rx * c, ry * s), {-rx * s, ry * c}, {-rx * c, -ry * s}, {rx * s, -ry * c}};
  };
}

}  // namespace

PlanePiece straight(const Vec2& a, const Vec2& b, int source) {
  PlanePiece piece;
  piece.curve = [a, d = Vec2(b - a)](double t) -> PlanePoint {
    return {a + t * d, d, Vec2::Zero(), Vec2::Zero()};
  };
  piece.straight = true;
  piece.source = source;
  return piece;
}

PlaneCurve set_off(PlaneCurve curve, double d) {
  if (d == 0.0) return curve;
  return [curve = std::move(curve), d](double t) -> PlanePoint {
    const auto [c, first, second, third] = curve(t);
    const double speed = first.norm(), turning = cross2(first, second);
    const Vec2 tangent = first / speed, outward(tangent.y(), -tangent.x());
    const double rate = turning / (speed * speed);  // of the tangent's angle
    const double speed_rate = first.dot(second) / speed;
    const double rate_rate = cross2(first, third) / (speed * speed) -
                             2.0 * rate * speed_rate / speed;
    const double new_speed = speed + d * rate;
    return {c + d * outward, new_speed * tangent,
            (speed_rate + d * rate_rate) * tangent - new_speed * rate * outward, Vec2::Zero()};
  };
}

PlanePiece quarter(double rx, double ry, const Vec2& centre, double outwards, double from,
                   int source) {
  PlanePiece piece;
  const bool round = rx == ry;
  piece.curve = round ? ellipse(rx + outwards, rx + outwards, centre)
                      : set_off(ellipse(rx, ry, centre), outwards);
  piece.t0 = from;
  piece.t1 = from + 0.5 * pi;
  piece.source = source;
  piece.period = 2.0 * pi;
  if (round) {
    piece.circle_radius = rx + outwards;
    piece.circle_centre = centre;
  }
  return piece;
}

}  // namespace planish::transition_detail
