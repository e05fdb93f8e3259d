#pragma once

#include "stage_cache.hpp"

namespace planish::brake_detail {

/// The least distance between tools and workpiece where it counts, over all turns, mm; at most
/// 1000. Punch and die count as far as their rows reach, without what is bent between them.
double clearance(StageCache& cache, const Setting& stroke, const PressRows& rows);

}  // namespace planish::brake_detail
