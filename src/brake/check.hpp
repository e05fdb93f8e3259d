#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

namespace planish::brake_detail {

/// Why a stroke cannot be made: the sides do not bear the die, something hits a tool, or no
/// segments stand between what is beside them.
std::optional<Obstruction> obstruction_of(StageCache& cache, const Setting& stroke);

/// Whether a stroke can be made. If not, the lines by which this is so.
StrokeVerdict check(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

/// Whether it can be made and is gauged as the choice says. What closes a hem needs no gauge.
bool can_be_made(StageCache& cache, const LineSet& formed, const StrokeChoice& choice);

}  // namespace planish::brake_detail
