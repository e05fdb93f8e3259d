#pragma once

#include <planish/geometry/curve.hpp>

#include <optional>
#include <vector>

namespace planish::sheet_detail {

/// Finds the curve nearest to a point without visiting all of them, by a grid of squares, each
/// listing the curves whose boxes touch it.
class CurveIndex {
 public:
  explicit CurveIndex(std::vector<Curve2> curves);

  struct Hit {
    int curve = 0;
    Vec2 point = Vec2::Zero();
    double distance = 0.0;
  };
  /// The nearest point on any curve; empty without curves.
  std::optional<Hit> nearest(const Vec2& p) const;

 private:
  std::vector<int>& cell(int column, int row) { return cells_[row * columns_ + column]; }
  int column_of(double x) const;
  int row_of(double y) const;
  void look_in_ring(const Vec2& p, int ring, std::optional<Hit>& best) const;

  std::vector<Curve2> curves_;
  std::vector<Box2> boxes_;
  Box2 box_;
  double side_ = 1.0;  ///< of a square
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;
};

}  // namespace planish::sheet_detail
