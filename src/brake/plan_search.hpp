#pragma once

#include "stage_cache.hpp"

#include <planish/brake/plan.hpp>

namespace planish::brake_detail {

/// What the search asks of the stages.
StrokeProblem problem_of(StageCache& cache);

/// The search, and where it gives up the cheapest order from the outside in. That is looked for
/// first: those orders are few, and most parts with many bends have one.
Result<StrokeSearch> search_plan(StageCache& cache, const Progress& progress);

}  // namespace planish::brake_detail
