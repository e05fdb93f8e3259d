#include "connect_oracle/line_bounds.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace planish::oracle {
namespace {

constexpr Bounds kNothing{std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity()};

Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Bounds common(const Bounds& a, const Bounds& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

Bounds operator+(const Bounds& a, const Bounds& b) { return {a.low + b.low, a.high + b.high}; }

Bounds operator*(double factor, const Bounds& a) {
  return factor < 0.0 ? Bounds{factor * a.high, factor * a.low}
                      : Bounds{factor * a.low, factor * a.high};
}

bool empty(const Bounds& a) { return a.low > a.high; }

}  // namespace

Bounds LineBounds::Edge::slope() const {
  return 1.0 / (right.at.x() - left.at.x()) * (right.height + -1.0 * left.height);
}

Bounds LineBounds::Edge::height(double x) const {
  const double share = (x - left.at.x()) / (right.at.x() - left.at.x());
  return (1.0 - share) * left.height + share * right.height;
}

Bounds LineBounds::height(const Edge& edge, double x) const {
  Bounds bounds = edge.height(x);
  for (const BoundedCorner& corner : {edge.left, edge.right})
    bounds = common(bounds, corner.height + (x - corner.at.x()) * slope_);
  return bounds;
}

std::optional<LineBounds> LineBounds::of(const std::array<std::vector<BoundedCorner>, 2>& sides) {
  LineBounds result;
  std::array<Bounds, 2> slopes{kNothing, kNothing};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j + 1 < sides[i].size(); ++j) {
      const Edge edge{sides[i][j], sides[i][j + 1]};
      if (empty(edge.left.height) || empty(edge.right.height)) continue;
      result.edges_[i].push_back(edge);
      slopes[i] = hull(slopes[i], edge.slope());
    }
  result.slope_ = common(slopes[0], slopes[1]);
  if (empty(result.slope_)) return std::nullopt;
  return result;
}

Bounds LineBounds::height(double x) const {
  std::array<Bounds, 2> of_side{kNothing, kNothing};
  for (std::size_t i = 0; i < 2; ++i)
    for (const Edge& edge : edges_[i])
      if (const Bounds bounds = height(edge, x); !empty(bounds))
        of_side[i] = hull(of_side[i], bounds);
  return common(of_side[0], of_side[1]);
}

}  // namespace planish::oracle
