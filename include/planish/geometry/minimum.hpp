#pragma once

#include <algorithm>

namespace planish {

/// Where f is least from a to b: the best of `samples` + 1 even places, then golden section about
/// it, of which each step leaves 0.618 of the interval. It can only miss a second place that is
/// equally low.
template <typename Function>
double least_at(const Function& f, double a, double b, int samples, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  const auto place = [&](int i) { return a + (b - a) * i / samples; };
  int best = 0;
  double least = f(a);
  for (int i = 1; i <= samples; ++i)
    if (const double value = f(place(i)); value < least) least = value, best = i;
  double low = place(std::max(best - 1, 0)), high = place(std::min(best + 1, samples));
  for (int step = 0; step < steps; ++step) {
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    const bool falls = f(right) <= f(left);
    (falls ? low : high) = falls ? left : right;
  }
  const double middle = 0.5 * (low + high);
  return f(middle) < least ? middle : place(best);
}

}  // namespace planish
