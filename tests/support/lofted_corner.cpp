#include "support/sheets.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planish::test {
namespace {

constexpr double surface_tolerance = 1e-8;  // mm

/// The plane that touches the cone along the ruling at u: y along the ruling, x towards growing u,
/// z as the cone's normal.
Frame tangent_plane(const LoftedCorner& corner, const Developable& cone, double u) {
  const Vec3 y = ruling_on(cone, u), z = normal_on(cone, u);
  return {corner.apex, y.cross(z), y, z};
}

/// The end near the apex, run with the arc, in (u, v).
CubicSpline near_border(const LoftedCorner& corner) {
  const SpaceCurve arc = corner.arc();
  const auto at = [&](double u) -> CurveSample {
    const SpaceCurvePoint c = arc(u);
    const Vec3 arm = c.point - corner.apex;
    const double cut = corner.near - 1.0;
    return {{u, cut * arm.norm()}, {1.0, cut * c.derivative.dot(arm.normalized())}};
  };
  return fit_cubics(at, 0.0, 1.0, surface_tolerance).spline;
}

/// Signed radius of curvature across the ruling at u, on the reference skin at its near end:
/// positive when that skin is the inside one.
double near_radius(const LoftedCorner& corner, double u) {
  const SpaceCurvePoint c = corner.arc()(u);
  const Vec3 g = (c.point - corner.apex).normalized();
  const Vec3 n = c.derivative.cross(g).normalized(), across = g.cross(n);
  const double speed = c.derivative.dot(across);
  return corner.near * speed * speed / c.second.dot(n);
}

Bend bend_of(const LoftedCorner& corner, const Developable& cone) {
  constexpr int samples = 2000;
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i)
    smallest = std::min(smallest, std::abs(near_radius(corner, double(i) / samples)));
  const bool inside = near_radius(corner, 0.5) > 0.0;
  const double cosine = normal_on(cone, 0.0).dot(normal_on(cone, 1.0));
  return {BendKind::general,
          {},
          Angle::radians(std::acos(cosine)),
          inside ? smallest : std::max(0.0, smallest - corner.thickness),
          inside};
}

}  // namespace

LoftedCorner other_side(LoftedCorner corner) {
  std::swap(corner.p0, corner.p1);
  return corner;
}

Sheet lofted_corner(const LoftedCorner& corner) {
  const SpaceCurve arc = corner.arc();
  const Developable cone = cone_over(corner.apex, arc, 0.0, 1.0, surface_tolerance);
  const double r0 = (corner.p0 - corner.apex).norm(), r1 = (corner.p1 - corner.apex).norm();
  const double k = corner.near, w = corner.width;
  SheetBuilder builder(corner.thickness);
  const FaceId first = builder.flange(
      tangent_plane(corner, cone, 0.0),
      {polygon({{0, k * r0}, {0, r0}, {-w, r0}, {-k * w, k * r0}})});
  const FaceId second = builder.flange(tangent_plane(corner, cone, 1.0),
                                       {polygon({{0, r1}, {0, k * r1}, {k * w, k * r1}, {w, r1}})});
  const CubicSpline near = near_border(corner);
  const FaceId bend = builder.bend_face(
      builder.new_bend(bend_of(corner, cone)), cone, 1,
      {{near, Segment{end_of(Curve2(near)), {1, 0}}, Segment{{1, 0}, {0, 0}},
        Segment{{0, 0}, start_of(Curve2(near))}}});
  builder.join({first, 0, 0}, {bend, 0, 3});
  builder.join({bend, 0, 1}, {second, 0, 0});
  return builder.finish();
}

}  // namespace planish::test
