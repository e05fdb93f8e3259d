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

/// Where along x a tool must stand: a row where it presses, less as deep as anything may be in it.
std::vector<Interval> needed_by(ToolKind kind, const std::vector<Interval>& pieces,
                                double shortfall) {
  if (!is_row(kind)) return {kEverywhere};
  return mapped(pieces, [&](const Interval& piece) {
    const Interval row = covered(piece, shortfall);
    const double middle = 0.5 * (row.lo + row.hi);
    return Interval{std::min(row.lo + kPenetration, middle),
                    std::max(row.hi - kPenetration, middle)};
  });
}

/// A tool as a part sees it.
SidedObstacle seen_by(StageCache& cache, const Setting& stroke, int part, ToolKind kind) {
  return cache.tools().obstacle(kind, tool_of(kind, stroke), nearness(cache, stroke, part, kind),
                                stroke.direction);
}

/// Whether a part hits a tool where that must stand.
bool stands_in(StageCache& cache, const Setting& stroke, int part, ToolKind kind,
               const PressMotion& motion, const std::vector<Interval>& needed) {
  const SidedObstacle obstacle = seen_by(cache, stroke, part, kind);
  return cache.stands_in(stroke, part, obstacle.key, needed, [&](const PlacedPart& placed) {
    return std::ranges::any_of(needed, [&](const Interval& along) {
      return hit_within(motion, placed, *obstacle.left, *obstacle.right, along,
                        most_turn(cache.inputs(), stroke.line))
          .has_value();
    });
  });
}

/// Where along x a part is in the way of a tool, as far as that lies within a range.
const std::vector<Interval>& blocked_by(StageCache& cache, const Setting& stroke, int part,
                                        ToolKind kind, const PressMotion& motion,
                                        const Interval& within) {
  const SidedObstacle obstacle = seen_by(cache, stroke, part, kind);
  return cache.blocked(stroke, part, obstacle.key, within, [&](const PlacedPart& placed) {
    return blocked_along(motion, placed, *obstacle.left, *obstacle.right,
                         most_turn(cache.inputs(), stroke.line), within);
  });
}

const SegmentSums& segments_of(const StrokeInputs& inputs, const Setting& stroke, ToolKind row) {
  return row == ToolKind::punch ? inputs.punch_segments[stroke.punch]
                                : inputs.die_segments[stroke.die];
}

/// Where the shortest row that presses all pieces may stand.
Interval of_shortest_row(const StrokeInputs& inputs, const Setting& stroke, ToolKind row,
                         const std::vector<Interval>& pieces) {
  const SegmentSums& segments = segments_of(inputs, stroke, row);
  const double left_out = shortfall(inputs);
  const double lo = covered(pieces.front(), left_out).lo, hi = covered(pieces.back(), left_out).hi;
  const auto shortest = std::ranges::lower_bound(segments.sums(), hi - lo - kSameLength, {},
                                                 &SegmentSums::Sum::length);
  if (shortest == segments.sums().end()) return kEverywhere;
  return {hi - shortest->length - kSameLength, lo + shortest->length + kSameLength};
}

/// Adds where along x parts are in the way of a row, as far as that lies within a range.
void add_walls(StageCache& cache, const Setting& stroke, ToolKind row, const PressMotion& motion,
               const Interval& within, RowWalls& walls) {
  const PartTree& tree = cache.tree(stroke.line);
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const std::vector<Interval>& blocked = blocked_by(cache, stroke, part, row, motion, within);
    if (!blocked.empty()) add_wall(walls, row, blocked, tree.parts()[part].path);
  }
}

std::size_t row_of(ToolKind kind) { return kind == ToolKind::punch ? 0 : 1; }

/// Segments of punch or die that press all pieces between walls; empty if none do.
std::vector<ToolRow> row_of_segments(const StrokeInputs& inputs, const Setting& stroke,
                                     ToolKind kind, const std::vector<Interval>& pieces,
                                     const std::vector<Interval>& walls) {
  return tool_rows(segments_of(inputs, stroke, kind),
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
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  const PressMotion at_die = motion(cache.inputs(), stroke),
                    at_punch = motion_at_punch(cache.inputs(), stroke);
  const double left_out = shortfall(cache.inputs());
  std::vector<Obstruction> all;
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds)
      if (stands_in(cache, stroke, part, kind, is_above(kind) ? at_punch : at_die,
                    needed_by(kind, pieces, left_out)))
        all.push_back({tree.parts()[part].path, kind, part});
  return all;
}

StandingRow standing_row(StageCache& cache, const Setting& stroke, ToolKind row) {
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  const PressMotion motion = motion_at(cache.inputs(), stroke, row);
  const double left_out = shortfall(cache.inputs());
  const int parts = static_cast<int>(tree.parts().size());
  for (const ToolKind kind : {row, beam_of(row)}) {
    const std::vector<Interval> needed = needed_by(kind, pieces, left_out);
    for (int part = 0; part < parts; ++part)
      if (stands_in(cache, stroke, part, kind, motion, needed))
        return tl::unexpected(Obstruction{tree.parts()[part].path, kind, part});
  }
  const auto row_within = [&](const Interval& within) {
    RowWalls walls = no_walls(cache.inputs());
    add_walls(cache, stroke, row, motion, within, walls);
    return row_between(cache, stroke, walls, row);
  };
  // Mostly the shortest row has room, and what is farther away does not matter.
  const Interval near = of_shortest_row(cache.inputs(), stroke, row, pieces);
  StandingRow made = row_within(near);
  const bool is_near = made && made->front().from >= near.lo &&
                       made->back().from + made->back().length() <= near.hi;
  return is_near ? made : row_within(kEverywhere);
}

Standing standing(StageCache& cache, const Setting& stroke) {
  StandingRow punch = standing_row(cache, stroke, ToolKind::punch);
  if (!punch) return tl::unexpected(std::move(punch.error()));
  StandingRow die = standing_row(cache, stroke, ToolKind::die);
  if (!die) return tl::unexpected(std::move(die.error()));
  return PressRows{std::move(*punch), std::move(*die)};
}

RowWalls walls_of(StageCache& cache, const Setting& stroke) {
  RowWalls walls = no_walls(cache.inputs());
  for (const ToolKind row : {ToolKind::punch, ToolKind::die})
    add_walls(cache, stroke, row, motion_at(cache.inputs(), stroke, row), kEverywhere, walls);
  return walls;
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

StandingRow row_between(StageCache& cache, const Setting& stroke, const RowWalls& walls,
                        ToolKind kind) {
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  const std::size_t row = row_of(kind);
  std::vector<ToolRow> made = row_of_segments(cache.inputs(), stroke, kind, pieces,
                                              walls.walls[row]);
  if (!made.empty()) return made;
  return tl::unexpected(Obstruction{
      walls.because[row], kind, -1, {Lack::Kind::segments, pieces.back().hi - pieces.front().lo}});
}

Standing rows_between(StageCache& cache, const Setting& stroke, const RowWalls& walls) {
  StandingRow punch = row_between(cache, stroke, walls, ToolKind::punch);
  if (!punch) return tl::unexpected(std::move(punch.error()));
  StandingRow die = row_between(cache, stroke, walls, ToolKind::die);
  if (!die) return tl::unexpected(std::move(die.error()));
  return PressRows{std::move(*punch), std::move(*die)};
}

PressRows rows_without_walls(StageCache& cache, const Setting& stroke) {
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  PressRows rows;
  rows.punch = row_of_segments(cache.inputs(), stroke, ToolKind::punch, pieces, {});
  if (!rows.punch.empty())
    rows.die = row_of_segments(cache.inputs(), stroke, ToolKind::die, pieces, {});
  return rows;
}

}  // namespace planish::brake_detail
