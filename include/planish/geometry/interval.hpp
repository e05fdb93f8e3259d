#pragma once

#include <vector>

namespace planish {

/// The numbers from `lo` to `hi`; none if hi < lo.
struct Interval {
  double lo = 0.0, hi = 0.0;
  double size() const { return hi - lo; }
};

/// The union: sorted, apart from each other by more than `touching`. Intervals that touch within it
/// are one, and what lies between them is in it. O(n log n).
std::vector<Interval> joined(std::vector<Interval> intervals, double touching);

/// How far two intervals are apart; 0 if they meet.
double distance(const Interval& a, const Interval& b);

/// Together, the sizes of intervals.
double total(const std::vector<Interval>& intervals);

}  // namespace planish
