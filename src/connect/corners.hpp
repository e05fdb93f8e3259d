#pragma once

#include <planish/geometry/frame.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace planish::connect_detail {

/// Corners of the runs of a bend by side, x growing.
using Corners = std::array<std::vector<Vec2>, 2>;

inline double low_x(const Corners& c) { return std::min(c[0].front().x(), c[1].front().x()); }
inline double high_x(const Corners& c) { return std::max(c[0].back().x(), c[1].back().x()); }

}  // namespace planish::connect_detail
