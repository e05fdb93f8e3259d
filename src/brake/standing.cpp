// Whether tools and workpiece clear one another in a stroke. Each part is held against each tool
// over the whole turn (sweep.hpp). Beams are as long as the machine; rows of punch and die stand
// between what is in their way, as far as their segments add up. What must hold: a refusal is
// blamed on the lines that place the parts it names, on no others (math.md#stroke-clearance,
// math.md#tool-segments).
#include "standing.hpp"

#include "one_line.hpp"
#include "sweep.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

bool stands_in(const std::vector<Interval>& blocked, const std::vector<Interval>& pieces,
               double shortfall) {
  for (const Interval& piece : pieces) {
    const Interval row = covered(piece, shortfall);
    for (const Interval& wall : blocked)
      if (wall.lo + kPenetration < row.hi && wall.hi - kPenetration > row.lo) return true;
  }
  return false;
}

/// Where along x a part is in the way of a tool.
const std::vector<Interval>& blocked_by(StageCache& cache, const Setting& stroke, int part,
                                        ToolKind kind, const PressMotion& motion) {
  const SidedObstacle obstacle = cache.tools().obstacle(
      kind, tool_of(kind, stroke), nearness(cache, stroke, part, kind), stroke.direction);
  return cache.blocked(stroke, part, obstacle.key, [&](const PlacedPart& placed) {
    return blocked_along(motion, placed, *obstacle.left, *obstacle.right,
                         most_turn(cache.inputs(), stroke.line));
  });
}

std::size_t row_of(ToolKind kind) { return kind == ToolKind::punch ? 0 : 1; }

/// Segments of punch or die that press all pieces between walls; empty if none do.
std::vector<ToolRow> row_of_segments(const StrokeInputs& inputs, const Setting& stroke,
                                     ToolKind kind, const std::vector<Interval>& pieces,
                                     const std::vector<Interval>& walls) {
  const SegmentSums& segments = kind == ToolKind::punch ? inputs.punch_segments[stroke.punch]
                                                        : inputs.die_segments[stroke.die];
  return tool_rows(segments,
                   {pieces, shortfall(inputs), joined(walls, 0.0), inputs.tools.machine.length});
}

}  // namespace

Nearness nearness(StageCache& cache, const Setting& stroke, int number, ToolKind kind) {
  if (!is_row(kind)) return Nearness::clear;
  const std::vector<const PlacedPart*>& parts = cache.parts(stroke);
  if (parts[number]->flat) return Nearness::touching;
  const PartTree::Part& part = cache.tree(stroke.line).parts()[number];
  const bool lies_on_die = kind == ToolKind::die && part.is_zone && part.before >= 0 &&
                           parts[part.before]->flat;
  return lies_on_die ? Nearness::touching : Nearness::clear;
}

std::vector<Obstruction> collisions(StageCache& cache, const Setting& stroke) {
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  const PressMotion motion = brake_detail::motion(cache.inputs(), stroke);
  const double left_out = shortfall(cache.inputs());
  std::vector<Obstruction> all;
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds) {
      const std::vector<Interval>& blocked = blocked_by(cache, stroke, part, kind, motion);
      if (!blocked.empty() && (!is_row(kind) || stands_in(blocked, pieces, left_out)))
        all.push_back({tree.parts()[part].path, kind, part});
    }
  return all;
}

Standing standing(StageCache& cache, const Setting& stroke) {
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  const PressMotion motion = brake_detail::motion(cache.inputs(), stroke);
  const double left_out = shortfall(cache.inputs());
  RowWalls walls = no_walls(cache.inputs());
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds) {
      const std::vector<Interval>& blocked = blocked_by(cache, stroke, part, kind, motion);
      if (blocked.empty()) continue;
      const LineSet& path = tree.parts()[part].path;
      if (!is_row(kind) || stands_in(blocked, pieces, left_out))
        return tl::unexpected(Obstruction{path, kind, part});
      add_wall(walls, kind, blocked, path);
    }
  return rows_between(cache, stroke, walls);
}

RowWalls no_walls(const StrokeInputs& inputs) {
  const LineSet none = no_lines(inputs.lines());
  return {{}, {none, none}};
}

void add_wall(RowWalls& walls, ToolKind kind, const std::vector<Interval>& blocked,
              const LineSet& because) {
  const std::size_t row = row_of(kind);
  walls.walls[row].insert(walls.walls[row].end(), blocked.begin(), blocked.end());
  walls.because[row] = joined(walls.because[row], because);
}

Standing rows_between(StageCache& cache, const Setting& stroke, const RowWalls& walls) {
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  PressRows rows;
  for (const ToolKind kind : {ToolKind::punch, ToolKind::die}) {
    const std::size_t row = row_of(kind);
    std::vector<ToolRow> made = row_of_segments(cache.inputs(), stroke, kind, pieces,
                                                walls.walls[row]);
    if (made.empty())
      return tl::unexpected(
          Obstruction{walls.because[row],
                      kind,
                      -1,
                      {Lack::Kind::segments, pieces.back().hi - pieces.front().lo}});
    (row == 0 ? rows.punch : rows.die) = std::move(made);
  }
  return rows;
}

PressRows rows_without_walls(StageCache& cache, const Setting& stroke) {
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  PressRows rows;
  rows.punch = row_of_segments(cache.inputs(), stroke, ToolKind::punch, pieces, {});
  if (!rows.punch.empty())
    rows.die = row_of_segments(cache.inputs(), stroke, ToolKind::die, pieces, {});
  return rows;
}

}  // namespace planish::brake_detail
