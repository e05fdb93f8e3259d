#include "exact_curve.hpp"

#include <cmath>
#include <numbers>
#include <optional>

// Splines that are lines or circles, as many systems write them. A line must be followed without
// turning back; a circle goes through three points of the curve, and the rest must lie on it and
// turn one way. Both are compared at evenly spread probes, a check that real edges, which do not
// wave between them, pass only if they are what they seem.

namespace planish::brep {
namespace {

constexpr int kProbes = 12;

Vec3 point_at_share(const SpaceCurve& curve, double share) {
  return curve.point(curve.t0 + (curve.t1 - curve.t0) * share);
}

bool is_straight(const SpaceCurve& curve, double tolerance) {
  const Vec3 chord = curve.end - curve.start;
  if (chord.norm() <= tolerance) return false;
  const Vec3 along = chord.normalized();
  double reached = 0.0;
  for (int i = 1; i < kProbes; ++i) {
    const Vec3 d = curve.point(curve.t0 + (curve.t1 - curve.t0) * i / kProbes) - curve.start;
    if ((d - d.dot(along) * along).norm() > tolerance || d.dot(along) < reached) return false;
    reached = d.dot(along);
  }
  return true;
}

/// The circle through three points of the curve, starting at its start; its end is not set yet.
/// Empty when the points lie on a line.
std::optional<SpaceCurve> circle_through(const SpaceCurve& curve, double tolerance) {
  const Vec3 a = point_at_share(curve, 0.0);
  const Vec3 u = point_at_share(curve, 1.0 / 3) - a;
  const Vec3 v = point_at_share(curve, 2.0 / 3) - a;
  const Vec3 n = u.cross(v);
  if (n.norm() <= tolerance * std::max(u.norm(), v.norm())) return {};
  const Vec3 centre = a + (v.squaredNorm() * n.cross(u) - u.squaredNorm() * n.cross(v)) /
                              (2 * n.squaredNorm());
  SpaceCurve circle = curve;
  circle.kind = SpaceCurve::Kind::circle;
  circle.circle = frame_from_axes(centre, n.normalized(), a - centre);
  circle.radius = (a - centre).norm();
  circle.t0 = 0.0;
  return circle;
}

/// The circle through three points of the curve, when the others lie on it and turn one way.
std::optional<SpaceCurve> as_circle(const SpaceCurve& curve, double tolerance) {
  auto circle = circle_through(curve, tolerance);
  if (!circle) return {};
  double angle = 0.0;
  for (int i = 1; i <= kProbes; ++i) {
    const Vec3 local = circle->circle.local(
        point_at_share(curve, static_cast<double>(i) / kProbes));
    if (std::hypot(local.head<2>().norm() - circle->radius, local.z()) > tolerance) return {};
    double next = std::atan2(local.y(), local.x());
    while (next < angle)
      next += 2 * std::numbers::pi;
    if (next - angle > std::numbers::pi) return {};
    angle = next;
  }
  const bool closed = (curve.end - curve.start).norm() <= tolerance;
  circle->t1 = closed ? 2 * std::numbers::pi : angle;
  return circle;
}

}  // namespace

SpaceCurve exact_curve(SpaceCurve curve, double tolerance) {
  if (curve.kind != SpaceCurve::Kind::other) return curve;
  if (is_straight(curve, tolerance)) {
    curve.kind = SpaceCurve::Kind::line;
    return curve;
  }
  if (auto circle = as_circle(curve, tolerance)) return *circle;
  return curve;
}

}  // namespace planish::brep
