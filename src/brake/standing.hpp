#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

namespace planish::brake_detail {

/// Where punch and die stand in a stroke that bends, or what is in their way: the first part that
/// hits a tool which cannot stand elsewhere, else that no segments fit between what is beside them.
Standing standing(StageCache& cache, const Setting& stroke);

/// The same for the punch alone with the beam above it, or the die with the one below: what the one
/// hits does not depend on the other.
StandingRow standing_row(StageCache& cache, const Setting& stroke, ToolKind row);

/// What is beside the rows: by row, where along x it stands, and the lines by which it does.
struct RowWalls {
  std::array<std::vector<Interval>, 2> walls;  ///< of the punch, of the die
  std::array<LineSet, 2> because;
  std::vector<Interval> foot = {};  ///< of the feet of the punch's ears
};
RowWalls no_walls(const StrokeInputs& inputs);
void add_wall(RowWalls& walls, ToolKind kind, const std::vector<Interval>& blocked,
              const LineSet& because);

/// What is beside the rows of a stroke that bends, however far away.
RowWalls walls_of(StageCache& cache, const Setting& stroke);

/// All parts that are in the way of tools which cannot stand elsewhere.
std::vector<Obstruction> collisions(StageCache& cache, const Setting& stroke);

/// A row of the punch's or the die's segments between walls.
StandingRow row_between(StageCache& cache, const Setting& stroke, const RowWalls& walls,
                        ToolKind kind);

/// Rows of punch and die of their segments between walls.
Standing rows_between(StageCache& cache, const Setting& stroke, const RowWalls& walls);

/// Rows as the line needs them, whatever is in their way; empty where there are no such segments,
/// and the die's where the punch's is.
PressRows rows_without_walls(StageCache& cache, const Setting& stroke);

/// How near a part may come to a tool: sides that are bent touch punch and die; what lies on the
/// die may touch it.
Nearness nearness(StageCache& cache, const Setting& stroke, int part, ToolKind kind);

}  // namespace planish::brake_detail
