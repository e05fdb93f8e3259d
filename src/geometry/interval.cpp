#include <planish/base/id_vector.hpp>
#include <planish/geometry/interval.hpp>

#include <algorithm>

namespace planish {

std::vector<Interval> joined(std::vector<Interval> intervals, double touching) {
  std::ranges::sort(intervals, {}, &Interval::lo);
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (!result.empty() && interval.lo <= result.back().hi + touching)
      result.back().hi = std::max(result.back().hi, interval.hi);
    else
      result.push_back(interval);
  }
  return result;
}

double distance(const Interval& a, const Interval& b) {
  return std::max({0.0, a.lo - b.hi, b.lo - a.hi});
}

double total(const std::vector<Interval>& intervals) { return sum_of(intervals, &Interval::size); }

}  // namespace planish
