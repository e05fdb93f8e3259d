#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace planish::connect_detail {

/// The values at one place of a convex piecewise linear function f and a convex piecewise linear
/// constraint g ≤ 0, each with a supporting slope.
struct Support {
  double value = 0.0, slope = 0.0;
  double excess = -1.0, excess_slope = 0.0;
};

struct Minimum {
  double at = 0.0, value = 0.0;
};

struct LineSearch {
  double start = 0.0;
  double step = 1.0;         ///< first step when looking for a bracket
  double value_noise = 0.0;  ///< differences of f and g below this are rounding
  double slope_noise = 0.0;  ///< slopes below this are zero
};

/// Minimises f subject to g ≤ 0, exactly up to rounding: the next place to try is where two
/// supporting lines meet (Kelley's cutting planes in one variable, which end after finitely many
/// lines). Of several minima the one nearest to zero. Empty if g > 0 everywhere. `support(x)` gives
/// a Support.
template <typename Function>
std::optional<Minimum> minimum(const Function& support, const LineSearch& search) {
  struct Side {
    double at = 0.0;
    Support line;
    bool known = false;
    bool feasible = false;
  };
  Side left, right;
  std::optional<Minimum> best;
  constexpr double kResolution = 1e-11;
  constexpr int kMostSteps = 400;  // doublings and cuts; far more than any chain of corners needs
  double x = search.start, step = search.step;
  for (int i = 0; i < kMostSteps; ++i) {
    const Support here = support(x);
    const bool feasible = here.excess <= search.value_noise;
    double slope = feasible ? here.slope : here.excess_slope;
    if (feasible) {
      const bool lower = !best || here.value < best->value - search.value_noise;
      const bool nearer = best && here.value <= best->value + search.value_noise &&
                          std::abs(x) < std::abs(best->at);
      if (lower || nearer) best = Minimum{x, here.value};
      // Flat: continue towards zero, where the flat part may end.
      if (std::abs(slope) <= search.slope_noise) {
        if (x == 0.0) return best;
        slope = std::copysign(search.slope_noise, x);
      }
    } else if (std::abs(slope) <= search.slope_noise) {
      return best;  // g is least here, and above zero
    }
    Side& side = slope < 0.0 ? left : right;
    side = {x, here, true, feasible};
    if (feasible && std::abs(here.slope) <= search.slope_noise) side.line.slope = 0.0;

    if (!left.known || !right.known) {
      x += slope < 0.0 ? step : -step;
      step *= 2.0;
      continue;
    }
    // The nearest place at which an infeasible side's constraint can end.
    const auto end_of = [](const Side& s) { return s.at - s.line.excess / s.line.excess_slope; };
    const double low = left.feasible ? left.at : end_of(left);
    const double high = right.feasible ? right.at : end_of(right);
    const double gap = high - low;
    const double resolution = 4.0 * std::numeric_limits<double>::epsilon() *
                              std::max(std::abs(low), std::abs(high));
    if (gap < -resolution && !(left.feasible && right.feasible)) {
      if (gap < -1e3 * resolution || best) return best;
    }
    double next = 0.0;
    if (!left.feasible && low > left.at + resolution) {
      next = low;
    } else if (!right.feasible && high < right.at - resolution) {
      next = high;
    } else if (left.feasible && right.feasible) {
      const double across = left.line.slope - right.line.slope;
      if (across == 0.0) return best;
      next = (right.line.value - left.line.value + left.line.slope * left.at -
              right.line.slope * right.at) /
             across;
      // f is nowhere below both lines, and they are steep enough to locate its minimum.
      const double least = left.line.value + left.line.slope * (next - left.at);
      const double flatter = std::min(-left.line.slope, right.line.slope);
      if (best->value - least <= search.value_noise && flatter * kResolution > search.value_noise)
        return best;
    } else {
      return best;  // the minimum is where the constraint begins
    }
    if (!(next > left.at + resolution) || !(next < right.at - resolution)) return best;
    x = next;
  }
  return best;
}

}  // namespace planish::connect_detail
