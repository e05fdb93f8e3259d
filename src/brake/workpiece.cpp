#include "cutting.hpp"

namespace planish::brake_detail {

Result<Workpiece> workpiece_of(const Sheet& sheet, const Layout& layout,
                               const WorkpieceOptions& options) {
  return Cutting(sheet, layout, options).cut();
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
