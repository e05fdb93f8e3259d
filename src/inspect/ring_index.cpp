// Edges of rings in a tree of boxes: winding numbers and the first hit of a ray without a look at
// every edge. Each edge holds its lower end alone, so that a ray through a corner counts it once.

#include "ring_index.hpp"

#include <planish/geometry/plane.hpp>

// Points and rays against many rings by a tree of their edges. The winding number counts edges that
// a ray to one side crosses, up or down, half-open in y, so that a corner counts once; a ray's
// first hit is sought only as far as it reaches.

namespace planish::inspect_detail {
RingIndex::RingIndex(const std::vector<std::vector<Vec2>>& rings)
    : edges_(edges_of(rings)), index_(boxes_of(edges_)) {}

std::vector<RingIndex::Edge> RingIndex::edges_of(const std::vector<std::vector<Vec2>>& rings) {
  std::vector<Edge> edges;
  for (size_t r = 0; r < rings.size(); ++r)
    for (const auto& [a, b] : sides_of(rings[r]))
      edges.push_back({a, b, r});
  return edges;
}

std::vector<Box2> RingIndex::boxes_of(const std::vector<Edge>& edges) {
  return mapped(edges, [](const Edge& edge) { return box_of({edge.a, edge.b}); });
}

int RingIndex::winding(const Vec2& p) const {
  const Box2 ray{p, {std::numeric_limits<double>::infinity(), p.y()}};
  int turns = 0;
  index_.visit(ray, [&](size_t id) {
    const Vec2& a = edges_[id].a;
    const Vec2& b = edges_[id].b;
    // Each edge includes only its lower end, so that a corner on the ray counts once.
    const bool rises = b.y() > p.y();
    if ((a.y() > p.y()) == rises) return;
    const double side = cross(b - a, p - a);
    if (side != 0.0 && (side > 0.0) == rises) turns += rises ? 1 : -1;
  });
  return turns;
}

bool RingIndex::odd(const Vec2& p) const { return winding(p) % 2 != 0; }

bool RingIndex::clear(const Vec2& p, double distance) const {
  bool result = true;
  index_.visit(widened({p, p}, distance), [&](size_t id) {
    const Curve2 edge = Segment{edges_[id].a, edges_[id].b};
    if (result && nearest(edge, p).distance < distance) result = false;
  });
  return result;
}

Box2 RingIndex::ray_box(const Vec2& origin, const Vec2& direction, double reach) {
  return box_of({origin, origin + reach * direction});
}

std::optional<double> RingIndex::hit(const Edge& edge, const Vec2& origin, const Vec2& direction) {
  const double side_a = cross(direction, edge.a - origin);
  const double side_b = cross(direction, edge.b - origin);
  if ((side_a > 0.0) == (side_b > 0.0)) return std::nullopt;
  const double share = side_a / (side_a - side_b);
  const double s = (edge.a + share * (edge.b - edge.a) - origin).dot(direction);
  if (s < 0.0) return std::nullopt;
  return s;
}

}  // namespace planish::inspect_detail
