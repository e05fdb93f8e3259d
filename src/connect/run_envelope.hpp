#pragma once

#include <planish/geometry/frame.hpp>

#include <vector>

namespace planish::connect_detail {

/// Finds, for any range of corners of a chain (x growing) and any slope k, the extreme corner in
/// the direction (k, −1): a segment tree of convex hulls. O(n log n) to build, O(log² n) per query.
class RunEnvelope {
 public:
  explicit RunEnvelope(std::vector<Vec2> corners);

  const std::vector<Vec2>& corners() const { return corners_; }
  /// Corner of [first, last] with the largest k·x − y.
  const Vec2& lowest(int first, int last, double k) const {
    return extreme(lower_, first, last, k, 1.0);
  }
  /// Corner of [first, last] with the largest y − k·x.
  const Vec2& highest(int first, int last, double k) const {
    return extreme(upper_, first, last, k, -1.0);
  }

 private:
  // Hulls of aligned blocks of 2^level corners, by level; corners of a hull by row, x growing.
  using Hulls = std::vector<std::vector<int>>;
  struct Level {
    std::vector<int> corners, starts;  // hull b: corners[starts[b] … starts[b + 1])
  };
  void add_levels(std::vector<Level>& levels, double sign) const;
  const Vec2& extreme(const std::vector<Level>& levels, int first, int last, double k,
                      double sign) const;

  std::vector<Vec2> corners_;
  std::vector<Level> lower_, upper_;
};

}  // namespace planish::connect_detail
