#pragma once

#include <planish/geometry/frame.hpp>

#include <vector>

namespace planish::transition_detail {

/// A point of a plane curve with its first three derivatives.
struct PlanePoint {
  Vec2 point, first, second, third;
};

/// The closed C² cubic spline through points, its parameter the chords' lengths; periodic.
class PeriodicSpline {
 public:
  /// Requires: at least three points, neighbours apart.
  explicit PeriodicSpline(std::vector<Vec2> points);
  PlanePoint operator()(double t) const;
  /// Where its spans meet: 0 … period.
  const std::vector<double>& knots() const { return knots_; }

 private:
  std::vector<Vec2> points_, moments_;  // moments: second derivatives at the points
  std::vector<double> knots_;
};

}  // namespace planish::transition_detail
