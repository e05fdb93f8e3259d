#include "projection.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/quadrature.hpp>

// What a face covers of a plane, and the volume between both, from its borders alone. The flux of
// the height z through a face differs from that of a third of the position, which is known, by that
// of (−x, −y, 2z)/3, the curl of (−yz, xz, 0)/3.

namespace planish::brep {
namespace {

double green_area_of(const SpaceCurve& curve, const Frame& plane, double error) {
  const Vec2 start = plane.local2(curve.start);
  if (curve.kind == SpaceCurve::Kind::line) {
    const Vec2 end = plane.local2(curve.end);
    return (start.x() * end.y() - start.y() * end.x()) / 2;
  }
  const auto form = [&](double t) {
    const Vec2 p = plane.local2(curve.point(t));
    const Vec3 d = curve.derivative(t);
    return (p.x() * d.dot(plane.y) - p.y() * d.dot(plane.x)) / 2;
  };
  return adaptive_gauss(form, curve.t0, curve.t1, error);
}

/// The share of an edge in the integral of (−yz, xz, 0)/3 along borders, about a centre.
double circulation_of(const SpaceCurve& curve, const Frame& about, double error) {
  const auto form = [&](double t) {
    const Vec3 p = about.local(curve.point(t));
    const Vec3 d = curve.derivative(t);
    return p.z() * (p.x() * d.dot(about.y) - p.y() * d.dot(about.x)) / 3;
  };
  return adaptive_gauss(form, curve.t0, curve.t1, error);
}

}  // namespace

double projected_area(const SolidModel& model, int face, const Frame& plane) {
  const double error = tolerance::kRounding * model.size * model.size;
  double sum = 0.0;
  for (const auto& loop : model.faces[face].loops)
    for (const CoEdge& use : loop) {
      const double area = green_area_of(model.edges[use.edge].curve, plane, error);
      sum += use.forward ? area : -area;
    }
  return sum;
}

double volume_over(const SolidModel& model, int face, const Frame& plane) {
  const double error = tolerance::kRounding * model.size * model.size * model.size;
  Frame about = plane;
  about.origin = model.centre;
  double volume = model.faces[face].volume -
                  (plane.origin - model.centre).dot(plane.z) * projected_area(model, face, plane);
  for (const auto& loop : model.faces[face].loops)
    for (const CoEdge& use : loop) {
      const double share = circulation_of(model.edges[use.edge].curve, about, error);
      volume += use.forward ? share : -share;
    }
  return volume;
}

}  // namespace planish::brep
