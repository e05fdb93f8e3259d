#pragma once

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace planish::connect_detail {

/// Corners of the runs of a bend by side, x growing.
using Corners = std::array<std::vector<Vec2>, 2>;

inline double low_x(const Corners& c) { return std::min(c[0].front().x(), c[1].front().x()); }
inline double high_x(const Corners& c) { return std::max(c[0].back().x(), c[1].back().x()); }
inline double lowest(const Corners& c) {
  return std::min(box_of(c[0]).lo.y(), box_of(c[1]).lo.y());
}
inline double highest(const Corners& c) {
  return std::max(box_of(c[0]).hi.y(), box_of(c[1]).hi.y());
}

}  // namespace planish::connect_detail
