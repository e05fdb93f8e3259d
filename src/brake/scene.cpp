// A stroke in space, for those who show it: where the held body and the tools are at `kMoments`
// steps of the turn, and where segments stand. The machine's x runs along the line so that y points
// to the gauge (math.md#machine-frame, math.md#stroke); between steps motion is all but linear.
#include "scene.hpp"

#include "closing.hpp"
#include "one_line.hpp"
#include "standing.hpp"

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr int kMoments = 32;  // steps of a stroke: up to 6°, between which motion is all but linear

/// A point well inside a body.
Vec2 point_on(const Body& body) {
  const auto largest = std::ranges::max_element(
      body.pieces, {}, [](const Convex& piece) { return std::abs(ring_area(piece)); });
  Vec2 middle = Vec2::Zero();
  if (largest == body.pieces.end()) return middle;
  for (const Vec2& p : *largest)
    middle += p / static_cast<double>(largest->size());
  return middle;
}

/// Stretches of the bend line along x of the machine, which runs against that of the line where the
/// gauge is on its right.
std::vector<StandingSegment> along_machine(const std::vector<Interval>& stretches, int direction) {
  auto segments = mapped(stretches, [&](const Interval& s) {
    return StandingSegment{direction > 0 ? s.lo : -s.hi, s.hi - s.lo};
  });
  std::ranges::sort(segments, {}, &StandingSegment::from);
  return segments;
}

/// Where the whole section of each segment stands.
std::vector<Interval> bodies_of(const std::vector<ToolRow>& rows) {
  std::vector<Interval> bodies;
  for (const ToolRow& row : rows) {
    const Interval whole = body(row);
    double from = row.from;
    for (const double length : row.segments) {
      bodies.push_back({std::max(from, whole.lo), std::min(from + length, whole.hi)});
      from += length;
    }
  }
  return bodies;
}

std::vector<Interval> feet_of(const std::vector<ToolRow>& rows) {
  std::vector<Interval> feet;
  for (const ToolRow& row : rows) {
    const Interval end = extent(row), whole = body(row);
    if (row.ears.lo > 0.0) feet.push_back({end.lo, whole.lo});
    if (row.ears.hi > 0.0) feet.push_back({whole.hi, end.hi});
  }
  return feet;
}

/// The rows of tools of a stroke. Of one that cannot be made those that the line needs, whatever
/// is in their way, and where there are no such segments one of its whole length.
PressRows rows_wanted(StageCache& cache, const Setting& stroke) {
  if (Standing rows = press_rows(cache, stroke)) return *rows;
  PressRows rows = rows_without_walls(cache, stroke);
  const std::vector<Interval> pieces = pressed_pieces(cache, stroke);
  for (auto* row : {&rows.punch, &rows.die})
    if (row->empty()) row->push_back({pieces.front().lo, {pieces.back().hi - pieces.front().lo}});
  return rows;
}

/// The left side is held: its tangent line moves as `PressMotion` says, and it turns about that.
void add_bending(const StrokeInputs& inputs, const Setting& stroke, StrokeScene& scene) {
  const BrakeLine& line = inputs.work.lines[stroke.line];
  const PressMotion press = motion(inputs, stroke);
  const Vec2 edge(0.5 * line.bend.allowance, 0.0);
  scene.held = point_on(inputs.work.bodies[line.bodies[stroke.direction > 0 ? 1 : 0]]);
  for (int i = 0; i <= kMoments; ++i) {
    const double turn = most_turn(inputs, stroke.line) * i / kMoments, slope = 0.5 * turn;
    const Vec2 start = press.side({edge}, turn).front();
    const Vec2 turned(std::cos(slope) * edge.x(), std::sin(slope) * edge.x());
    scene.moments.push_back(
        {Angle::radians(turn), Angle::radians(slope), start - turned, 0.0, press.die_height(turn)});
  }
}

void add_closing(StageCache& cache, const Setting& stroke, StrokeScene& scene) {
  const Workpiece& work = cache.inputs().work;
  const BrakeLine& line = work.lines[stroke.line];
  const std::vector<const PlacedPart*> open = open_parts(cache, stroke);
  const double turned = line.closed.radians() - line.angle.radians();
  for (int i = 0; i <= kMoments; ++i) {
    const double turn = turned * i / kMoments;
    BrakeLine at = line;
    at.closed = Angle::radians(line.angle.radians() + turn);
    const ClosedHem hem = closed_hem(work, cache.tree(stroke.line), at, open);
    scene.moments.push_back(
        {Angle::radians(turn), Angle(), Vec2::Zero(), hem.top, -work.thickness});
    scene.across = stroke.direction * hem.middle;
    scene.held = point_on(work.bodies[line.bodies[hem.left_folds ? 0 : 1]]);
  }
}

}  // namespace

StrokeScene scene(StageCache& cache, const LineSet& formed, const StrokeChoice& choice,
                  const std::optional<PressRows>& station) {
  const StrokeInputs& inputs = cache.inputs();
  const Setting stroke = setting(inputs, formed, choice);
  const BrakeLine& line = inputs.work.lines[stroke.line];
  StrokeScene scene;
  scene.origin = line.origin;
  scene.along = (line.up ? 1.0 : -1.0) * stroke.direction * line.along;
  scene.pattern_up = line.up;
  if (line.closes)
    add_closing(cache, stroke, scene);
  else
    add_bending(inputs, stroke, scene);
  const PressRows rows = station ? *station : rows_wanted(cache, stroke);
  scene.punch = along_machine(bodies_of(rows.punch), stroke.direction);
  scene.die = along_machine(bodies_of(rows.die), stroke.direction);
  scene.feet = along_machine(feet_of(rows.punch), stroke.direction);
  return scene;
}

}  // namespace planish::brake_detail
