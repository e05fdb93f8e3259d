// Whether tools and workpiece clear one another in a stroke. Each part is held against each tool
// over the whole turn (sweep.hpp). Beams are as long as the machine; rows of punch and die stand
// between what is in their way, as far as their segments add up. What must hold: a refusal is
// blamed on the lines that place the parts it names, on no others (math.md#stroke-clearance,
// math.md#tool-segments).
#include "standing.hpp"

#include "one_line.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <limits>

namespace planish::brake_detail {
namespace {

/// A section of a tool and where along x it must stand.
struct Needed {
  CrossSection of = CrossSection::whole;
  std::vector<Interval> along;
};

/// A row stands where it presses, less as deep as anything may be in it; above the feet of ears it
/// need not reach to the ends.
std::vector<Needed> needed_by(const StrokeInputs& inputs, const Setting& stroke, ToolKind kind,
                              const std::vector<Interval>& pieces) {
  if (!is_row(kind)) return {{CrossSection::whole, {kEverywhere}}};
  Needed row{CrossSection::whole, mapped(pieces, [&](const Interval& piece) {
               const Interval pressed = covered(piece, shortfall(inputs));
               const double middle = 0.5 * (pressed.lo + pressed.hi);
               return Interval{std::min(pressed.lo + kPenetration, middle),
                               std::max(pressed.hi - kPenetration, middle)};
             })};
  const RowEars ears = ears_of(inputs, stroke, kind);
  if (!ears.any()) return {std::move(row)};
  const auto [lo, hi] = stood_back({row.along.front().lo, row.along.back().hi}, ears);
  Needed body;
  for (const Interval& along : row.along)
    if (std::max(along.lo, lo) <= std::min(along.hi, hi))
      body.along.push_back({std::max(along.lo, lo), std::min(along.hi, hi)});
  row.of = CrossSection::foot;
  return {std::move(body), std::move(row)};
}

/// A tool as a part sees it.
SidedObstacle seen_by(StageCache& cache, const Setting& stroke, int part, ToolKind kind,
                      CrossSection of) {
  return cache.tools().obstacle(kind, tool_of(kind, stroke), nearness(cache, stroke, part, kind),
                                stroke.direction, of);
}

/// Whether a part hits a tool where that must stand.
bool stands_in(StageCache& cache, const Setting& stroke, int part, ToolKind kind,
               const PressMotion& motion, const std::vector<Needed>& needed) {
  return std::ranges::any_of(needed, [&](const Needed& one) {
    const SidedObstacle obstacle = seen_by(cache, stroke, part, kind, one.of);
    return cache.stands_in(stroke, part, obstacle.key, one.along, [&](const PlacedPart& placed) {
      return std::ranges::any_of(one.along, [&](const Interval& along) {
        return hit_within(motion, placed, *obstacle.left, *obstacle.right, along,
                          most_turn(cache.inputs(), stroke.line))
            .has_value();
      });
    });
  });
}

/// Where along x a part is in the way of a tool, as far as that lies within a range.
const std::vector<Interval>& blocked_by(StageCache& cache, const Setting& stroke, int part,
                                        ToolKind kind, CrossSection of, const PressMotion& motion,
                                        const Interval& within) {
  const SidedObstacle obstacle = seen_by(cache, stroke, part, kind, of);
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
  const bool on_feet = ears_of(cache.inputs(), stroke, row).any();
  for (int part = 0; part < std::ssize(tree.parts()); ++part) {
    const std::vector<Interval>& blocked = blocked_by(cache, stroke, part, row, CrossSection::whole,
                                                      motion, within);
    if (blocked.empty()) continue;
    add_wall(walls, row, blocked, tree.parts()[part].path);
    if (!on_feet) continue;
    std::ranges::copy(blocked_by(cache, stroke, part, row, CrossSection::foot, motion, within),
                      std::back_inserter(walls.foot));
  }
}

std::size_t row_of(ToolKind kind) { return kind == ToolKind::punch ? 0 : 1; }

/// What is asked of segments of punch or die between walls.
RowRequest request_of(const StrokeInputs& inputs, const Setting& stroke, ToolKind kind,
                      const std::vector<Interval>& pieces, const RowWalls& walls) {
  return {pieces,
          shortfall(inputs),
          joined(walls.walls[row_of(kind)], 0.0),
          inputs.tools.machine.length,
          ears_of(inputs, stroke, kind),
          kind == ToolKind::punch ? walls.foot : std::vector<Interval>()};
}

/// Segments of punch or die that press all pieces between walls; empty if none do.
std::vector<ToolRow> row_of_segments(const StrokeInputs& inputs, const Setting& stroke,
                                     ToolKind kind, const std::vector<Interval>& pieces,
                                     const RowWalls& walls) {
  return tool_rows(segments_of(inputs, stroke, kind),
                   request_of(inputs, stroke, kind, pieces, walls));
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
  std::vector<Obstruction> all;
  for (int part = 0; part < std::ssize(tree.parts()); ++part)
    for (const ToolKind kind : kToolKinds)
      if (stands_in(cache, stroke, part, kind, is_above(kind) ? at_punch : at_die,
                    needed_by(cache.inputs(), stroke, kind, pieces)))
        all.push_back({tree.parts()[part].path, kind, part});
  return all;
}

StandingRow standing_row(StageCache& cache, const Setting& stroke, ToolKind row) {
  const PartTree& tree = cache.tree(stroke.line);
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  const PressMotion motion = motion_at(cache.inputs(), stroke, row);
  const int parts = static_cast<int>(tree.parts().size());
  for (const ToolKind kind : {row, beam_of(row)}) {
    const std::vector<Needed> needed = needed_by(cache.inputs(), stroke, kind, pieces);
    for (int part = 0; part < parts; ++part)
      if (stands_in(cache, stroke, part, kind, motion, needed))
        return tl::unexpected(Obstruction{tree.parts()[part].path, kind, part});
  }
  const auto row_within = [&](const Interval& within) {
    RowWalls walls = no_walls(cache.inputs());
    add_walls(cache, stroke, row, motion, within, walls);
    return row_between(cache, stroke, walls, row);
  };
  // Mostly the shortest row has room, and what is farther away does not matter but to ears, which
  // have to come free.
  const Interval near = of_shortest_row(cache.inputs(), stroke, row, pieces);
  StandingRow made = row_within(near);
  const bool is_near = made && made->front().from >= near.lo &&
                       made->back().from + made->back().length() <= near.hi &&
                       !made->front().ears.any() && !made->back().ears.any();
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
  return {{}, {none, none}, {}};
}

void add_wall(RowWalls& walls, ToolKind kind, const std::vector<Interval>& blocked,
              const LineSet& because) {
  const std::size_t row = row_of(kind);
  walls.walls[row].insert(walls.walls[row].end(), blocked.begin(), blocked.end());
  walls.because[row] = joined(walls.because[row], because);
}

namespace {

/// The least room between walls on both sides of a piece.
std::optional<double> room_of(const std::vector<Interval>& pieces,
                              const std::vector<Interval>& walls) {
  std::optional<double> least;
  for (const Interval& piece : pieces) {
    const double middle = 0.5 * (piece.lo + piece.hi);
    Interval room = kEverywhere;
    for (const Interval& wall : walls)
      if (0.5 * (wall.lo + wall.hi) < middle)
        room.lo = std::max(room.lo, wall.hi);
      else
        room.hi = std::min(room.hi, wall.lo);
    if (room.lo <= kEverywhere.lo || room.hi >= kEverywhere.hi) continue;
    least = std::min(least.value_or(room.hi - room.lo), room.hi - room.lo);
  }
  return least;
}

}  // namespace

StandingRow row_between(StageCache& cache, const Setting& stroke, const RowWalls& walls,
                        ToolKind kind) {
  const std::vector<Interval> pieces = pieces_to_press(cache, stroke);
  std::vector<ToolRow> made = row_of_segments(cache.inputs(), stroke, kind, pieces, walls);
  if (!made.empty()) return made;
  RowRequest request = request_of(cache.inputs(), stroke, kind, pieces, walls);
  Lack lack{Lack::Kind::no_room, pieces.back().hi - pieces.front().lo, request.longest};
  if (has_room(request)) {
    request.longest = std::numeric_limits<double>::infinity();
    const bool none = tool_rows(segments_of(cache.inputs(), stroke, kind), request).empty();
    lack.kind = none ? Lack::Kind::segments : Lack::Kind::bed;
  }
  lack.room = room_of(pieces, request.ears.any() ? request.blocked_foot : request.blocked);
  return tl::unexpected(Obstruction{walls.because[row_of(kind)], kind, -1, lack});
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
  const RowWalls none = no_walls(cache.inputs());
  PressRows rows;
  rows.punch = row_of_segments(cache.inputs(), stroke, ToolKind::punch, pieces, none);
  if (!rows.punch.empty())
    rows.die = row_of_segments(cache.inputs(), stroke, ToolKind::die, pieces, none);
  return rows;
}

}  // namespace planish::brake_detail
