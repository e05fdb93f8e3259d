#pragma once

#include "bed.hpp"

#include <planish/base/progress.hpp>
#include <planish/brake/stroke_search.hpp>

namespace planish::brake_detail {

/// Strokes as they are pressed: in their stages, with their tools on the bed.
struct LaidStrokes {
  StrokeSearch search;  ///< its tool changes and cost count every set-up
  std::vector<ChosenStroke> chosen;
  Bed bed;
  bool is_dearer = false;  ///< than the strokes that the search found, for want of room on the bed
};

/// Lays what a search found: with the gauges and tools that a shop prefers, unless these take more
/// set-ups. If they take more than the search counted, another order of strokes is looked for that
/// costs less.
LaidStrokes laid_strokes(StageCache& cache, const StrokeSearch& search, const Progress& progress);

}  // namespace planish::brake_detail
