#include "tangent_program.hpp"

#include "convex_line.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The cheapest tangent line of two runs (math.md#tangent-lines). For a slope the best offset is at
// a bound, given by one corner of each run (run_envelope.cpp); with it the cost is convex and
// piecewise linear in the slope, and a line search along supporting lines ends at its vertex.
// Coordinates are taken about the middle of the corners, and noise is measured by their size.

namespace planish::connect_detail {
namespace {

// Rounding of sums of a few products of the size of the corners.
constexpr double kNoise = 64.0 * std::numeric_limits<double>::epsilon();
// How far a corner may lie on the wrong side of a given line, as a share of the corners' size.
constexpr double kGivenTolerance = tolerance::kComputed;

/// A function a + b·k that supports a convex one at some slope.
struct Linear {
  double at = 0.0, slope = 0.0;  // value there, and b
};

Linear larger(const Linear& a, const Linear& b) { return a.at >= b.at ? a : b; }

class Program {
 public:
  Program(const std::array<CornerRange, 2>& sides, EdgeKind kind, const TangentCost& cost,
          const GivenLine& given, double size, double origin)
      : sides_(sides),
        kind_(kind),
        cost_(cost),
        given_(given),
        noise_(kNoise * size),
        origin_(origin) {
    const double heights = (sides[0].empty() ? 0.0 : 1.0) + (sides[1].empty() ? 0.0 : 1.0);
    const double sign = kind == EdgeKind::facing ? 1.0 : -1.0;
    // Coefficient of q in the cost; its sign says at which bound the best offset is.
    of_offset_ = heights * (sign * cost.extension - cost.height) + cost.linear.y();
  }

  Support operator()(double k) const {
    const Linear low = lower_bound(k), high = upper_bound(k);
    Support support;
    Linear q;
    if (given_.offset || given_.apex) {
      q = given_offset(k);
      const Linear below{low.at - q.at, low.slope - q.slope},
          above{q.at - high.at, q.slope - high.slope};
      const Linear excess = larger(below, above);
      support.excess = excess.at - kGivenTolerance / kNoise * noise_;
      support.excess_slope = excess.slope;
    } else if (kind_ == EdgeKind::facing) {
      q = of_offset_ >= 0.0 ? low : high;
      support.excess = low.at - high.at;
      support.excess_slope = low.slope - high.slope;
    } else {
      q = high;
    }
    const Linear value = cost_at(k, q);
    support.value = value.at;
    support.slope = value.slope;
    return support;
  }

  // The offset for the slope, relative to the true origin.
  double offset(double k) const {
    const Linear q = given_.offset || given_.apex                     ? given_offset(k)
                     : kind_ == EdgeKind::facing && of_offset_ >= 0.0 ? lower_bound(k)
                                                                      : upper_bound(k);
    return q.at + k * origin_;
  }

 private:
  double x(const Vec2& p) const { return p.x() - origin_; }

  // max_j (k x_j − y_j) and max_j (y_j − k x_j) of one side.
  Linear under(const CornerRange& side, double k) const {
    const Vec2& p = side.chain->lowest(side.first, side.last, k);
    return {k * x(p) - p.y(), x(p)};
  }
  Linear over(const CornerRange& side, double k) const {
    const Vec2& p = side.chain->highest(side.first, side.last, k);
    return {p.y() - k * x(p), -x(p)};
  }
  // max_j and min_j of k x_j.
  Linear far(const CornerRange& side, double k) const {
    const double at = (k >= 0.0 ? side.right() : side.left()) - origin_;
    return {k * at, at};
  }
  Linear near(const CornerRange& side, double k) const {
    const double at = (k >= 0.0 ? side.left() : side.right()) - origin_;
    return {k * at, at};
  }

  template <typename Of>
  Linear largest(const Of& of) const {
    Linear most{-std::numeric_limits<double>::infinity(), 0.0};
    for (const CornerRange& side : sides_)
      if (!side.empty()) most = larger(most, of(side));
    return most;
  }

  // Facing: q ≥ k x − y. Averted lines have no lower bound.
  Linear lower_bound(double k) const {
    if (kind_ == EdgeKind::averted) return {-std::numeric_limits<double>::infinity(), 0.0};
    return largest([&](const CornerRange& side) { return under(side, k); });
  }
  // Facing: q ≤ k x; averted: q ≤ k x − y.
  Linear upper_bound(double k) const {
    const Linear negative = largest([&](const CornerRange& side) {
      if (kind_ == EdgeKind::averted) return over(side, k);
      const Linear least = near(side, k);
      return Linear{-least.at, -least.slope};
    });
    return {-negative.at, -negative.slope};
  }

  Linear given_offset(double k) const {
    if (given_.offset) return {*given_.offset - k * origin_, -origin_};
    return {k * (*given_.apex - origin_), *given_.apex - origin_};
  }

  Linear cost_at(double k, const Linear& q) const {
    Linear sum{cost_.linear.x() * k + of_offset_ * q.at, cost_.linear.x() + of_offset_ * q.slope};
    const auto add = [&](double weight, const Linear& term) {
      sum.at += weight * term.at;
      sum.slope += weight * term.slope;
    };
    for (const CornerRange& side : sides_) {
      if (side.empty()) continue;
      if (cost_.height != 0.0) add(cost_.height, far(side, k));
      if (cost_.extension != 0.0)
        add(cost_.extension, kind_ == EdgeKind::facing ? over(side, k) : under(side, k));
    }
    return sum;
  }

  const std::array<CornerRange, 2>& sides_;
  EdgeKind kind_;
  const TangentCost& cost_;
  const GivenLine& given_;
  double noise_;
  double origin_;
  double of_offset_ = 0.0;
};

double middle_of(const std::array<CornerRange, 2>& sides) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const CornerRange& side : sides) {
    if (side.empty()) continue;
    low = std::min(low, side.left());
    high = std::max(high, side.right());
  }
  return 0.5 * (low + high);
}

}  // namespace

double size_of(const std::array<CornerRange, 2>& sides) {
  const double middle = middle_of(sides);
  double size = 0.0;
  for (const CornerRange& side : sides)
    for (int i = side.first; i <= side.last; ++i) {
      const Vec2& p = side.chain->corners()[i];
      size = std::max({size, std::abs(p.x() - middle), std::abs(p.y())});
    }
  return size;
}

std::optional<TangentOptimum> cheapest_tangent(const std::array<CornerRange, 2>& sides,
                                               EdgeKind kind, const TangentCost& cost,
                                               const GivenLine& given, double size, double start) {
  const double origin = middle_of(sides);
  TangentCost centred = cost;
  // The linear part refers to the true origin: q = q′ + k·origin.
  centred.linear.x() += cost.linear.y() * origin;
  const Program program(sides, kind, centred, given, size, origin);
  if (given.slope) {
    const Support there = program(*given.slope);
    const bool both = given.offset || given.apex;
    const double slack = both ? 0.0 : kGivenTolerance * size;
    if (there.excess > slack) return std::nullopt;
    return TangentOptimum{{*given.slope, program.offset(*given.slope)}, there.value};
  }
  const double reach = std::max(std::abs(cost.linear.y()), std::max(cost.height, cost.extension));
  const double noise = kNoise * size * std::max(1.0, reach);
  const auto best = minimum(
      program, {.start = start, .step = 0.1, .value_noise = noise, .slope_noise = noise});
  if (!best) return std::nullopt;
  return TangentOptimum{{best->at, program.offset(best->at)}, best->value};
}

}  // namespace planish::connect_detail
