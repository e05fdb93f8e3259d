#pragma once

#include <planish/connect/plates.hpp>
#include <planish/geometry/curve.hpp>

namespace planish::connect_detail {

/// The points that a shape gives, for checks.
std::vector<Vec3> given_points(const HoleShape& shape);

/// The smallest of its sizes, mm; infinite if it has none but its points.
double smallest_size(const HoleShape& shape);

/// The outline of a hole in the axes of its plate's plane, run clockwise. Points off the plane are
/// taken to it.
Loop hole_loop(const HoleShape& shape, const Frame& plane);

}  // namespace planish::connect_detail
