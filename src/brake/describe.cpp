// What a stroke tells the operator. Rows are given as he sees them: he stands where the gauge is
// not, so with the gauge on the right of the line everything along it runs the other way
// (math.md#machine-frame). Forces are those of air bending or of closing a hem (math.md#tool-fit).
#include "describe.hpp"

#include "clearance.hpp"
#include "closing.hpp"
#include "gauge.hpp"
#include "one_line.hpp"
#include "ungauged.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

/// Rows as the operator sees them: with the gauge behind the line, x runs to the right.
std::vector<SegmentRow> seen_rows(const std::vector<ToolRow>& rows, const Interval& line,
                                  bool from_left) {
  auto seen = mapped(rows, [&](const ToolRow& row) {
    return from_left ? row_of(row, row.from - line.lo)
                     : row_of(turned(row), line.hi - extent(row).hi);
  });
  if (!from_left) std::ranges::reverse(seen);
  return seen;
}

/// Whether something that the body of the punch would hit is above the foot of an ear.
bool reaches_over_feet(StageCache& cache, const Setting& stroke,
                       const std::vector<ToolRow>& punch) {
  if (!punch.front().ears.any() && !punch.back().ears.any()) return false;
  const Surroundings around = surroundings(cache, stroke);
  return std::ranges::any_of(punch, [&](const ToolRow& row) {
    return row.ears.any() && std::ranges::any_of(around.walls.walls[0], [&](const Interval& wall) {
             return wall.hi > row.from + kPenetration && wall.lo < extent(row).hi - kPenetration;
           });
  });
}

/// kN, of all lines that are pressed.
double force(const StrokeInputs& inputs, const Setting& stroke) {
  double force = 0.0;
  for (const int line : members(stroke.pressed))
    force += force_of(inputs.work.lines[line], inputs.tools.dies[stroke.die], inputs.options);
  return force;
}

std::vector<BendId> bends_of(const Workpiece& work, const LineSet& pressed) {
  std::vector<BendId> all;
  for (const int line : members(pressed))
    all.insert(all.end(), work.lines[line].bends.begin(), work.lines[line].bends.end());
  return all;
}

}  // namespace

Stroke describe(StageCache& cache, const LineSet& formed, const StrokeChoice& choice,
                const std::optional<PressRows>& station) {
  const StrokeInputs& inputs = cache.inputs();
  const Setting at = setting(inputs, formed, choice);
  const BrakeLine& line = inputs.work.lines[at.line];
  const bool from_left = at.direction > 0;
  const Standing rows = station ? Standing(*station) : press_rows(cache, at);
  Stroke stroke;
  stroke.bends = bends_of(inputs.work, at.pressed);
  stroke.press_line = line.press_line;
  stroke.flattening = line.closes.has_value();
  if (line.closes) stroke.open_hem = open_hem(cache, at);
  stroke.angle = line.closes ? line.closed - line.angle : line.angle;
  stroke.punch = inputs.tools.punches[at.punch].id;
  stroke.die = inputs.tools.dies[at.die].id;
  if (rows) {
    const std::vector<Interval> pieces = pressed_pieces(cache, at);
    const Interval whole{pieces.front().lo, pieces.back().hi};
    stroke.punch_rows = seen_rows(rows->punch, whole, from_left);
    stroke.die_rows = seen_rows(rows->die, whole, from_left);
    stroke.on_ears = reaches_over_feet(cache, at, rows->punch);
  }
  stroke.reference_up = line.reference_up;
  stroke.gauge_direction = at.direction * line.across();
  stroke.to_gauge = inputs.work.bodies[line.bodies[from_left ? 1 : 0]].flange;
  if (choice.gauged && !line.closes) stroke.gauge = gauge(cache, at);
  if (!stroke.gauge && !line.closes) stroke.ungauged = why_ungauged(cache, at);
  stroke.force = force(inputs, at);
  stroke.radius_drawn = line.drawn_radius;
  stroke.radius_made = line.closes || line.closed_by
                           ? line.drawn_radius
                           : made_radius(inputs.tools.punches[at.punch], inputs.tools.dies[at.die],
                                         inputs.options);
  stroke.v_away = choice.v_away;
  if (!line.closes) stroke.v_wanted = wanted_opening(line, inputs.tools, inputs.options);
  if (!line.closes && rows) stroke.clearance = clearance(cache, at, *rows);
  return stroke;
}

}  // namespace planish::brake_detail
