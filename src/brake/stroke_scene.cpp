#include "closed_hem.hpp"
#include "stroke_model.hpp"

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

/// Segments along x of the machine, which runs against that of the line where the gauge is on its
/// right.
std::vector<StandingSegment> standing(const std::vector<ToolRow>& rows, int direction) {
  std::vector<StandingSegment> segments;
  for (const ToolRow& row : rows) {
    double from = row.from;
    for (const double length : row.segments) {
      segments.push_back({direction > 0 ? from : -(from + length), length});
      from += length;
    }
  }
  std::ranges::sort(segments, {}, &StandingSegment::from);
  return segments;
}

}  // namespace

/// The rows of tools of a stroke. Of one that cannot be made those that the line needs, whatever
/// is in their way, and where there are no such segments one of its whole length.
StrokeModel::Rows StrokeModel::rows_wanted(const Setting& stroke) {
  Rows rows;
  const auto obstruction = work_.lines[stroke.line].closes ? cannot_close(stroke, &rows)
                                                           : obstructed(stroke, &rows);
  if (!obstruction) return rows;
  const LineSet none = no_lines(static_cast<int>(work_.lines.size()));
  rows = {};
  rows_missing(stroke, {}, {none, none}, &rows);
  const std::vector<Interval> pieces = pressed_pieces(stroke);
  for (auto* row : {&rows.punch, &rows.die})
    if (row->empty()) row->push_back({pieces.front().lo, {pieces.back().hi - pieces.front().lo}});
  return rows;
}

void StrokeModel::add_bending(const Setting& stroke, StrokeScene& scene) {
  const BrakeLine& line = work_.lines[stroke.line];
  const PressMotion press = motion(stroke);
  const Vec2 edge(0.5 * line.bend.allowance, 0.0);
  scene.held = point_on(work_.bodies[line.bodies[stroke.direction > 0 ? 1 : 0]]);
  for (int i = 0; i <= kMoments; ++i) {
    const double turn = most_turn(stroke.line) * i / kMoments, slope = 0.5 * turn;
    const Vec2 start = press.side({edge}, turn).front();
    const Vec2 turned(std::cos(slope) * edge.x(), std::sin(slope) * edge.x());
    scene.moments.push_back(
        {Angle::radians(turn), Angle::radians(slope), start - turned, 0.0, press.die_height(turn)});
  }
}

void StrokeModel::add_closing(const Setting& stroke, StrokeScene& scene) {
  const BrakeLine& line = work_.lines[stroke.line];
  const Setting open{stroke.formed, no_lines(static_cast<int>(work_.lines.size())), stroke.line};
  std::vector<const PlacedPart*> lying;
  for (const Known* known : parts_in(open))
    lying.push_back(&known->placed);
  const double turned = line.closed.radians() - line.angle.radians();
  for (int i = 0; i <= kMoments; ++i) {
    const double turn = turned * i / kMoments;
    BrakeLine at = line;
    at.closed = Angle::radians(line.angle.radians() + turn);
    const ClosedHem hem = closed_hem(work_, room(stroke.line).tree, at, lying);
    scene.moments.push_back(
        {Angle::radians(turn), Angle(), Vec2::Zero(), hem.top, -work_.thickness});
    scene.across = stroke.direction * hem.middle;
    scene.held = point_on(work_.bodies[line.bodies[hem.left_folds ? 0 : 1]]);
  }
}

StrokeScene StrokeModel::scene(const LineSet& formed, const StrokeChoice& choice) {
  const Setting stroke = setting(formed, choice);
  const BrakeLine& line = work_.lines[stroke.line];
  StrokeScene scene;
  scene.origin = line.origin;
  scene.along = (line.up ? 1.0 : -1.0) * stroke.direction * line.along;
  scene.pattern_up = line.up;
  if (line.closes)
    add_closing(stroke, scene);
  else
    add_bending(stroke, scene);
  const Rows rows = rows_wanted(stroke);
  scene.punch = standing(rows.punch, stroke.direction);
  scene.die = standing(rows.die, stroke.direction);
  return scene;
}

}  // namespace planish::brake_detail
