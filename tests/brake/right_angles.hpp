#pragma once

#include "support/sheets.hpp"

#include <numbers>

// What tests derive in the plane: all bends turn by 90°, so both sides of a pressed one rise to
// 45°.

namespace planish::test {

inline constexpr double kSin45 = std::numbers::sqrt2 / 2.0;

/// mm to either side of a limit: ±0.2 mm is asked.
inline constexpr double kStep = 0.1;

inline const Turn kUp{Angle::degrees(90), 2.0, BendDirection::up};

}  // namespace planish::test
