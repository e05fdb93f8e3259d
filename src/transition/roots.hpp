#pragma once

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {

/// Where f is zero between a and b, f(a) and f(b) of different signs or nearly zero; exact to
/// rounding. `f` gives the value and its derivative.
template <typename Function>
double root_between(const Function& f, double a, double b) {
  auto fa = f(a), fb = f(b);
  if (fa.first == 0.0) return a;
  if (fb.first == 0.0) return b;
  if ((fa.first > 0.0) == (fb.first > 0.0)) return std::abs(fa.first) < std::abs(fb.first) ? a : b;
  const bool rising = fb.first > 0.0;
  double x = a + (b - a) * fa.first / (fa.first - fb.first);
  constexpr double kNarrow = 1e-16, kStill = 4e-16;  // half an ε and two: no step is left
  constexpr int kMostSteps = 200;                    // bisection alone would take 60
  for (int i = 0; i < kMostSteps; ++i) {
    const auto [value, slope] = f(x);
    if (value == 0.0) return x;
    ((value > 0.0) == rising ? b : a) = x;
    double next = x - value / slope;
    if (!(next > std::min(a, b)) || !(next < std::max(a, b))) next = 0.5 * (a + b);
    if (next == x || std::abs(b - a) <= kNarrow * std::max(std::abs(a), std::abs(b))) return next;
    if (std::abs(next - x) <= kStill * std::max(std::abs(x), tolerance::kTiniest)) return next;
    x = next;
  }
  return x;
}

/// Where f falls through zero between a and b. A convex curve has two tangents through a point, one
/// where f falls and one where it rises, and near the curve both may lie between a and b: then the
/// interval is divided until f falls in a part.
template <typename Function>
double falling_root(const Function& f, double a, double b) {
  constexpr int kFinest = 256;
  for (int parts = 1; parts <= kFinest; parts *= 4)
    for (int i = 0; i < parts; ++i) {
      const double low = std::lerp(a, b, i / double(parts)),
                   high = std::lerp(a, b, (i + 1) / double(parts));
      if (f(low).first >= 0.0 && f(high).first <= 0.0) return root_between(f, low, high);
    }
  return root_between(f, a, b);
}

}  // namespace planish::transition_detail
