// Where a ring crosses itself: boxes of runs of edges, halved down to single ones, so that runs far
// apart along the ring are separated at once. Sides within rounding count as touching, not as
// crossing.

#include "planar.hpp"

#include <planish/geometry/region.hpp>

#include <optional>

// Where a ring of edges crosses itself. A binary tree of boxes over runs of neighbouring edges is
// walked against itself: neighbours along the ring lie together, so most far runs are parted at
// once. An edge crosses another if each has its ends on both sides of the other; what rounding
// decides is no crossing.

namespace planish {
namespace {

using namespace geometry_detail;

/// The side of the line through a and b on which c lies; 0 if rounding decides.
int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double noise = 4.0 * kEpsilon * (std::abs(left) + std::abs(right));
  if (left - right > noise) return 1;
  return left - right < -noise ? -1 : 0;
}

/// Boxes of runs of neighbouring edges, halved down to single edges. Neighbours lie together, so
/// most runs that are far apart along the ring are separated at once.
class Runs {
 public:
  explicit Runs(const std::vector<Vec2>& ring) : ring_(ring), boxes_(4 * ring.size()) {
    build(1, 0, ring.size());
  }

  /// Calls `visit(i, k)` for every two edges whose boxes touch, i < k, each by its first corner.
  template <typename Visit>
  void visit_pairs(const Visit& visit) const {
    within(1, 0, ring_.size(), visit);
  }
  const Vec2& corner(std::size_t i) const { return ring_[i < ring_.size() ? i : i - ring_.size()]; }

 private:
  void build(std::size_t node, std::size_t from, std::size_t to) {
    if (to - from == 1) {
      boxes_[node].add(corner(from));
      boxes_[node].add(corner(from + 1));
      return;
    }
    const std::size_t mid = (from + to) / 2;
    build(2 * node, from, mid);
    build(2 * node + 1, mid, to);
    boxes_[node] = boxes_[2 * node];
    boxes_[node].add(boxes_[2 * node + 1]);
  }

  template <typename Visit>
  void within(std::size_t node, std::size_t from, std::size_t to, const Visit& visit) const {
    if (to - from < 2) return;
    const std::size_t mid = (from + to) / 2;
    within(2 * node, from, mid, visit);
    within(2 * node + 1, mid, to, visit);
    between(2 * node, from, mid, 2 * node + 1, mid, to, visit);
  }

  template <typename Visit>
  void between(std::size_t a, std::size_t a0, std::size_t a1, std::size_t b, std::size_t b0,
               std::size_t b1, const Visit& visit) const {
    // The boxes of properly crossing edges share more than a side, unless an edge is upright or
    // level.
    if ((boxes_[a].lo.array() > boxes_[b].hi.array()).any()) return;
    if ((boxes_[b].lo.array() > boxes_[a].hi.array()).any()) return;
    if (a1 - a0 == 1 && b1 - b0 == 1) {
      visit(a0, b0);
    } else if (a1 - a0 >= b1 - b0) {
      const std::size_t mid = (a0 + a1) / 2;
      between(2 * a, a0, mid, b, b0, b1, visit);
      between(2 * a + 1, mid, a1, b, b0, b1, visit);
    } else {
      const std::size_t mid = (b0 + b1) / 2;
      between(a, a0, a1, 2 * b, b0, mid, visit);
      between(a, a0, a1, 2 * b + 1, mid, b1, visit);
    }
  }

  const std::vector<Vec2>& ring_;
  std::vector<Box2> boxes_;
};

/// Where the segments ab and cd cross, if each has its ends on both sides of the other.
std::optional<Vec2> proper_crossing(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (side(a, b, c) * side(a, b, d) >= 0 || side(c, d, a) * side(c, d, b) >= 0) return std::nullopt;
  const double t = cross(c - a, d - c) / cross(b - a, d - c);
  return Vec2(a + t * (b - a));
}

}  // namespace

std::vector<Vec2> self_crossings(const std::vector<Vec2>& ring) {
  if (ring.size() < 4) return {};
  const Runs runs(ring);
  std::vector<Vec2> found;
  runs.visit_pairs([&](std::size_t i, std::size_t k) {
    const auto crossing = proper_crossing(runs.corner(i), runs.corner(i + 1), runs.corner(k),
                                          runs.corner(k + 1));
    if (crossing) found.push_back(*crossing);
  });
  return found;
}

}  // namespace planish
