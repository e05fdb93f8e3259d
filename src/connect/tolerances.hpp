#pragma once

#include <planish/base/tolerance.hpp>

namespace planish::connect_detail {

/// Too small for a shop to notice, a micrometre over a metre: for slopes and turns (rad), and for
/// lengths as a share of the plates' extent.
inline constexpr double kNegligible = 1e-6;

/// Edges within this distance of a line (mm) are drawn on it: plates of real parts carry the
/// rounding of their file.
inline constexpr double kDrawn = 1e-3;

/// Inside radii below this (mm) are too small for a solid, which needs a cylinder there.
inline constexpr double kSmallestInsideRadius = 1e-3;

/// Parts of a pattern that share less than this share of the thickness in width only touch.
inline constexpr double kContact = 1e-3;

}  // namespace planish::connect_detail
