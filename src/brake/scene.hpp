#pragma once

#include "stage_cache.hpp"

#include <planish/brake/order.hpp>

namespace planish::brake_detail {

/// The stroke in space, whether it can be made or not.
StrokeScene scene(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

}  // namespace planish::brake_detail
