// Closing a hem. It lies on the flat die, the middle of its return below the middle of the flat
// punch, which has come down as far as it goes. What is then in the way is so before or later, so
// one place of the tools is enough (math.md#closing-hems). What must hold: the hem was bent before.
#include "closing.hpp"

#include "standing.hpp"
#include "sweep.hpp"

namespace planish::brake_detail {
namespace {

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

}  // namespace

std::vector<const PlacedPart*> open_parts(StageCache& cache, const Setting& stroke) {
  return cache.parts({stroke.formed, no_lines(cache.inputs().lines()), stroke.line});
}

Standing closing(StageCache& cache, const Setting& stroke) {
  const StrokeInputs& inputs = cache.inputs();
  const PartTree& tree = cache.tree(stroke.line);
  const ClosedHem hem = closed_hem(inputs.work, tree, inputs.work.lines[stroke.line],
                                   open_parts(cache, stroke));
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
  return rows_between(cache, stroke, walls);
}

Standing press_rows(StageCache& cache, const Setting& stroke) {
  const bool closes = cache.inputs().work.lines[stroke.line].closes.has_value();
  return closes ? closing(cache, stroke) : standing(cache, stroke);
}

}  // namespace planish::brake_detail
