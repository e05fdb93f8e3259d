#pragma once

#include "convex_boundary.hpp"

#include <planish/base/result.hpp>

#include <array>
#include <vector>

namespace planish::transition_detail {

/// A stretch of one boundary: a part t0 … t1 of an element's curve, or a point if both are equal.
struct Stretch {
  int element = 0;
  double t0 = 0.0, t1 = 0.0;
  bool moves() const { return t0 != t1; }
};

/// A part of the lateral hull between two rulings. Planes: an edge on one side or on both; the
/// tangent plane stands still. Others: the plane turns; a cone if one side stands still.
struct HullPatch {
  bool plane = false;
  std::array<Stretch, 2> sides;
  /// Parameters of rulings along it, from the first to the last, between which neither side turns
  /// far.
  std::vector<std::array<double, 2>> stops;
};

/// The two boundaries, and the patches in order, once around. Between two consecutive planes the
/// surface is folded sharply.
struct Hull {
  std::array<Boundary, 2> boundaries;
  std::vector<HullPatch> patches;

  const Element& element(int side, const Stretch& stretch) const {
    return boundaries[side].element(stretch.element);
  }
  Vec3 point(int side, const Stretch& stretch, double t) const {
    return element(side, stretch).curve(t).point;
  }
};

/// The lateral boundary of the convex hull (math.md#lateral-hull): planes that touch both
/// boundaries, found by carrying the tangent lines at the ends of each element over to the other
/// side. Boundary 0's axis points to boundary 1, boundary 1's away from boundary 0. `size` is their
/// extent. Errors: `profiles_meet`, `profile_hidden`.
Result<Hull> lateral_hull(Boundary first, Boundary second, double size);

/// det(T₁, T₂, q − p): zero where tangents at p and q lie in one plane, positive where q is ahead
/// of the plane that touches p.
double ahead(const SpaceCurvePoint& p, const SpaceCurvePoint& q);

}  // namespace planish::transition_detail
