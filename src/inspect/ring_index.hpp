#pragma once

#include <planish/geometry/box_tree.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace planish::inspect_detail {

/// Closed polygons, indexed for queries with points and rays. Ring i is the i-th given.
class RingIndex {
 public:
  explicit RingIndex(const std::vector<std::vector<Vec2>>& rings);

  /// Whether an odd number of rings surrounds p: material, if the rings are a pattern's contours.
  bool odd(const Vec2& p) const;
  /// How often the rings turn about p, counter-clockwise positive.
  int winding(const Vec2& p) const;
  /// Whether p is at least `distance` from every edge.
  bool clear(const Vec2& p, double distance) const;
  /// Distance from `origin` along the unit vector `direction` to the first edge within `reach` of a
  /// ring that `counts`; infinite without one.
  template <typename Counts>
  double first_hit(const Vec2& origin, const Vec2& direction, double reach, Counts&& counts) const {
    double nearest = std::numeric_limits<double>::infinity();
    index_.visit(ray_box(origin, direction, reach), [&](size_t id) {
      if (!counts(edges_[id].ring)) return;
      if (const auto s = hit(edges_[id], origin, direction); s && *s <= reach)
        nearest = std::min(nearest, *s);
    });
    return nearest;
  }

 private:
  struct Edge {
    Vec2 a, b;
    size_t ring;
  };
  static std::vector<Edge> edges_of(const std::vector<std::vector<Vec2>>& rings);
  static std::vector<Box2> boxes_of(const std::vector<Edge>& edges);
  static Box2 ray_box(const Vec2& origin, const Vec2& direction, double reach);
  static std::optional<double> hit(const Edge& edge, const Vec2& origin, const Vec2& direction);

  std::vector<Edge> edges_;
  BoxTree2 index_;
};

}  // namespace planish::inspect_detail
