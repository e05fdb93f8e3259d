#include "borders.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

constexpr double kParallel = 1e-9;  // 1 − cosine: axes of one feature agree to STEP's digits

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
  constexpr double kStep = 1e-6;  // of the range of u: central difference
  const auto& knots = std::get<Ruled>(surface).knots;
  const double h = kStep * (knots.back().u - knots.front().u);
  const Vec2 du(h, 0.0);
  return {(point_on(surface, uv + du) - point_on(surface, uv - du)) / (2 * h), ruling};
}

/// A curve drawn in the parameters of a developable.
class OnDevelopable {
 public:
  OnDevelopable(const SpaceCurve& curve, const Developable& surface, double u_near,
                double tolerance)
      : curve_(curve),
        surface_(surface),
        tolerance_(tolerance),
        start_(parameters_of(surface, curve.start, u_near)),
        u_scale_(std::max(tangents_at(surface, start_).u.norm(), tolerance)) {}

  Curve2 run() const {
    if (curve_.kind == SpaceCurve::Kind::line)
      if (auto ruling = as_ruling(parameters_of(surface_, curve_.end, start_.x()))) return *ruling;
    if (curve_.kind == SpaceCurve::Kind::circle)
      if (auto parallel = as_parallel()) return *parallel;
    return fitted();
  }

 private:
  std::optional<Segment> as_ruling(const Vec2& end) const {
    if (std::abs(end.x() - start_.x()) * u_scale_ > ruling_tolerance()) return {};
    const double u = (start_.x() + end.x()) / 2;
    return Segment{{u, start_.y()}, {u, end.y()}};
  }

  /// Systems write the rulings of a bend with their own tolerance, coarser than a fit's.
  double ruling_tolerance() const { return 10 * tolerance_; }

  /// Circle about the axis: v constant, u turned by the arc's angle.
  std::optional<Segment> as_parallel() const {
    const Frame* axis = nullptr;
    if (const auto* cylinder = std::get_if<Cylinder>(&surface_)) axis = &cylinder->frame;
    if (const auto* cone = std::get_if<Cone>(&surface_)) axis = &cone->frame;
    if (!axis) return {};
    const double tilt = curve_.circle.z.dot(axis->z);
    if (1.0 - std::abs(tilt) > kParallel ||
        axis->local2(curve_.circle.origin).norm() > ruling_tolerance())
      return {};
    return Segment{start_, {start_.x() + std::copysign(curve_.t1 - curve_.t0, tilt), start_.y()}};
  }

  /// u at evenly spaced parameters, unwrapped, so that any parameter finds its turn.
  std::vector<double> unwrapped_u() const {
    constexpr int kSteps = 32;
    std::vector<double> u{start_.x()};
    for (int i = 1; i <= kSteps; ++i)
      u.push_back(parameters_of(surface_,
                                curve_.point(curve_.t0 + (curve_.t1 - curve_.t0) * i / kSteps),
                                u.back())
                      .x());
    return u;
  }

  Curve2 fitted() const {
    const std::vector<double> turns = unwrapped_u();
    const auto f = [&](double t) -> CurveSample {
      const double share = std::clamp((t - curve_.t0) / (curve_.t1 - curve_.t0), 0.0, 1.0);
      const double
          u_near = turns[static_cast<std::size_t>(share * static_cast<double>(turns.size() - 1))];
      const Vec3 derivative = curve_.derivative(t);
      const Vec2 uv = parameters_of(surface_, curve_.point(t), u_near);
      const Tangents tangents = tangents_at(surface_, uv);
      const double uu = tangents.u.squaredNorm();
      const double uw = tangents.u.dot(tangents.v);
      const double ru = derivative.dot(tangents.u);
      const double rv = derivative.dot(tangents.v);
      const double det = uu - uw * uw;
      return {{uv.x() * u_scale_, uv.y()},
              {(ru - uw * rv) / det * u_scale_, (uu * rv - uw * ru) / det}};
    };
    CubicSpline spline = fit_cubics(f, curve_.t0, curve_.t1, tolerance_).spline;
    const Curve2 simple = recognized(spline, tolerance_);
    if (const auto* line = std::get_if<Segment>(&simple)) {
      const Segment scaled{unscaled(line->a), unscaled(line->b)};
      if (std::abs(line->a.x() - line->b.x()) > ruling_tolerance()) return scaled;
      const double u = (scaled.a.x() + scaled.b.x()) / 2;
      return Segment{{u, scaled.a.y()}, {u, scaled.b.y()}};
    }
    for (Vec2& pole : spline.poles)
      pole = unscaled(pole);
    return spline;
  }

  Vec2 unscaled(const Vec2& p) const { return {p.x() / u_scale_, p.y()}; }

  const SpaceCurve& curve_;
  const Developable& surface_;
  double tolerance_;
  Vec2 start_;
  double u_scale_;
};

/// The whole turns that bring u near to u_near; ruled surfaces have none.
double turns_to(const Developable& surface, double u, double u_near) {
  if (std::holds_alternative<Ruled>(surface)) return 0.0;
  constexpr double kTurn = 2 * std::numbers::pi;
  return kTurn * std::round((u_near - u) / kTurn);
}

}  // namespace

Curve2 shifted_u(const Curve2& curve, double by) {
  Isometry2 shift = Isometry2::Identity();
  shift.translation() = Vec2(by, 0.0);
  return transformed(curve, shift);
}

BorderLoop read_borders(const SolidModel& model, const std::vector<CoEdge>& loop,
                        const SolidSurface& surface, double u_near, double tolerance) {
  BorderLoop borders;
  for (const CoEdge& use : loop) {
    const SpaceCurve& edge = model.edges[use.edge].curve;
    Border border;
    border.edge = use.edge;
    border.edge_length = edge.length();
    if (const auto* plane = std::get_if<Frame>(&surface)) {
      border.curve = on_plane(edge, *plane, tolerance);
      if (!use.forward) border.curve = reversed(border.curve);
    } else {
      const auto& developable = std::get<Developable>(surface);
      border.curve = OnDevelopable(edge, developable, u_near, tolerance).run();
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
