#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

namespace planish::brake_detail {

/// What is to be done in a stroke: tools, segments, the gauge, force, clearance. Of one that cannot
/// be made segments and clearance are missing. `station`: where its tools stand if they stand with
/// those of other strokes (bed.hpp).
Stroke describe(StageCache& cache, const LineSet& formed, const StrokeChoice& choice,
                const std::optional<PressRows>& station = {});

}  // namespace planish::brake_detail
