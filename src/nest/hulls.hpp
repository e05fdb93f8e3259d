#pragma once

#include "nester.hpp"

namespace planish::nest_detail {

/// The smallest convex polygon around an outline, counter-clockwise.
Path convex_hull(const Path& outline);

/// The shapes with their hulls in place of those outlines whose hollows gain little. A hollow
/// costs: the no-fit polygon of two outlines that are not convex takes about a millisecond, of
/// convex ones a few microseconds. So at most `kMostHollow` different shapes stay as they are.
std::vector<Shape> with_hulls(std::vector<Shape> shapes);

constexpr std::size_t kMostHollow = 40;

}  // namespace planish::nest_detail
