#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// What is to be done in a stroke: tools, segments, the gauge, force, clearance. Of one that cannot
/// be made segments and clearance are missing.
Stroke describe(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

}  // namespace planish::brake_detail
