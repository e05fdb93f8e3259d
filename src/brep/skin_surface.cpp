#include "border_curve.hpp"
#include "fitted_curve.hpp"
#include "kernel_points.hpp"
#include "ruling_range.hpp"

#include <planish/base/tolerance.hpp>

#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

// The kernel's surface for a face, or for its offset below: planes, cylinders and cones exactly,
// ruled surfaces as B-splines over the part of the rulings in use (ruling_range.cpp). An offset
// keeps its rulings and (u, v) (math.md#neutral-surface), so one curve in the face's parameters is
// carried to every depth. The smallest radius tells whether an offset folds over.

namespace planish::brep {
namespace {

using Curve = Handle(Geom2d_Curve);

SkinSurface shifted(const Handle(Geom_Surface) & surface, double v_shift) {
  return {surface, [v_shift](const Curve& curve, double) {
            return Curve::DownCast(curve->Translated(gp_Vec2d(0.0, v_shift)));
          }};
}

SkinSurface surface_below(const Cylinder& cylinder, const Face& face, double depth, double) {
  return shifted(new Geom_CylindricalSurface(kernel_frame(cylinder.frame),
                                             cylinder.radius - face.sense * depth),
                 0.0);
}

SkinSurface surface_below(const Cone& cone, const Face& face, double depth, double) {
  const double sine = std::sin(cone.half_angle), cosine = std::cos(cone.half_angle);
  const double offset = -face.sense * depth;
  // The kernel's cone starts at a circle; at the face's nearer end this has a usable radius.
  const double near = parameter_box(face).lo.y();
  const Vec3 base = (near * cosine - offset * sine) * cone.frame.z;
  Frame frame = cone.frame;
  frame.origin += base;
  return shifted(
      new Geom_ConicalSurface(kernel_frame(frame), cone.half_angle, near * sine + offset * cosine),
      -near);
}

SkinSurface surface_below(const Ruled& ruled, const Face& face, double depth, double tolerance) {
  const Box2 box = parameter_box(face);
  std::vector<double> breaks{box.lo.x()};
  const double margin = tolerance::kComputed * box.size().x();
  for (const Ruled::Knot& knot : ruled.knots)
    if (knot.u > box.lo.x() + margin && knot.u < box.hi.x() - margin) breaks.push_back(knot.u);
  breaks.push_back(box.hi.x());
  const RulingRange range = ruling_range(face, depth);
  const auto rails = [&](double u) {
    Eigen::VectorXd both(6);
    both << point_below(face, {u, range.lo(u)}, depth), point_below(face, {u, range.hi(u)}, depth);
    return both;
  };
  const Handle(Geom_Surface)
      surface = ruled_surface(fit_path(rails, breaks, tolerance), box.lo.y(), box.hi.y());
  if (range.constant()) return shifted(surface, 0.0);
  return {surface, [=](const Curve& curve, double length) {
            return carried_into(range, curve, length, tolerance);
          }};
}

/// Radius of curvature across the ruling at a point of the reference skin, positive if it curves
/// towards the material; not positive if the skin itself folds over.
double radius_towards_material(const Face& face, const Vec2& uv) {
  constexpr double kNeverTight = std::numeric_limits<double>::infinity();
  constexpr double kDeeper = 1.0;  // mm; the speed is linear in the depth
  const double speed = speed_across(face, uv, 0.0);
  if (speed <= 0.0) return 0.0;
  const double loss = speed - speed_across(face, uv, kDeeper);
  return loss > 0.0 ? kDeeper * speed / loss : kNeverTight;
}

double smallest_ruled_radius(const Face& face, double depth) {
  constexpr int kBorderSamples = 32;
  double smallest = std::numeric_limits<double>::infinity();
  for (const BorderLoop& loop : face.loops)
    for (const Border& border : loop)
      for (int i = 0; i <= kBorderSamples; ++i)
        smallest = std::min(
            smallest, radius_towards_material(
                          face, point_at(border.curve, static_cast<double>(i) / kBorderSamples)));
  return smallest - depth;
}

}  // namespace

SkinSurface skin_surface(const Face& face, double depth, double tolerance) {
  if (const auto* frame = std::get_if<Frame>(&face.surface)) {
    Frame below = *frame;
    below.origin -= depth * below.z;
    return shifted(new Geom_Plane(kernel_frame(below)), 0.0);
  }
  return std::visit(
      [&](const auto& surface) { return surface_below(surface, face, depth, tolerance); },
      std::get<Developable>(face.surface));
}

double smallest_radius(const Face& face, double depth) {
  constexpr double kNeverTight = std::numeric_limits<double>::infinity();
  const auto* surface = std::get_if<Developable>(&face.surface);
  if (surface == nullptr) return kNeverTight;
  if (const auto* cylinder = std::get_if<Cylinder>(surface))
    return cylinder->radius - face.sense * depth;
  if (const auto* cone = std::get_if<Cone>(surface))
    return parameter_box(face).lo.y() * std::tan(cone->half_angle) - face.sense * depth;
  return smallest_ruled_radius(face, depth);
}

}  // namespace planish::brep
