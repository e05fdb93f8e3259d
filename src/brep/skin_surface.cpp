#include "border_curve.hpp"
#include "fitted_curve.hpp"
#include "kernel_points.hpp"

#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish::brep {
namespace {

/// Extent of a face in (u, v).
Box2 extent(const Face& face) {
  Box2 box;
  for (const BorderLoop& loop : face.loops)
    for (const Border& border : loop)
      box.add(bounds(border.curve));
  return box;
}

SkinSurface surface_below(const Cylinder& cylinder, const Face& face, double depth, double) {
  return {new Geom_CylindricalSurface(kernel_frame(cylinder.frame),
                                      cylinder.radius - face.sense * depth),
          0.0};
}

SkinSurface surface_below(const Cone& cone, const Face& face, double depth, double) {
  const double sine = std::sin(cone.half_angle), cosine = std::cos(cone.half_angle);
  const double offset = -face.sense * depth;
  // The kernel's cone starts at a circle; through the face's nearer end it has a sound radius.
  const double near = extent(face).lo.y();
  const Vec3 base = (near * cosine - offset * sine) * cone.frame.z;
  Frame frame = cone.frame;
  frame.origin += base;
  return {
      new Geom_ConicalSurface(kernel_frame(frame), cone.half_angle, near * sine + offset * cosine),
      -near};
}

SkinSurface surface_below(const Ruled& ruled, const Face& face, double depth, double tolerance) {
  const Box2 box = extent(face);
  std::vector<double> breaks{box.lo.x()};
  const double margin = 1e-9 * box.size().x();
  for (const Ruled::Knot& knot : ruled.knots)
    if (knot.u > box.lo.x() + margin && knot.u < box.hi.x() - margin) breaks.push_back(knot.u);
  breaks.push_back(box.hi.x());
  const auto rails = [&](double u) {
    Eigen::VectorXd both(6);
    both << point_below(face, {u, box.lo.y()}, depth), point_below(face, {u, box.hi.y()}, depth);
    return both;
  };
  return {ruled_surface(fit_path(rails, breaks, tolerance), box.lo.y(), box.hi.y()), 0.0};
}

}  // namespace

SkinSurface skin_surface(const Face& face, double depth, double tolerance) {
  if (const auto* frame = std::get_if<Frame>(&face.surface)) {
    Frame below = *frame;
    below.origin -= depth * below.z;
    return {new Geom_Plane(kernel_frame(below)), 0.0};
  }
  return std::visit(
      [&](const auto& surface) { return surface_below(surface, face, depth, tolerance); },
      std::get<Developable>(face.surface));
}

double smallest_radius(const Face& face, double depth) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto* surface = std::get_if<Developable>(&face.surface);
  if (surface == nullptr) return infinite;
  if (const auto* cylinder = std::get_if<Cylinder>(surface))
    return cylinder->radius - face.sense * depth;
  if (const auto* cone = std::get_if<Cone>(surface))
    return extent(face).lo.y() * std::tan(cone->half_angle) - face.sense * depth;
  return infinite;
}

}  // namespace planish::brep
