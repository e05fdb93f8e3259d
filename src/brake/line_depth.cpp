#include "line_depth.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

bool same_bodies(const BrakeLine& a, const BrakeLine& b) {
  return std::minmax(a.bodies[0], a.bodies[1]) == std::minmax(b.bodies[0], b.bodies[1]);
}

/// Lines that hang on a body if the given one is cut.
int lines_beyond(const Workpiece& work, const BrakeLine& cut, int body) {
  std::vector<bool> reached(work.bodies.size(), false);
  std::vector<int> left{body};
  reached[body] = true;
  while (!left.empty()) {
    const int at = left.back();
    left.pop_back();
    for (const BrakeLine& line : work.lines) {
      if (same_bodies(line, cut) || (line.bodies[0] != at && line.bodies[1] != at)) continue;
      const int other = line.bodies[0] == at ? line.bodies[1] : line.bodies[0];
      if (reached[other]) continue;
      reached[other] = true;
      left.push_back(other);
    }
  }
  return static_cast<int>(std::ranges::count_if(work.lines, [&](const BrakeLine& line) {
    return !same_bodies(line, cut) && reached[line.bodies[0]];
  }));
}

}  // namespace

std::vector<int> line_depths(const Workpiece& work) {
  std::vector<int> depths;
  for (const BrakeLine& line : work.lines)
    depths.push_back(std::min(lines_beyond(work, line, line.bodies[0]),
                              lines_beyond(work, line, line.bodies[1])));
  return depths;
}

}  // namespace planish::brake_detail
