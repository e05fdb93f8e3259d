#pragma once

#include "convex_boundary.hpp"

#include <planish/base/result.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace planish::transition_detail {

/// A stretch of one boundary: a part t0 … t1 of an element's curve, or the point that both are.
struct Stretch {
  int element = 0;
  double t0 = 0.0, t1 = 0.0;
  bool moves() const { return t0 != t1; }
};

/// A part of the lateral hull between two rulings. Planes: an edge on one side or on both, the tangent
/// plane stands still. Others: the plane turns; with one side standing still a cone.
struct HullPatch {
  bool plane = false;
  std::array<Stretch, 2> sides;
  /// Parameters of rulings along it, from the first to the last, between which neither side turns far.
  std::vector<std::array<double, 2>> stops;
};

/// The two boundaries and the patches in the order in which both run, once round. Between two planes that
/// follow each other the surface is folded sharply.
struct Hull {
  std::array<Boundary, 2> boundaries;
  std::vector<HullPatch> patches;

  const Element& element(int side, const Stretch& stretch) const {
    return boundaries[static_cast<std::size_t>(side)].element(stretch.element);
  }
  Vec3 point(int side, const Stretch& stretch, double t) const { return element(side, stretch).curve(t).point; }
};

/// The lateral boundary of the convex hull (MATH 5.3): planes that touch both boundaries, found by carrying
/// the tangent lines at the ends of each element over to the other side. Boundary 0's axis points to
/// boundary 1, boundary 1's away from boundary 0. `size` is their extent.
/// Errors: `profiles_meet`, `profile_hidden`.
Result<Hull> lateral_hull(Boundary first, Boundary second, double size);

/// det(T₁, T₂, q − p): zero where tangents at p and q lie in one plane, positive where q is ahead of the plane
/// that touches p.
double ahead(const SpaceCurvePoint& p, const SpaceCurvePoint& q);

/// Where f is zero between a and b, f(a) and f(b) of different signs or nearly zero; exact to rounding.
/// `f` gives the value and its derivative.
template <typename Function>
double root_between(const Function& f, double a, double b) {
  auto fa = f(a), fb = f(b);
  if (fa.first == 0.0) return a;
  if (fb.first == 0.0) return b;
  if ((fa.first > 0.0) == (fb.first > 0.0)) return std::abs(fa.first) < std::abs(fb.first) ? a : b;
  const bool rising = fb.first > 0.0;
  double x = a + (b - a) * fa.first / (fa.first - fb.first);
  constexpr int kMostSteps = 200;  // bisection alone would take 60
  for (int i = 0; i < kMostSteps; ++i) {
    const auto [value, slope] = f(x);
    if (value == 0.0) return x;
    ((value > 0.0) == rising ? b : a) = x;
    double next = x - value / slope;
    if (!(next > std::min(a, b)) || !(next < std::max(a, b))) next = 0.5 * (a + b);
    if (next == x || std::abs(b - a) <= 1e-16 * std::max(std::abs(a), std::abs(b))) return next;
    if (std::abs(next - x) <= 4e-16 * std::max(std::abs(x), 1e-300)) return next;
    x = next;
  }
  return x;
}

/// Where f falls through zero between a and b. Tangents of a convex curve through one point are two, where f
/// falls and where it rises, and close to the curve both may lie between a and b: then the interval is divided
/// until a part falls.
template <typename Function>
double falling_root(const Function& f, double a, double b) {
  constexpr int kFinest = 256;
  for (int parts = 1; parts <= kFinest; parts *= 4)
    for (int i = 0; i < parts; ++i) {
      const double low = std::lerp(a, b, i / double(parts)), high = std::lerp(a, b, (i + 1) / double(parts));
      if (f(low).first >= 0.0 && f(high).first <= 0.0) return root_between(f, low, high);
    }
  return root_between(f, a, b);
}

}  // namespace planish::transition_detail
