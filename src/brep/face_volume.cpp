#include "face_volume.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/quadrature.hpp>

#include <cmath>

// A face's share of the solid's volume, ⅓∫(x − c)·n dA. By Green's theorem the integral over a
// plane, cylinder or cone becomes a sum along its borders, in closed form on lines and circles
// about the axis and by adaptive Gauss rules on others. A loop must be closed for that, so gaps
// between edges, which files of loose tolerance have, are closed by straight ways.

namespace planish::brep {
namespace {

/// A differential form along a border: `form` takes a point x and its derivative.
template <typename Form>
double integral(const SpaceCurve& curve, const Form& form, double error) {
  const auto at = [&](double t) { return form(curve.point(t), curve.derivative(t)); };
  // Quarters first: a symmetric integrand must not look constant.
  constexpr int kParts = 4;
  const double step = (curve.t1 - curve.t0) / kParts;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i)
    sum += adaptive_gauss(at, curve.t0 + i * step, curve.t0 + (i + 1) * step, error);
  return sum;
}

/// ½ n·∮(x − from) × dx: the signed area that the border sweeps about `from`.
double swept_area(const SpaceCurve& curve, const Vec3& from, const Vec3& normal, double error) {
  if (curve.kind == SpaceCurve::Kind::line)
    return normal.dot((curve.start - from).cross(curve.end - from)) / 2;
  if (curve.kind == SpaceCurve::Kind::circle) {
    const Vec3 centre = curve.circle.origin - from;
    const double tilt = curve.circle.z.dot(normal);
    return (normal.dot(centre.cross(curve.end - curve.start)) +
            tilt * curve.radius * curve.radius * (curve.t1 - curve.t0)) /
           2;
  }
  return integral(
             curve, [&](const Vec3& x, const Vec3& dx) { return normal.dot((x - from).cross(dx)); },
             error) /
         2;
}

/// −∮ v (R + (O − c)·e) e_u·dx with O, R the cylinder's, v the height, e the radial direction and
/// e_u the one round: ∫(x − c)·n dA with ∂/∂v undone.
double cylinder_form(const SpaceCurve& curve, const Cylinder& cylinder, const Vec3& centre,
                     double error) {
  const Frame& frame = cylinder.frame;
  const Vec3 offset = frame.origin - centre;
  const auto form = [&](const Vec3& x, const Vec3& dx) {
    const double v = (x - frame.origin).dot(frame.z);
    const Vec3 e = (x - frame.origin - v * frame.z).normalized();
    return -v * (cylinder.radius + offset.dot(e)) * frame.z.cross(e).dot(dx);
  };
  return integral(curve, form, error);
}

/// −∮ ½ v (A − c)·n e_u·dx with A the apex, v the distance from it and n the normal.
double cone_form(const SpaceCurve& curve, const Cone& cone, const Vec3& centre, double error) {
  const Frame& frame = cone.frame;
  const Vec3 offset = frame.origin - centre;
  const double s = std::sin(cone.half_angle);
  const double c = std::cos(cone.half_angle);
  const auto form = [&](const Vec3& x, const Vec3& dx) {
    const Vec3 from_apex = x - frame.origin;
    const double height = from_apex.dot(frame.z);
    const Vec3 e = (from_apex - height * frame.z).normalized();
    return -from_apex.norm() / 2 * offset.dot(c * e - s * frame.z) * frame.z.cross(e).dot(dx);
  };
  return integral(curve, form, error);
}

/// The way from the end of one edge of a loop to the start of the next. Files of loose tolerance
/// leave gaps there, and the borders must be closed.
SpaceCurve gap_between(const SolidModel& model, const CoEdge& use, const CoEdge& next) {
  const SpaceCurve& from = model.edges[use.edge].curve;
  const SpaceCurve& to = model.edges[next.edge].curve;
  SpaceCurve gap;
  gap.kind = SpaceCurve::Kind::line;
  gap.start = use.forward ? from.end : from.start;
  gap.end = next.forward ? to.start : to.end;
  return gap;
}

}  // namespace

bool has_border_volume(const SolidFace& face) {
  if (std::holds_alternative<Frame>(face.surface)) return true;
  const auto* surface = std::get_if<Developable>(&face.surface);
  return surface && !std::holds_alternative<Ruled>(*surface) && face.fitted == 0.0;
}

double volume_of(const SolidModel& model) { return sum_of(model.faces, &SolidFace::volume); }

double volume_under(const SolidFace& face, const SolidModel& model) {
  const Vec3& centre = model.centre;
  const double area_error = tolerance::kRounding * model.size * model.size;
  const double error = area_error * model.size;
  const auto along_borders = [&](const auto& form) {
    double sum = 0.0;
    for (const auto& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const double part = form(model.edges[loop[i].edge].curve);
        sum += loop[i].forward ? part : -part;
        const SpaceCurve gap = gap_between(model, loop[i], loop[(i + 1) % loop.size()]);
        if ((gap.end - gap.start).norm() > tolerance::kRounding * model.size) sum += form(gap);
      }
    return sum;
  };
  if (const auto* plane = std::get_if<Frame>(&face.surface)) {
    const double area = along_borders([&](const SpaceCurve& curve) {
      return swept_area(curve, plane->origin, plane->z, area_error);
    });
    return area * (plane->origin - centre).dot(plane->z) / 3;
  }
  const auto& surface = std::get<Developable>(face.surface);
  if (const auto* cylinder = std::get_if<Cylinder>(&surface))
    return along_borders([&](const SpaceCurve& curve) {
             return cylinder_form(curve, *cylinder, centre, error);
           }) /
           3;
  const auto* cone = std::get_if<Cone>(&surface);
  PLANISH_ASSERT(cone != nullptr);
  return along_borders(
             [&](const SpaceCurve& curve) { return cone_form(curve, *cone, centre, error); }) /
         3;
}

}  // namespace planish::brep
