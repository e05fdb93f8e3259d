#pragma once

#include "stage_cache.hpp"

#include <vector>

namespace planish::brake_detail {

/// Among plans of one cost, that with the tools a shop would take: for strokes in a row with the
/// same tools the least acute punch and die that can make all of them, of these the punch with the
/// largest tip radius, of these the first of the catalogue. Nothing else of the strokes changes.
std::vector<StrokeChoice> with_preferred_tools(StageCache& cache,
                                               std::vector<StrokeChoice> strokes);

}  // namespace planish::brake_detail
