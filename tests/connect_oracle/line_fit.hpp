#pragma once

#include "connect_oracle/milp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// What the mixed-integer programs and the linear ones for given corners have in common.

namespace planish::oracle {

inline constexpr double kNoBend = std::numeric_limits<double>::infinity();

/// Corners moved and scaled so that the solver's absolute tolerances mean the same for every pair:
/// their x lies in [−½, ½] · kSize.
struct Normal {
  static constexpr double kSize = 10.0;
  double centre = 0.0, scale = 1.0;

  explicit Normal(const Corners& corners) {
    double low = kNoBend, high = -kNoBend;
    for (const auto& side : corners)
      for (const Vec2& p : side) {
        low = std::min(low, p.x());
        high = std::max(high, p.x());
      }
    centre = 0.5 * (low + high);
    scale = kSize / (high - low);
  }
  Corners of(Corners corners) const {
    for (auto& side : corners)
      for (Vec2& p : side)
        p = scale * Vec2(p.x() - centre, p.y());
    return corners;
  }
  TangentLine back(double slope, double offset) const {
    return {slope, offset / scale + slope * centre};
  }
};

inline double most(const std::vector<Vec2>& corners) {
  double y = 0.0;
  for (const Vec2& p : corners)
    y = std::max(y, p.y());
  return y;
}

struct LineColumns {
  Column slope = 0, offset = 0;
  Linear height(double x) const { return x * Linear::of(slope) - Linear::of(offset); }
};

/// A height above the plate counts as extension for averted edges, one below it for facing ones.
inline double extension_sign(EdgeKind kind) { return kind == EdgeKind::facing ? 1.0 : -1.0; }

inline Linear extension(const LineColumns& line, EdgeKind kind, const Vec2& p) {
  return extension_sign(kind) * (p.y() - line.height(p.x()));
}

inline double shift_of(const Corners& c) {
  return std::abs(c[0].front().x() - c[1].front().x()) +
         std::abs(c[0].back().x() - c[1].back().x());
}

/// The best tangent line for given corners.
struct Fit {
  double cost = kNoBend;
  TangentLine line;
};

Fit length_fit(const Corners& corners, EdgeKind kind, double psi);
Fit span_fit(const Corners& corners, EdgeKind kind, double psi);

}  // namespace planish::oracle
