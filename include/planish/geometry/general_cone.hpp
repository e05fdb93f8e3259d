#pragma once

#include <planish/geometry/developable.hpp>

#include <functional>

namespace planish {

/// A point of a curve in space, with the first and second derivative by the curve's parameter.
struct SpaceCurvePoint {
  Vec3 point, derivative;
  Vec3 second;
};
using SpaceCurve = std::function<SpaceCurvePoint(double)>;

/// The general cone with its apex at `apex` over the part t0 … t1 of a curve c
/// (math.md#general-cone), which a loft or a transition needs where it is neither a plane nor a
/// right cone. u is the curve's parameter; v = 0 lies on the curve, v grows away from the apex,
/// which is at v = −|c(u) − apex|. The normal is that of c′ × (c − apex): seen from its tip, with
/// the apex below, c runs to the right. Accuracy: between the apex and the curve, points are within
/// `tolerance` (mm) of the cone's points at the same (u, v), and within three times that as far
/// again beyond the curve; normals are within (tolerance / s)^¾ radians, s the largest distance of
/// the curve from the apex. Knots are placed by halving, 4096 intervals at most; below about 1e-13
/// s rounding limits the accuracy. Requires: t0 < t1; tolerance > 0; c twice differentiable, its
/// tangents nowhere through the apex. Cost: about 10 evaluations of the curve per interval;
/// intervals grow with (s / tolerance)^¼.
Ruled cone_over(const Vec3& apex, const SpaceCurve& curve, double t0, double t1, double tolerance);

/// The elliptic arc over [0, 1] from p0 to p1 that touches at its ends the lines to
/// `tangent_point`: the affine image of the circular arc that turns as much as the lines do. It is
/// circular if p0 and p1 are equally far from `tangent_point`, and affine maps preserve it.
/// Requires: the three points are not on one line.
SpaceCurve conic_arc(const Vec3& p0, const Vec3& tangent_point, const Vec3& p1);

}  // namespace planish
