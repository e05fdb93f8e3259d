// Areas, insides and the smallest rectangle of rings. A smallest rectangle has a side on an edge of
// the convex hull: three calipers advance as the edges turn, once around (O(n) after the hull).

#include "planar.hpp"

#include <planish/geometry/region.hpp>

#include <numbers>

// Rings of points: area about a corner (far from the origin the products would swamp it), inside by
// the parity of crossings, so that overlapping rings need no order, and the smallest rectangle, one
// of whose sides lies along an edge of the convex hull (Andrew's chains).

namespace planish {
namespace {
using namespace geometry_detail;
using std::numbers::pi;
}  // namespace

Polygon polygon_of(const Region& region, double chord) {
  Polygon polygon;
  polygon.outer = sampled(region.outer, chord);
  for (const Loop& opening : region.openings)
    polygon.holes.push_back(sampled(opening, chord));
  return polygon;
}

double ring_area(const std::vector<Vec2>& ring) {
  if (ring.empty()) return 0.0;
  // About the first corner: far from the origin, rounding of the products would swamp a small area.
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  }
  return 0.5 * twice;
}

bool inside(const std::vector<std::vector<Vec2>>& rings, const Vec2& p) {
  bool in = false;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if ((cross(b - a, p - a) > 0.0) == (b.y() > a.y())) in = !in;
    }
  }
  return in;
}

namespace {

EnclosingRectangle rectangle(double along, double across, const Vec2& direction) {
  const Vec2 long_side = along >= across ? direction : perpendicular(direction);
  double angle = angle_of(long_side);
  if (angle > pi / 2.0) angle -= pi;
  if (angle <= -pi / 2.0) angle += pi;
  return {{std::max(along, across), std::min(along, across)}, angle};
}

}  // namespace

EnclosingRectangle smallest_rectangle(const std::vector<Vec2>& points) {
  const std::vector<Vec2> hull = hull_of(points);
  const std::size_t n = hull.size();
  if (n < 2) return {Vec2::Zero(), 0.0};
  if (n == 2)
    return rectangle((hull[1] - hull[0]).norm(), 0.0, (hull[1] - hull[0]).stableNormalized());

  // A smallest rectangle has a side on an edge of the hull. The three corners farthest ahead,
  // across and behind only advance as the edges turn.
  EnclosingRectangle best;
  double smallest = std::numeric_limits<double>::infinity();
  std::size_t ahead = 1;
  std::size_t across = 1;
  std::size_t behind = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 u = (hull[(i + 1) % n] - hull[i]).stableNormalized();
    const Vec2 v = perpendicular(u);
    const auto advance = [&](std::size_t& corner, const Vec2& direction) {
      for (std::size_t steps = 0; steps < n; ++steps) {
        const Vec2 step = hull[(corner + 1) % n] - hull[corner % n];
        if (!(direction.dot(step) > 0.0)) break;
        ++corner;
      }
    };
    ahead = std::max(ahead, i + 1);
    advance(ahead, u);
    across = std::max(across, ahead);
    advance(across, v);
    behind = std::max(behind, across);
    advance(behind, -u);
    const double width = u.dot(hull[ahead % n] - hull[behind % n]);
    const double height = v.dot(hull[across % n] - hull[i]);
    if (width * height < smallest) {
      smallest = width * height;
      best = rectangle(width, height, u);
    }
  }
  return best;
}

}  // namespace planish
