#include "bend_surface.hpp"

#include <planish/geometry/fit.hpp>

#include <cmath>
#include <numbers>

// The mid-surface tangent to both plates along a line y = k x − q: a cylinder where k is 0
// (math.md#tangent-cylinder), a right cone with its apex where the height vanishes
// (math.md#tangent-cone), a half turn between parallel planes. The axis lies in the bisecting
// plane, and azimuths run from the first side through the middle of the bend to the other, so that
// they never pass the seam.

namespace planish::connect_detail {
namespace {

using Tangent = BendSurface::Tangent;

// Azimuth of `direction` about z, from x, in (−π, π].
double azimuth_of(const Frame& frame, const Vec3& direction) {
  return std::atan2(direction.dot(frame.y), direction.dot(frame.x));
}

// The frame about `axis` from whose x, on one of the sides, the azimuth grows through `middle` to
// the other side; `radial` are the directions from the axis to the tangent rulings.
Frame turned(BendSurface& surface, const Vec3& origin, const Vec3& axis,
             const std::array<Vec3, 2>& radial, const Vec3& middle) {
  Frame frame = frame_from_axes(origin, axis, radial[0]);
  if (azimuth_of(frame, middle) < 0.0) {
    surface.first = 1;
    frame = frame_from_axes(origin, axis, radial[1]);
  }
  surface.sweep = 2.0 * azimuth_of(frame, middle);
  return frame;
}

Vec3 bisector_of(const BendFrame& frame) { return (frame.e[0] + frame.e[1]).normalized(); }

BendSurface cylinder(const BendFrame& frame, EdgeKind edges, double distance) {
  const double half = 0.5 * frame.beta.radians();
  const Vec3 bisector = bisector_of(frame);
  const Vec3 center = frame.origin + distance / std::cos(half) * bisector;
  const double away = edges == EdgeKind::facing ? 1.0 : -1.0;
  BendSurface surface;
  std::array<Vec3, 2> radial;
  for (int side = 0; side < 2; ++side) {
    const Vec3& e = frame.e[side];
    const Vec3 tangent = frame.origin + distance * e;
    surface.tangents[side] = {tangent, frame.d, away * e};
    radial[side] = tangent - center;
  }
  surface.mid = Cylinder{turned(surface, center, frame.d, radial, -away * bisector),
                         distance * std::tan(half)};
  return surface;
}

BendSurface cone(const BendFrame& frame, EdgeKind edges, const TangentLine& line) {
  const double half = 0.5 * frame.beta.radians();
  const double phi = std::atan(std::abs(line.slope));
  const Vec3 along = std::copysign(1.0, line.slope) * frame.d;  // from the apex to the plates
  const Vec3 apex = frame.origin + line.offset / line.slope * frame.d;
  const double psi = std::atan(std::tan(phi) / std::cos(half));
  const Vec3 bisector = bisector_of(frame);
  const Vec3 axis = std::cos(psi) * along + std::sin(psi) * bisector;
  const double away = edges == EdgeKind::facing ? 1.0 : -1.0;
  BendSurface surface;
  surface.kind = BendKind::cone;
  surface.tan_half_angle = std::sin(phi) * std::tan(half);
  std::array<Vec3, 2> radial;
  for (int side = 0; side < 2; ++side) {
    const Vec3& e = frame.e[side];
    const Vec3 ruling = std::cos(phi) * along + std::sin(phi) * e;
    surface.tangents[side] = {apex, ruling, away * (std::cos(phi) * e - std::sin(phi) * along)};
    radial[side] = ruling - ruling.dot(axis) * axis;
  }
  surface.mid = Cone{
      turned(surface, apex, axis, radial, -away * (bisector - bisector.dot(axis) * axis)),
      std::atan(surface.tan_half_angle)};
  return surface;
}

}  // namespace

double BendSurface::level(int side, double v) const {
  return kind == BendKind::general ? 1.0 + v / rails[side] : v;
}

double BendSurface::v_at(int side, double level) const {
  return kind == BendKind::general ? (level - 1.0) * rails[side] : level;
}

double BendSurface::radius(double level) const {
  if (const auto* cylinder = std::get_if<Cylinder>(&mid)) return cylinder->radius;
  return level * (kind == BendKind::general ? tightest : tan_half_angle);
}

Curve2 BendSurface::at_level(double level, double tolerance) const {
  if (kind != BendKind::general) return Segment{{0.0, level}, {sweep, level}};
  if (level == 1.0) return Segment{{0.0, 0.0}, {sweep, 0.0}};
  const auto curve = [&](double u) -> CurveSample {
    const SpaceCurvePoint c = arc(u);
    const Vec3 arm = c.point - apex;
    return {{u, (level - 1.0) * arm.norm()},
            {1.0, (level - 1.0) * c.derivative.dot(arm.normalized())}};
  };
  return fit_cubics_on_surface(curve, 0.0, sweep, arc(0.0).derivative.norm(), tolerance);
}

Angle BendSurface::turned() const {
  const Vec3 a = normal_on(mid, 0.0), b = normal_on(mid, sweep);
  const double between = angle_between(a, b);
  // Beyond half a turn about a cylinder's or cone's axis the angle between the normals shrinks
  // again.
  if (kind == BendKind::cylinder) return Angle::radians(sweep);
  return Angle::radians(kind == BendKind::cone && sweep > std::numbers::pi
                            ? 2.0 * std::numbers::pi - between
                            : between);
}

BendSurface tangent_surface(const BendFrame& frame, EdgeKind edges, const TangentLine& line) {
  return line.slope == 0.0 ? cylinder(frame, edges, -line.offset) : cone(frame, edges, line);
}

BendSurface half_turn(const BendFrame& frame, const TangentLine& line) {
  const double distance = -line.offset;
  BendSurface surface;
  std::array<Vec3, 2> radial;
  for (int side = 0; side < 2; ++side) {
    surface.tangents[side] = {frame.side_origin(side) + distance * frame.e[0], frame.d,
                              -frame.e[0]};
    radial[side] = (side == 0 ? -0.5 : 0.5) * frame.rise;
  }
  surface.mid = Cylinder{
      turned(surface, surface.tangents[0].origin + 0.5 * frame.rise, frame.d, radial, frame.e[0]),
      0.5 * frame.rise.norm()};
  surface.sweep = std::numbers::pi;
  return surface;
}

}  // namespace planish::connect_detail
