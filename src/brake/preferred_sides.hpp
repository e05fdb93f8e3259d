#pragma once

#include "stage_cache.hpp"

#include <planish/brake/stroke_search.hpp>

namespace planish::brake_detail {

/// Strokes of no more cost of which fewer have a gauge that does not hold the sheet square: some
/// are made with the other side of the line at the gauge.
std::vector<StrokeChoice> with_square_gauges(StageCache& cache, std::vector<StrokeChoice> strokes);

}  // namespace planish::brake_detail
