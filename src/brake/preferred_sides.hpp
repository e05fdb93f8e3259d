#pragma once

#include "stage_cache.hpp"

#include <planish/brake/stroke_search.hpp>

namespace planish::brake_detail {

/// Strokes of no more cost of which fewer have a gauge that does not hold the sheet square: some
/// are made with the other side of the line at the gauge.
std::vector<StrokeChoice> with_square_gauges(StageCache& cache, std::vector<StrokeChoice> strokes);

/// Strokes of no more cost, none held worse, in which less of the sheet lies behind the tools where
/// a row of strokes towards one side can as well be made towards the other.
std::vector<StrokeChoice> with_little_behind(StageCache& cache, std::vector<StrokeChoice> strokes);

}  // namespace planish::brake_detail
