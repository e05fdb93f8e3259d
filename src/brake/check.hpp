#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// Whether a stroke can be made: the sides bear the die, nothing hits a tool, and segments stand
/// between what is beside them. If not, the lines by which this is so.
StrokeVerdict check(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

}  // namespace planish::brake_detail
