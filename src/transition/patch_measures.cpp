// Turn, radii and lengths of a patch, sampled over its rulings: the normal's turn by the long way
// round if it turns that far, the smallest radius at mid-length and at the tighter end.

#include "integral.hpp"
#include "ruled_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Area, turn and radii of a patch between two rulings, by integrals along u. The turn adds up steps
// of less than half a turn about the normals' common axis, as an angle between two normals alone
// cannot tell more. On cones the radius grows with the distance from the apex, which tells where a
// tip becomes too sharp.

namespace planish::transition_detail {

double RuledPatch::area(double from, double to) const {
  if (hull_patch_.plane) {
    const auto [p0, q0] = ruling(from);
    const auto [p1, q1] = ruling(to);
    return 0.5 * (q1 - p0).cross(q0 - p1).norm();
  }
  return integral_over(
      [&](double at) {
        const Local l = local(at);
        return 0.5 * l.length * (l.across + l.far_across);
      },
      breaks_between(from, to));
}

double RuledPatch::border_length(int side, double from, double to) const {
  if (!hull_patch_.sides[side].moves()) return 0.0;
  if (hull_patch_.plane) return (ruling(to)[side] - ruling(from)[side]).norm();
  const auto s = static_cast<std::size_t>(side);
  return arc_length(*curves_[s], pairing(from).t[s], pairing(to).t[s]);
}

double RuledPatch::turn(double from, double to) const {
  return hull_patch_.plane || from == to
             ? 0.0
             : integral_over([&](double at) { return local(at).turn_rate; },
                             breaks_between(from, to));
}

double RuledPatch::turned(double from, double to) const {
  const Vec3 a = normal(from), b = normal(to);
  const double between = angle_between(a, b);
  // How far the normals turn about their common axis, in steps of less than half a turn.
  constexpr int kSteps = 16;
  std::vector<Vec3> normals;
  Vec3 axis = Vec3::Zero();
  for (int i = 0; i <= kSteps; ++i) {
    normals.push_back(normal(std::lerp(from, to, i / double(kSteps))));
    if (i > 0) axis += normals[static_cast<std::size_t>(i) - 1].cross(normals.back());
  }
  axis.normalize();
  double round = 0.0;
  for (std::size_t i = 1; i < normals.size(); ++i) {
    const Vec3 p = normals[i - 1] - axis.dot(normals[i - 1]) * axis,
               q = normals[i] - axis.dot(normals[i]) * axis;
    round += std::atan2(axis.dot(p.cross(q)), p.dot(q));
  }
  return round > std::numbers::pi ? 2.0 * std::numbers::pi - between : between;
}

RuledPatch::Radii RuledPatch::smallest_radii(double from, double to) const {
  constexpr int kSamples = 64;
  Radii radii{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const bool apex = !hull_patch_.sides[0].moves() || !hull_patch_.sides[1].moves();
  for (int i = 0; i <= kSamples; ++i) {
    const Local l = local(std::lerp(from, to, i / double(kSamples)));
    if (l.turn_rate == 0.0) continue;
    const auto [tight, wide] = std::minmax(l.across, l.far_across);
    radii.middle = std::min(radii.middle, 0.5 * (tight + wide) / l.turn_rate);
    radii.end = std::min(radii.end, (apex ? wide : tight) / l.turn_rate);
  }
  return radii;
}

double RuledPatch::distance_of_radius(double radius) const {
  // On cones the radius grows with the distance from the apex.
  constexpr int kSamples = 64;
  double distance = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const Local l = local(i / double(kSamples));
    distance = std::max(distance,
                        radius * l.turn_rate * l.length / std::max(l.across, l.far_across));
  }
  return distance;
}

double RuledPatch::tip_area(double from, double to, const Tips& tips) const {
  double area = 0.0;
  if (hull_patch_.plane) {
    for (const PanelCorner& corner : panel_corners(from, to, tips))
      area += 0.5 * (corner.cut_before - corner.at).cross(corner.cut_after - corner.at).norm();
    return area;
  }
  for (std::size_t side = 0; side < 2; ++side)
    if (const double cut = tips.at_from[side]; cut > 0.0 && stands(static_cast<int>(side)))
      area += 0.5 * cut * cut *
              integral(
                  [&](double at) {
                    const Local l = local(at);
                    return std::max(l.across, l.far_across) / l.length;
                  },
                  from, to);
  return area;
}

}  // namespace planish::transition_detail
