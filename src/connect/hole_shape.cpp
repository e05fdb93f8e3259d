#include "hole_shape.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

// Holes with arcs as exact curves, which the pattern keeps: a circle, two half circles with sides
// between, or edges and arcs through three points. They run clockwise, as openings do. They carry
// no bends, so only checks see them as polygons.

namespace planish::connect_detail {
namespace {

using std::numbers::pi;

double azimuth(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// From a to b through a point between; a segment where they lie on one line.
Curve2 arc_through(const Vec2& a, const Vec2& m, const Vec2& b) {
  const Vec2 u = m - a, w = b - a;
  const double twice = 2.0 * cross(u, w);
  if (std::abs(twice) <= tolerance::kComputed * u.norm() * w.norm()) return Segment{a, b};
  const Vec2 from_a = (w.squaredNorm() * Vec2(-u.y(), u.x()) -
                       u.squaredNorm() * Vec2(-w.y(), w.x())) /
                      twice;
  const Vec2 centre = a + from_a;
  const double way = twice > 0.0 ? 1.0 : -1.0;
  double sweep = way * (azimuth(b - centre) - azimuth(a - centre));
  if (sweep <= 0.0) sweep += 2.0 * pi;
  return Arc{centre, from_a.norm(), azimuth(a - centre), way * sweep};
}

struct ToLoop {
  const Frame& plane;

  Vec2 flat(const Vec3& p) const { return plane.local2(p); }

  Loop operator()(const RoundHole& hole) const {
    return {Arc{flat(hole.at), hole.radius, 0.0, -2.0 * pi}};
  }

  Loop operator()(const SlotHole& hole) const {
    const Vec2 a = flat(hole.from), b = flat(hole.to);
    const double radius = 0.5 * hole.width, along = azimuth(b - a);
    const Vec2 aside = radius * Vec2(-std::sin(along), std::cos(along));
    return {Segment{a + aside, b + aside}, Arc{b, radius, along + 0.5 * pi, -pi},
            Segment{b - aside, a - aside}, Arc{a, radius, along - 0.5 * pi, -pi}};
  }

  Loop operator()(const ArcHole& hole) const {
    Loop loop;
    const std::size_t n = hole.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 a = flat(hole.corners[i]), b = flat(hole.corners[(i + 1) % n]);
      const bool round = i < hole.through.size() && hole.through[i];
      loop.push_back(round ? arc_through(a, flat(*hole.through[i]), b) : Curve2(Segment{a, b}));
    }
    return signed_area(loop) > 0.0 ? reversed(loop) : loop;
  }
};

}  // namespace

std::vector<Vec3> given_points(const HoleShape& shape) {
  if (const auto* hole = std::get_if<RoundHole>(&shape)) return {hole->at};
  if (const auto* slot = std::get_if<SlotHole>(&shape)) return {slot->from, slot->to};
  const auto& arcs = std::get<ArcHole>(shape);
  std::vector<Vec3> points = arcs.corners;
  for (const auto& through : arcs.through)
    if (through) points.push_back(*through);
  return points;
}

double smallest_size(const HoleShape& shape) {
  if (const auto* hole = std::get_if<RoundHole>(&shape)) return hole->radius;
  if (const auto* slot = std::get_if<SlotHole>(&shape))
    return std::min(slot->width, (slot->to - slot->from).norm());
  return std::numeric_limits<double>::infinity();
}

Loop hole_loop(const HoleShape& shape, const Frame& plane) {
  return std::visit(ToLoop{plane}, shape);
}

}  // namespace planish::connect_detail
