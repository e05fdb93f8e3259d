#pragma once

#include "closed_hem.hpp"
#include "obstruction.hpp"
#include "stage_cache.hpp"
#include "standing.hpp"

namespace planish::brake_detail {

/// Where the flat tools stand that close a hem, or what is in their way.
Standing closing(StageCache& cache, const Setting& stroke);

/// What a stroke that closes a hem leaves open; empty if nothing.
std::optional<OpenHem> open_hem(StageCache& cache, const Setting& stroke);

/// Where the tools of any stroke stand, one that closes or one that bends, or what is in their way.
Standing press_rows(StageCache& cache, const Setting& stroke);

/// What is beside the tools of any stroke.
struct Surroundings {
  RowWalls walls;
  Interval part;  ///< of the whole workpiece along x
};
Surroundings surroundings(StageCache& cache, const Setting& stroke);

/// The parts of a hem's tree before it is closed, both its sides lying.
std::vector<const PlacedPart*> open_parts(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
