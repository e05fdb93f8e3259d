// Cylinders, right cones and general developables as one: points, normals and rulings in (u, v),
// their development into the plane and back (math.md#development). What is developed is the surface
// at an offset, the neutral one; lengths along it are kept exactly.

#include "planar.hpp"
#include "ruled.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/developable.hpp>
#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Cylinder, cone and ruled surface: points, normals, parameters, and the isometry to the plane
// (math.md#development). A cylinder unrolls to (ρu, v), a cone to polar coordinates in which the
// azimuth shrinks by the sine of the half-angle; ruled surfaces integrate theirs (ruled.cpp).
// Images of straight (u, v) curves are kept exact where the isometry is linear or makes an arc;
// everything else is fitted span by span, because the speed along a spline jumps between spans.

namespace planish {
namespace {

using namespace geometry_detail;

/// Away from the z axis at azimuth u.
Vec3 radial(const Frame& frame, double u) { return std::cos(u) * frame.x + std::sin(u) * frame.y; }

/// `angle` plus the multiple of `period` that brings it nearest to `near`.
double nearest_turn(double angle, double period, double near) {
  return angle + period * std::round((near - angle) / period);
}

/// Azimuth of a point of the frame's xy plane; on the axis, where it is arbitrary, u_near.
double azimuth(double x, double y, double u_near) {
  if (x == 0.0 && y == 0.0) return u_near;
  return nearest_turn(std::atan2(y, x), 2.0 * std::numbers::pi, u_near);
}

/// Whether a coordinate that runs from a to b is constant up to rounding.
bool constant(double a, double b) {
  return std::abs(b - a) <= tolerance::kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

std::vector<Curve2> spans_of(const Curve2& curve) {
  const auto* spline = std::get_if<CubicSpline>(&curve);
  if (spline == nullptr) return {curve};
  std::vector<Curve2> spans;
  for (auto pole = spline->poles.begin(); spline->poles.end() - pole > 3; pole += 3)
    spans.emplace_back(CubicSpline{{pole, pole + 4}});
  return spans;
}

CubicSpline fitted_image(const Development& image, const Curve2& uv_curve, double tolerance) {
  CubicSpline result;
  // Span by span, because the speed along a spline jumps between spans.
  for (const Curve2& span : spans_of(uv_curve)) {
    const auto sample = [&](double t) -> CurveSample {
      const Vec2 uv = point_at(span, t);
      return {image.develop(uv), image.jacobian(uv) * derivative_at(span, t)};
    };
    const std::vector<Vec2> poles = fit_cubics(sample, 0.0, 1.0, tolerance).spline.poles;
    result.poles.insert(result.poles.end(), poles.begin() + (result.poles.empty() ? 0 : 1),
                        poles.end());
  }
  return result;
}

}  // namespace

Vec3 normal_on(const Developable& surface, double u) {
  return std::visit(Overloaded{[&](const Cylinder& c) -> Vec3 { return radial(c.frame, u); },
                               [&](const Cone& c) -> Vec3 {
                                 return std::cos(c.half_angle) * radial(c.frame, u) -
                                        std::sin(c.half_angle) * c.frame.z;
                               },
                               [&](const Ruled& r) -> Vec3 { return frame_at(r, u).n; }},
                    surface);
}

Vec3 ruling_on(const Developable& surface, double u) {
  return std::visit(Overloaded{[&](const Cylinder& c) -> Vec3 { return c.frame.z; },
                               [&](const Cone& c) -> Vec3 {
                                 return std::sin(c.half_angle) * radial(c.frame, u) +
                                        std::cos(c.half_angle) * c.frame.z;
                               },
                               [&](const Ruled& r) -> Vec3 { return frame_at(r, u).g; }},
                    surface);
}

Vec3 point_on(const Developable& surface, const Vec2& uv, double offset) {
  const double u = uv.x();
  const double v = uv.y();
  return std::visit(
      Overloaded{[&](const Cylinder& c) -> Vec3 {
                   return c.frame.origin + (c.radius + offset) * radial(c.frame, u) + v * c.frame.z;
                 },
                 [&](const Cone& c) -> Vec3 {
                   return c.frame.origin + v * ruling_on(c, u) + offset * normal_on(c, u);
                 },
                 [&](const Ruled& r) -> Vec3 {
                   const RulingFrame f = frame_at(r, u);
                   return f.b + v * f.g + offset * f.n;
                 }},
      surface);
}

Vec2 parameters_of(const Developable& surface, const Vec3& p, double u_near) {
  return std::visit(Overloaded{[&](const Cylinder& c) -> Vec2 {
                                 const Vec3 q = c.frame.local(p);
                                 return {azimuth(q.x(), q.y(), u_near), q.z()};
                               },
                               [&](const Cone& c) -> Vec2 {
                                 const Vec3 q = c.frame.local(p);
                                 const double along = std::hypot(q.x(), q.y()) *
                                                          std::sin(c.half_angle) +
                                                      q.z() * std::cos(c.half_angle);
                                 return {azimuth(q.x(), q.y(), u_near), std::max(0.0, along)};
                               },
                               [&](const Ruled& r) -> Vec2 { return nearest_on(r, p, u_near); }},
                    surface);
}

Development::Development(const Developable& surface, double offset, double u_near)
    : image_(std::visit([&](const auto& s) { return image_of(s, offset, u_near); }, surface)) {}

Development::Image Development::image_of(const Cylinder& cylinder, double offset, double) {
  PLANISH_ASSERT(cylinder.radius + offset > 0.0);
  return Rolled{cylinder.radius + offset};
}

Development::Image Development::image_of(const Cone& cone, double offset, double u_near) {
  PLANISH_ASSERT(cone.half_angle > 0.0 && cone.half_angle < 0.5 * std::numbers::pi);
  return Sector{std::sin(cone.half_angle), offset / std::tan(cone.half_angle), u_near};
}

Development::Image Development::image_of(const Ruled& ruled, double offset, double) {
  return std::make_shared<const RuledImage>(ruled, offset);
}

Vec2 Development::develop(const Vec2& uv) const {
  const double u = uv.x();
  const double v = uv.y();
  return std::visit(
      Overloaded{[&](const Rolled& rolled) -> Vec2 {
                   return {rolled.radius * u, v};
                 },
                 [&](const Sector& sector) -> Vec2 {
                   // Clockwise: the direction of growing azimuth about the apex, seen from outside.
                   const double angle = -u * sector.sine;
                   return (v + sector.shift) * Vec2(std::cos(angle), std::sin(angle));
                 },
                 [&](const Unrolled& unrolled) -> Vec2 { return unrolled->develop(uv); }},
      image_);
}

Vec2 Development::fold(const Vec2& p) const {
  return std::visit(
      Overloaded{[&](const Rolled& rolled) -> Vec2 {
                   return {p.x() / rolled.radius, p.y()};
                 },
                 [&](const Sector& sector) -> Vec2 {
                   const double u = -std::atan2(p.y(), p.x()) / sector.sine;
                   const double full_turn = 2.0 * std::numbers::pi / sector.sine;
                   return {nearest_turn(u, full_turn, sector.u_near), p.norm() - sector.shift};
                 },
                 [&](const Unrolled& unrolled) -> Vec2 { return unrolled->fold(p); }},
      image_);
}

Eigen::Matrix2d Development::jacobian(const Vec2& uv) const {
  const double u = uv.x();
  const double v = uv.y();
  return std::visit(
      Overloaded{
          [&](const Rolled& rolled) -> Eigen::Matrix2d {
            return Eigen::Vector2d(rolled.radius, 1.0).asDiagonal();
          },
          [&](const Sector& sector) -> Eigen::Matrix2d {
            const double angle = -u * sector.sine;
            const Vec2 along(std::cos(angle), std::sin(angle));
            Eigen::Matrix2d result;
            result.col(0) = (v + sector.shift) * sector.sine * Vec2(along.y(), -along.x());
            result.col(1) = along;
            return result;
          },
          [&](const Unrolled& unrolled) -> Eigen::Matrix2d { return unrolled->jacobian(uv); }},
      image_);
}

Curve2 Development::develop(const Curve2& uv_curve, double tolerance) const {
  const auto* line = std::get_if<Segment>(&uv_curve);
  const auto* spline = std::get_if<CubicSpline>(&uv_curve);
  const bool linear = std::holds_alternative<Rolled>(image_);

  if (line != nullptr && (linear || constant(line->a.x(), line->b.x())))
    return Segment{develop(line->a), develop(line->b)};

  if (spline != nullptr && linear) {
    CubicSpline result;
    for (const Vec2& pole : spline->poles)
      result.poles.push_back(develop(pole));
    return result;
  }

  const auto* sector = std::get_if<Sector>(&image_);
  if (line != nullptr && sector != nullptr && constant(line->a.y(), line->b.y()))
    return Arc{Vec2::Zero(), line->a.y() + sector->shift, -line->a.x() * sector->sine,
               -(line->b.x() - line->a.x()) * sector->sine};

  return fitted_image(*this, uv_curve, tolerance);
}

}  // namespace planish
