#include "cutting.hpp"

#include <algorithm>

namespace planish::brake_detail {

std::vector<Interval> joined(std::vector<Interval> intervals, double touching) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.lo < b.lo; });
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (!result.empty() && interval.lo <= result.back().hi + touching)
      result.back().hi = std::max(result.back().hi, interval.hi);
    else
      result.push_back(interval);
  }
  return result;
}

double BrakeLine::length() const {
  double sum = 0.0;
  for (const Interval& piece : pieces)
    sum += piece.hi - piece.lo;
  return sum;
}

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
