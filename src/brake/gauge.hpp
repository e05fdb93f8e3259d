#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// The longest edge that a finger of the back gauge reaches and touches along its width, in the
/// stage before the stroke, else the outer face of an upright flange, else, where the options ask
/// for it, the edge of an opening that its nose touches; empty if there is none, or no gauge
/// (math.md#gauging).
std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke);

/// Why there is none: goes on from "the back gauge has nothing to touch:".
Remark why_ungauged(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
