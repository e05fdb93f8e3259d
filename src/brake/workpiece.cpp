// The sheet as a tree of bodies and lines. Press lines of one bend that run together are one where
// their zones overlap, half a zone of each; since lines are straight, that is a share of their
// length (math.md#tool-segments).
#include "cutting.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::brake_detail {
namespace {

/// The length at one end of a press line along which it is nearer to another than half of both
/// zones; 0 where the two do not run together.
double overlap(const BrakeLine& line, const BrakeLine& other, bool upper) {
  const auto away = [&](double at) {
    return std::abs(cross(other.along, line.origin + at * line.along - other.origin));
  };
  const double width = 0.5 * (line.bend.allowance + other.bend.allowance);
  const double near = away(upper ? line.to() : line.from()),
               far = away(upper ? line.from() : line.to());
  if (near >= width || far <= width) return 0.0;
  return (width - near) / (far - near) * (line.to() - line.from());
}

void note_overlaps(std::vector<BrakeLine>& lines) {
  for (BrakeLine& line : lines)
    for (const BrakeLine& other : lines) {
      if (&line == &other || !line.press_line || !other.press_line || line.bends != other.bends)
        continue;
      for (const bool upper : {false, true}) {
        double& most = line.overlapped[upper ? 1 : 0];
        most = std::min(std::max(most, overlap(line, other, upper)),
                        0.5 * (line.to() - line.from()));
      }
    }
}

}  // namespace

Result<Workpiece> workpiece_of(const Sheet& sheet, const Layout& layout,
                               const WorkpieceOptions& options) {
  auto work = Cutting(sheet, layout, options).cut();
  if (work) note_overlaps(work->lines);
  return work;
}

bool touches(const BrakeLine& line, int body) {
  return line.bodies[0] == body || line.bodies[1] == body;
}

bool is_same(const Workpiece& work, int line, int as) {
  return line == as || work.lines[line].closes == as || work.lines[as].closes == line;
}

std::vector<bool> reached_from(const Workpiece& work, int body, int without) {
  std::vector<bool> reached(work.bodies.size(), false);
  std::vector<int> left{body};
  reached[body] = true;
  while (!left.empty()) {
    const int at = left.back();
    left.pop_back();
    for (int i = 0; i < std::ssize(work.lines); ++i) {
      const BrakeLine& line = work.lines[i];
      if (is_same(work, i, without) || !touches(line, at)) continue;
      const int other = line.bodies[line.bodies[0] == at ? 1 : 0];
      if (!reached[other]) left.push_back(other);
      reached[other] = true;
    }
  }
  return reached;
}

}  // namespace planish::brake_detail
