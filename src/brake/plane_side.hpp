#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

namespace planish::brake_detail {

/// Whether a plane side is too short for the die at some turn, or the shoulders would touch the
/// bend (math.md#tool-fit).
std::optional<Obstruction> too_short(StageCache& cache, const Setting& stroke);

/// How far the plane side goes from the one line that is pressed: as far as it does along half of
/// it, mm.
double reach(StageCache& cache, const Setting& stroke, bool left);

/// How far a side has to go from a line to lie at every turn on a die, or on one whose V is
/// narrower by that much, mm; infinity where the shoulders would touch the bend.
double needed_side(const StrokeInputs& inputs, int line, const Die& die, double narrower = 0.0);

/// Where the shoulder touches the sides, from the bend line, over all turns, mm.
Interval contact_range(StageCache& cache, int line, int die);

}  // namespace planish::brake_detail
