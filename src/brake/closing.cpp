// Closing a hem. It lies on the flat die, the middle of its return below the middle of the flat
// punch, which has come down as far as it goes. What is then in the way is so before or later, so
// one place of the tools is enough (math.md#closing-hems). What must hold: the hem was bent before.
#include "closing.hpp"

#include "standing.hpp"
#include "sweep.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

ClosedHem closed(StageCache& cache, const Setting& stroke) {
  const Workpiece& work = cache.inputs().work;
  return closed_hem(work, cache.tree(stroke.line), work.lines[stroke.line],
                    open_parts(cache, stroke));
}

/// A tool where it stands when the hem is closed.
Obstacle standing_still(StageCache& cache, const Setting& stroke, const ClosedHem& hem,
                        ToolKind kind, Nearness nearness) {
  const double height = is_above(kind) ? hem.top : -cache.inputs().work.thickness;
  Obstacle tool = moved(
      *cache.tools().obstacle(kind, tool_of(kind, stroke), nearness, stroke.direction).left,
      Vec2(hem.middle, height));
  tool.moves = false;
  return tool;
}

/// Walls beside the flat tools, or the part that leaves them no room.
tl::expected<RowWalls, Obstruction> walls_at_closing(StageCache& cache, const Setting& stroke) {
  const StrokeInputs& inputs = cache.inputs();
  const PartTree& tree = cache.tree(stroke.line);
  const ClosedHem hem = closed(cache, stroke);
  const PressMotion still = motion(inputs, stroke);
  RowWalls walls = no_walls(inputs);
  for (const ToolKind kind : kToolKinds)
    for (int part = 0; part < std::ssize(hem.parts); ++part) {
      const bool touches = hem.parts[part].flat && is_row(kind);
      const Obstacle tool = standing_still(cache, stroke, hem, kind,
                                           touches ? Nearness::touching : Nearness::clear);
      const std::vector<Interval> blocked = blocked_along(still, hem.parts[part], tool, tool, 0.0);
      if (blocked.empty()) continue;
      const LineSet& path = tree.parts()[part].path;
      if (!is_row(kind)) return tl::unexpected(Obstruction{path, kind, -1, {Lack::Kind::room}});
      add_wall(walls, kind, blocked, path);
    }
  return walls;
}

}  // namespace

std::vector<const PlacedPart*> open_parts(StageCache& cache, const Setting& stroke) {
  return cache.parts({stroke.formed, no_lines(cache.inputs().lines()), stroke.line});
}

Standing closing(StageCache& cache, const Setting& stroke) {
  const auto walls = walls_at_closing(cache, stroke);
  if (!walls) return tl::unexpected(walls.error());
  return rows_between(cache, stroke, *walls);
}

std::optional<OpenHem> open_hem(StageCache& cache, const Setting& stroke) {
  constexpr double kShut = 0.1;  // of the thickness: what a press leaves of a hem that is shut
  const ClosedHem hem = closed(cache, stroke);
  const double thickness = cache.inputs().work.thickness;
  if (hem.gap < kShut * thickness) return {};
  return OpenHem{hem.gap, hem.top + thickness};
}

Standing press_rows(StageCache& cache, const Setting& stroke) {
  const bool closes = cache.inputs().work.lines[stroke.line].closes.has_value();
  return closes ? closing(cache, stroke) : standing(cache, stroke);
}

Surroundings surroundings(StageCache& cache, const Setting& stroke) {
  const bool closes = cache.inputs().work.lines[stroke.line].closes.has_value();
  Surroundings found{no_walls(cache.inputs()), {}};
  if (!closes)
    found.walls = walls_of(cache, stroke);
  else if (auto walls = walls_at_closing(cache, stroke))
    found.walls = std::move(*walls);
  // A sheet keeps its x when it is bent, and when a hem is closed.
  const auto& parts = closes ? open_parts(cache, stroke) : cache.parts(stroke);
  found.part = parts.front()->along;
  for (const PlacedPart* part : parts)
    found.part = {std::min(found.part.lo, part->along.lo), std::max(found.part.hi, part->along.hi)};
  return found;
}

}  // namespace planish::brake_detail
