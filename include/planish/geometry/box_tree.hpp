#pragma once

#include <planish/geometry/curve.hpp>

#include <cstddef>
#include <vector>

namespace planish {

/// A tree of boxes that finds those near a place without visiting the rest: O(n log n) to make,
/// O(log n) and what is found to ask. Ids are indices in the given list; empty boxes are never
/// found.
class BoxTree2 {
 public:
  explicit BoxTree2(std::vector<Box2> boxes);

  /// Calls `found(id)` for every box that meets or touches `query`, in no particular order.
  template <typename Found>
  void visit(const Box2& query, Found&& found) const {
    if (!nodes_.empty() && !query.empty()) visit_node(0, 0, ids_.size(), query, found);
  }

 private:
  static constexpr size_t kLeaf = 6;
  static bool touch(const Box2& a, const Box2& b) {
    return a.lo.x() <= b.hi.x() && b.lo.x() <= a.hi.x() && a.lo.y() <= b.hi.y() &&
           b.lo.y() <= a.hi.y();
  }
  void build(size_t node, size_t from, size_t to);

  /// Node `node` holds ids_[from … to); its halves are nodes 2·node + 1 and 2·node + 2.
  template <typename Found>
  void visit_node(size_t node, size_t from, size_t to, const Box2& query, Found& found) const {
    if (!touch(nodes_[node], query)) return;
    if (to - from <= kLeaf) {
      for (size_t i = from; i < to; ++i)
        if (touch(boxes_[ids_[i]], query)) found(ids_[i]);
      return;
    }
    const size_t middle = from + (to - from) / 2;
    visit_node(2 * node + 1, from, middle, query, found);
    visit_node(2 * node + 2, middle, to, query, found);
  }

  std::vector<Box2> boxes_;
  std::vector<size_t> ids_;
  std::vector<Box2> nodes_;
};

/// The box of points within `reach` of `box`.
inline Box2 widened(Box2 box, double reach) {
  box.lo.array() -= reach;
  box.hi.array() += reach;
  return box;
}

/// The smallest distance between points of two boxes.
inline double box_distance(const Box2& a, const Box2& b) {
  const Vec2 apart = (a.lo - b.hi).cwiseMax(b.lo - a.hi).cwiseMax(Vec2::Zero());
  return apart.norm();
}

}  // namespace planish
