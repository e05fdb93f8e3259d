#pragma once

#include <planish/geometry/frame.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish::oracle {

struct Bounds {
  double low = 0.0, high = 0.0;
};

/// What a tangent line's height may be at a corner that is selected.
struct BoundedCorner {
  Vec2 at;
  Bounds height;
};

/// What is true of every tangent line that uses at least one edge on each side: the numbers that
/// make big M tight.
class LineBounds {
 public:
  /// Corners of both chains, x growing. Empty where no edge of a side admits a line.
  static std::optional<LineBounds> of(const std::array<std::vector<BoundedCorner>, 2>& sides);
  Bounds slope() const { return slope_; }
  Bounds height(double x) const;

 private:
  struct Edge {
    BoundedCorner left, right;
    Bounds slope() const;
    Bounds height(double x) const;
  };
  Bounds height(const Edge& edge, double x) const;

  std::array<std::vector<Edge>, 2> edges_;
  Bounds slope_;
};

}  // namespace planish::oracle
