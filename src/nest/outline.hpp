#pragma once

#include "clipper_names.hpp"

#include <planish/geometry/curve.hpp>

namespace planish::nest_detail {

/// Clipper computes with integers, in units of this many mm: a hundred metres stay within the range
/// where it multiplies without 128 bits.
constexpr double kUnit = 1e-4;

/// The largest sheet or part, mm.
constexpr double kLargest = 50000.0;

cInt in_units(double mm);

/// A polygon, counter-clockwise, that contains everything within `reach` mm of the contour, to
/// within a micrometre, and exceeds the contour's own box by no more than `reach`: so what is long
/// or wide by just the sheet fits. It has few corners, at most `kMostCorners`; the simpler the
/// contour, the closer it lies. A polygon with as few corners is only offset.
Path outline_around(const Loop& contour, double reach);

/// What nesting costs grows with the square of the corners.
constexpr std::size_t kMostCorners = 16;

}  // namespace planish::nest_detail
