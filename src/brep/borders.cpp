#include "borders.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Edges of the solid as borders in the (u, v) of a surface. A ruling is a line of constant u, a
// circle about the axis one of constant v; what is neither is fitted, with u scaled to mm so that
// the tolerance means the same in both directions. u is unwrapped along the edge from samples, so
// that it runs on continuously over the seam of the kernel's surface.

namespace planish::brep {
namespace {

/// 1 − cosine: axes of one feature agree to the digits of a STEP file.
constexpr double kParallel = tolerance::kComputed;

Curve2 on_plane(const SpaceCurve& curve, const Frame& plane, double tolerance) {
  if (curve.kind == SpaceCurve::Kind::line)
    return Segment{plane.local2(curve.start), plane.local2(curve.end)};
  const double tilt = curve.circle.z.dot(plane.z);
  if (curve.kind == SpaceCurve::Kind::circle && 1.0 - std::abs(tilt) < kParallel) {
    const Vec2 centre = plane.local2(curve.circle.origin);
    const Vec3 first = curve.point(curve.t0) - curve.circle.origin;
    const double start = std::atan2(first.dot(plane.y), first.dot(plane.x));
    return Arc{centre, curve.radius, start, std::copysign(curve.t1 - curve.t0, tilt)};
  }
  const auto f = [&](double t) -> CurveSample {
    const Vec3 derivative = curve.derivative(t);
    return {plane.local2(curve.point(t)), {derivative.dot(plane.x), derivative.dot(plane.y)}};
  };
  return recognized(fit_cubics(f, curve.t0, curve.t1, tolerance).spline, tolerance);
}

/// ∂x/∂u and ∂x/∂v of a developable.
struct Tangents {
  Vec3 u;
  Vec3 v;
};
Tangents tangents_at(const Developable& surface, const Vec2& uv) {
  const Vec3 ruling = ruling_on(surface, uv.x());
  const Vec3 normal = normal_on(surface, uv.x());
  if (const auto* cylinder = std::get_if<Cylinder>(&surface))
    return {cylinder->radius * ruling.cross(normal), ruling};
  if (const auto* cone = std::get_if<Cone>(&surface))
    return {uv.y() * std::sin(cone->half_angle) * cone->frame.z.cross(normal).normalized(), ruling};
  constexpr double kStep = tolerance::kAside;  // of the range of u: central difference
  const auto& knots = std::get<Ruled>(surface).knots;
  const double h = kStep * (knots.back().u - knots.front().u);
  const Vec2 du(h, 0.0);
  return {(point_on(surface, uv + du) - point_on(surface, uv - du)) / (2 * h), ruling};
}

/// A curve to be drawn in the parameters of a developable, and where it starts there.
struct OnDevelopable {
  const SpaceCurve& curve;
  const Developable& surface;
  double tolerance;  ///< mm on the surface
  Vec2 start;
  double u_scale;  ///< |∂x/∂u| there

  /// CAD systems write the rulings of a bend with their own tolerance, coarser than a fit's.
  double ruling_tolerance() const { return 10 * tolerance; }
};

OnDevelopable placed(const SpaceCurve& curve, const Developable& surface, double u_near,
                     double tolerance) {
  const Vec2 start = parameters_of(surface, curve.start, u_near);
  return {curve, surface, tolerance, start,
          std::max(tangents_at(surface, start).u.norm(), tolerance)};
}

std::optional<Segment> as_ruling(const OnDevelopable& on) {
  if (on.curve.kind != SpaceCurve::Kind::line) return {};
  const Vec2 end = parameters_of(on.surface, on.curve.end, on.start.x());
  if (std::abs(end.x() - on.start.x()) * on.u_scale > on.ruling_tolerance()) return {};
  const double u = (on.start.x() + end.x()) / 2;
  return Segment{{u, on.start.y()}, {u, end.y()}};
}

/// Circle about the axis: v constant, u turned by the arc's angle.
std::optional<Segment> as_parallel(const OnDevelopable& on) {
  if (on.curve.kind != SpaceCurve::Kind::circle) return {};
  const Frame* axis = nullptr;
  if (const auto* cylinder = std::get_if<Cylinder>(&on.surface)) axis = &cylinder->frame;
  if (const auto* cone = std::get_if<Cone>(&on.surface)) axis = &cone->frame;
  if (!axis) return {};
  const double tilt = on.curve.circle.z.dot(axis->z);
  if (1.0 - std::abs(tilt) > kParallel ||
      axis->local2(on.curve.circle.origin).norm() > on.ruling_tolerance())
    return {};
  const double turn = std::copysign(on.curve.t1 - on.curve.t0, tilt);
  return Segment{on.start, {on.start.x() + turn, on.start.y()}};
}

/// u at evenly spaced parameters, unwrapped, so that any parameter finds its turn.
std::vector<double> unwrapped_u(const OnDevelopable& on) {
  constexpr int kSteps = 32;
  std::vector<double> u{on.start.x()};
  for (int i = 1; i <= kSteps; ++i)
    u.push_back(
        parameters_of(on.surface,
                      on.curve.point(on.curve.t0 + (on.curve.t1 - on.curve.t0) * i / kSteps),
                      u.back())
            .x());
  return u;
}

/// Points and derivatives of the curve's image, u scaled to millimetres.
std::function<CurveSample(double)> scaled_image(const OnDevelopable& on) {
  return [on, turns = unwrapped_u(on)](double t) -> CurveSample {
    const double share = std::clamp((t - on.curve.t0) / (on.curve.t1 - on.curve.t0), 0.0, 1.0);
    const auto step = static_cast<size_t>(share * static_cast<double>(turns.size() - 1));
    const Vec3 derivative = on.curve.derivative(t);
    const Vec2 uv = parameters_of(on.surface, on.curve.point(t), turns[step]);
    const Tangents tangents = tangents_at(on.surface, uv);
    const double uu = tangents.u.squaredNorm();
    const double uw = tangents.u.dot(tangents.v);
    const double ru = derivative.dot(tangents.u);
    const double rv = derivative.dot(tangents.v);
    const double det = uu - uw * uw;
    return {{uv.x() * on.u_scale, uv.y()},
            {(ru - uw * rv) / det * on.u_scale, (uu * rv - uw * ru) / det}};
  };
}

Curve2 fitted(const OnDevelopable& on) {
  const auto unscaled = [&](const Vec2& p) -> Vec2 { return {p.x() / on.u_scale, p.y()}; };
  CubicSpline spline = fit_cubics(scaled_image(on), on.curve.t0, on.curve.t1, on.tolerance).spline;
  const Curve2 simple = recognized(spline, on.tolerance);
  if (const auto* line = std::get_if<Segment>(&simple)) {
    const Segment segment{unscaled(line->a), unscaled(line->b)};
    if (std::abs(line->a.x() - line->b.x()) > on.ruling_tolerance()) return segment;
    const double u = (segment.a.x() + segment.b.x()) / 2;
    return Segment{{u, segment.a.y()}, {u, segment.b.y()}};
  }
  for (Vec2& pole : spline.poles)
    pole = unscaled(pole);
  return spline;
}

Curve2 on_developable(const SpaceCurve& curve, const Developable& surface, double u_near,
                      double tolerance) {
  const OnDevelopable on = placed(curve, surface, u_near, tolerance);
  if (const auto ruling = as_ruling(on)) return *ruling;
  if (const auto parallel = as_parallel(on)) return *parallel;
  return fitted(on);
}

/// The whole turns that bring u near to u_near; ruled surfaces have none.
double turns_to(const Developable& surface, double u, double u_near) {
  if (std::holds_alternative<Ruled>(surface)) return 0.0;
  constexpr double kTurn = 2 * std::numbers::pi;
  return kTurn * std::round((u_near - u) / kTurn);
}

}  // namespace

std::optional<double> level_depth(const SpaceCurve& edge, const Frame& plane, double tolerance) {
  const auto depth_of = [&](const Vec3& point) { return -plane.local(point).z(); };
  const double depth = depth_of(edge.start);
  for (const double share : {0.5, 1.0})
    if (std::abs(depth_of(edge.point(std::lerp(edge.t0, edge.t1, share))) - depth) > tolerance)
      return {};
  return depth;
}

Curve2 shifted_u(const Curve2& curve, double by) {
  return transformed(curve, Isometry2(Eigen::Translation2d(by, 0.0)));
}

BorderLoop read_borders(const SolidModel& model, const std::vector<CoEdge>& loop,
                        const SolidSurface& surface, double u_near, double tolerance) {
  BorderLoop borders;
  for (const CoEdge& use : loop) {
    const SpaceCurve& edge = model.edges[use.edge].curve;
    Border border;
    border.edge = use.edge + 1;
    border.edge_length = edge.length();
    if (const auto* plane = std::get_if<Frame>(&surface)) {
      border.curve = on_plane(edge, *plane, tolerance);
      if (!use.forward) border.curve = reversed(border.curve);
    } else {
      const auto& developable = std::get<Developable>(surface);
      border.curve = on_developable(edge, developable, u_near, tolerance);
      if (!use.forward) border.curve = reversed(border.curve);
      const double turns = turns_to(developable, start_of(border.curve).x(), u_near);
      if (turns != 0.0) border.curve = shifted_u(border.curve, turns);
      u_near = end_of(border.curve).x();
    }
    borders.push_back(std::move(border));
  }
  return borders;
}

}  // namespace planish::brep
