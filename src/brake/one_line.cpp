// Lines that one stroke can press: pieces of one line of the pattern that are bent alike, where
// what is formed between them has not moved them off that line. What must hold: origin and
// direction, carried to the stage, agree within `kSameLine` (math.md#strokes-together).
#include "one_line.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

constexpr double kSameLine = 1e-3;  // mm, and radians: lines that are pressed together

/// Pieces of the lines of a stroke, without the ends that are in another zone if they are trimmed.
std::vector<Interval> pieces_of(StageCache& cache, const Setting& stroke, bool trimmed) {
  const StrokeInputs& inputs = cache.inputs();
  const PartTree& tree = cache.tree(stroke.line);
  std::vector<Interval> pieces;
  for (const int number : inputs.on_one_line[stroke.line]) {
    if (!holds(stroke.pressed, number)) continue;
    const BrakeLine& line = inputs.work.lines[number];
    const Eigen::Isometry3d at = tree.place(tree.part_of_body(line.bodies[0]), *stroke.formed);
    const Interval left{line.from() + (trimmed ? line.overlapped[0] : 0.0),
                        line.to() - (trimmed ? line.overlapped[1] : 0.0)};
    for (const Interval& piece : line.pieces) {
      if (piece.hi <= left.lo || piece.lo >= left.hi) continue;
      const Vec2 a = line.origin + std::max(piece.lo, left.lo) * line.along,
                 b = line.origin + std::min(piece.hi, left.hi) * line.along;
      const double lo = (at * Vec3(a.x(), a.y(), 0.0)).x(), hi = (at * Vec3(b.x(), b.y(), 0.0)).x();
      pieces.push_back({std::min(lo, hi), std::max(lo, hi)});
    }
  }
  return joined(std::move(pieces), 0.0);
}

}  // namespace

bool lie_on_one_line(const BrakeLine& a, const BrakeLine& b) {
  const double turned = cross(a.along, b.along);
  return a.reference_up == b.reference_up && !a.press_line && !b.press_line && !a.closes &&
         !b.closes && std::abs(turned) < kSameLine &&
         std::abs(a.across().dot(b.origin - a.origin)) < kSameLine &&
         std::abs(a.angle.radians() - b.angle.radians()) < kSameLine &&
         std::abs(a.inside_radius - b.inside_radius) < kSameLine;
}

std::vector<int> together(StageCache& cache, int line, const LineSet& formed) {
  const StrokeInputs& inputs = cache.inputs();
  if (inputs.work.lines[line].closes) return {line};
  std::vector<int> lines;
  const PartTree& tree = cache.tree(line);
  for (const int other : inputs.on_one_line[line]) {
    if (holds(formed, other)) continue;
    const BrakeLine& seen = inputs.work.lines[other];
    const Eigen::Isometry3d at = tree.place(tree.part_of_body(seen.bodies[0]), formed);
    const Vec3 origin = at * Vec3(seen.origin.x(), seen.origin.y(), 0.0);
    const Vec3 along = at.linear() * Vec3(seen.along.x(), seen.along.y(), 0.0);
    const bool same = std::abs(origin.y()) < kSameLine &&
                      std::abs(origin.z() + 0.5 * inputs.work.thickness) < kSameLine &&
                      std::abs(std::abs(along.x()) - 1.0) < kSameLine * kSameLine &&
                      std::abs(at.linear()(2, 2)) > 0.5;
    if (same) lines.push_back(other);
  }
  return lines;
}

std::vector<Interval> pressed_pieces(StageCache& cache, const Setting& stroke) {
  return pieces_of(cache, stroke, false);
}

std::vector<Interval> pieces_to_press(StageCache& cache, const Setting& stroke) {
  return pieces_of(cache, stroke, true);
}

}  // namespace planish::brake_detail
