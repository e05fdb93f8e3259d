#pragma once

#include <planish/base/tolerance.hpp>

namespace planish::connect_detail {

/// What a shop cannot see, a micrometre over a metre: of slopes and turns (rad), and of lengths as
/// a share of the plates' extent.
inline constexpr double kNegligible = 1e-6;

/// Inside radii below this (mm) are too small: a solid needs a cylinder there.
inline constexpr double kSmallestInsideRadius = 1e-3;

}  // namespace planish::connect_detail
