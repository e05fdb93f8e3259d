#pragma once

#include "stage_cache.hpp"

#include <planish/base/progress.hpp>
#include <planish/brake/stroke_search.hpp>

namespace planish::brake_detail {

/// Strokes that cost less than `than` with every set-up that they take on the bed; empty if none
/// are found within a share of the work that options allow.
std::vector<StrokeChoice> with_fewer_set_ups(StageCache& cache, const StrokeProblem& problem,
                                             double than, const Progress& progress);

}  // namespace planish::brake_detail
