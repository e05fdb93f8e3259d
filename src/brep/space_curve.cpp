#include "solid_model.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/minimum.hpp>
#include <planish/geometry/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Points, lengths and distances of a solid's edges. Lines and circles have closed forms; of others
// the length is a Gauss integral, and the nearest point the best of samples, refined by golden
// section about it.

namespace planish::brep {
namespace {

double distance_to_circle(const SpaceCurve& curve, const Vec3& p) {
  const Vec3 local = curve.circle.local(p);
  double angle = std::atan2(local.y(), local.x());
  const double turn = 2 * std::numbers::pi;
  angle += turn * std::ceil((curve.t0 - angle) / turn);
  if (angle > curve.t1) return std::min((p - curve.start).norm(), (p - curve.end).norm());
  return std::hypot(local.head<2>().norm() - curve.radius, local.z());
}

double distance_to_other(const SpaceCurve& curve, const Vec3& p) {
  constexpr int kSamples = 64, kSteps = 40;
  const auto distance = [&](double t) { return (curve.point(t) - p).norm(); };
  return distance(least_at(distance, curve.t0, curve.t1, kSamples, kSteps));
}

}  // namespace

Vec3 SpaceCurve::point(double t) const {
  if (kind == Kind::line) return start + (t - t0) / (t1 - t0) * (end - start);
  if (kind == Kind::circle) return circle.point(radius * Vec2(std::cos(t), std::sin(t)));
  Vec3 point, derivative;
  evaluate(t, point, derivative);
  return point;
}

Vec3 SpaceCurve::derivative(double t) const {
  if (kind == Kind::line) return (end - start) / (t1 - t0);
  if (kind == Kind::circle) return radius * (-std::sin(t) * circle.x + std::cos(t) * circle.y);
  Vec3 point, derivative;
  evaluate(t, point, derivative);
  return derivative;
}

Vec3 SpaceCurve::tangent(double t) const { return derivative(t).normalized(); }

double SpaceCurve::length() const {
  if (kind == Kind::line) return (end - start).norm();
  if (kind == Kind::circle) return radius * (t1 - t0);
  const auto speed = [&](double t) {
    Vec3 point, derivative;
    evaluate(t, point, derivative);
    return derivative.norm();
  };
  const double whole = gauss(speed, t0, t1);
  return adaptive_gauss(speed, t0, t1, whole, tolerance::kRounding * std::abs(whole));
}

double SpaceCurve::distance(const Vec3& p) const {
  if (kind == Kind::circle) return distance_to_circle(*this, p);
  if (kind == Kind::other) return distance_to_other(*this, p);
  const Vec3 chord = end - start;
  const double share = std::clamp(
      (p - start).dot(chord) / std::max(chord.squaredNorm(), tolerance::kTiniest), 0.0, 1.0);
  return (p - start - share * chord).norm();
}

}  // namespace planish::brep
