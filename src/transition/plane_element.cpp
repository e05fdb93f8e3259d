#include "plane_element.hpp"

#include <planish/geometry/plane.hpp>

#include <cmath>
#include <numbers>

// Pieces of a profile as curves with three derivatives: lines, quarters of ellipses, and curves set
// off outwards (math.md#neutral-profiles). An offset moves along the normal, n = (t_y, −t_x), so
// its speed grows by d times the rate of the tangent's angle, and its second derivative follows
// from the curve's third, exactly. Circles stay circles, which solids and closed forms rely on.

namespace planish::transition_detail {
namespace {

using std::numbers::pi;

PlaneCurve ellipse(double rx, double ry, const Vec2& centre) {
  return [=](double t) -> PlanePoint {
    const double c = std::cos(t), s = std::sin(t);
    return {
        centre + Vec2(rx * c, ry * s), {-rx * s, ry * c}, {-rx * c, -ry * s}, {rx * s, -ry * c}};
  };
}

}  // namespace

PlaneElement straight(const Vec2& a, const Vec2& b, int source) {
  PlaneElement plane_element;
  plane_element.curve = [a, d = Vec2(b - a)](double t) -> PlanePoint {
    return {a + t * d, d, Vec2::Zero(), Vec2::Zero()};
  };
  plane_element.straight = true;
  plane_element.source = source;
  return plane_element;
}

PlaneElement standing(const Vec2& point) {
  PlaneElement plane_element;
  plane_element.curve = [point](double) -> PlanePoint {
    return {point, Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  };
  plane_element.corners = {{0, 0, 0.0}};
  return plane_element;
}

PlaneCurve set_off(PlaneCurve curve, double d) {
  if (d == 0.0) return curve;
  return [curve = std::move(curve), d](double t) -> PlanePoint {
    const auto [c, first, second, third] = curve(t);
    const double speed = first.norm(), turning = cross(first, second);
    const Vec2 tangent = first / speed, outward(tangent.y(), -tangent.x());
    const double rate = turning / (speed * speed);  // of the tangent's angle
    const double speed_rate = first.dot(second) / speed;
    const double rate_rate = cross(first, third) / (speed * speed) -
                             2.0 * rate * speed_rate / speed;
    const double new_speed = speed + d * rate;
    return {c + d * outward, new_speed * tangent,
            (speed_rate + d * rate_rate) * tangent - new_speed * rate * outward, Vec2::Zero()};
  };
}

PlaneElement quarter(double rx, double ry, const Vec2& centre, double outwards, double from,
                     int source) {
  PlaneElement plane_element;
  const bool round = rx == ry;
  plane_element.curve = round ? ellipse(rx + outwards, rx + outwards, centre)
                              : set_off(ellipse(rx, ry, centre), outwards);
  plane_element.t0 = from;
  plane_element.t1 = from + 0.5 * pi;
  plane_element.source = source;
  plane_element.period = 2.0 * pi;
  if (round) {
    plane_element.circle_radius = rx + outwards;
    plane_element.circle_centre = centre;
  }
  return plane_element;
}

}  // namespace planish::transition_detail
