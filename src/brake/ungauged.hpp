#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// Why a stroke has no gauge: goes on from "the back gauge has nothing to touch:".
Remark why_ungauged(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
