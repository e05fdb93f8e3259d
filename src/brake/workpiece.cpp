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

}  // namespace planish::brake_detail
