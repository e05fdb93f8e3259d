#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

#include <planish/brake/order.hpp>

namespace planish::brake_detail {

/// The stroke in space, whether it can be made or not. `station`: as in `describe`.
StrokeScene scene(StageCache& cache, const LineSet& formed, const StrokeChoice& choice,
                  const std::optional<PressRows>& station = {});

}  // namespace planish::brake_detail
