#include "support/sheets.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace planish::test {
namespace {

Frame moved(const Frame& f, const Eigen::Isometry3d& motion) {
  const auto turn = motion.linear();
  return {motion * f.origin, turn * f.x, turn * f.y, turn * f.z};
}

struct Move {
  const Eigen::Isometry3d& motion;
  void operator()(Frame& frame) const { frame = moved(frame, motion); }
  void operator()(Cylinder& cylinder) const { cylinder.frame = moved(cylinder.frame, motion); }
  void operator()(Cone& cone) const { cone.frame = moved(cone.frame, motion); }
  void operator()(Ruled& ruled) const {
    for (Ruled::Knot& knot : ruled.knots) {
      knot.b = motion * knot.b;
      for (Vec3* v : {&knot.b_prime, &knot.g, &knot.g_prime})
        *v = motion.linear() * *v;
    }
  }
  void operator()(Developable& surface) const { std::visit(*this, surface); }
};

struct Scale {
  double factor;
  void operator()(Frame& frame) const { frame.origin *= factor; }
  void operator()(Cylinder& cylinder) const {
    cylinder.frame.origin *= factor;
    cylinder.radius *= factor;
  }
  void operator()(Cone& cone) const { cone.frame.origin *= factor; }
  void operator()(Ruled& ruled) const {
    for (Ruled::Knot& knot : ruled.knots) {
      knot.b *= factor;
      knot.b_prime *= factor;
    }
  }
  void operator()(Developable& surface) const { std::visit(*this, surface); }
};

Curve2 stretched(const Curve2& curve, const Vec2& factors) {
  if (const auto* segment = std::get_if<Segment>(&curve))
    return Segment{segment->a.cwiseProduct(factors), segment->b.cwiseProduct(factors)};
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    PLANISH_ASSERT(factors.x() == factors.y());
    return Arc{arc->center * factors.x(), arc->radius * factors.x(), arc->start, arc->sweep};
  }
  CubicSpline spline = std::get<CubicSpline>(curve);
  for (Vec2& pole : spline.poles)
    pole = pole.cwiseProduct(factors);
  return spline;
}

/// Knots of the surface along the curve v = `at`, over the azimuths of the face.
Ruled ruled_from(const Developable& surface, const Box2& extent, double at, double step) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(extent.size().x() / step)));
  Ruled ruled;
  for (int i = 0; i <= pieces; ++i) {
    const double u = extent.lo.x() + extent.size().x() * i / pieces;
    const Vec3 g = ruling_on(surface, u), n = normal_on(surface, u);
    const Vec3 along = g.cross(n);  // ∂/∂u, normalised
    const auto* cone = std::get_if<Cone>(&surface);
    const double sine = cone == nullptr ? 0.0 : std::sin(cone->half_angle);
    const double speed = cone == nullptr ? std::get<Cylinder>(surface).radius : at * sine;
    ruled.knots.push_back({u, point_on(surface, {u, at}), speed * along, g, sine * along});
  }
  return ruled;
}

Curve2 shifted(const Curve2& curve, double dv) {
  return transformed(curve, Isometry2(Eigen::Translation2d(0.0, dv)));
}

/// Smallest distance from p to the curve: the best of the samples, refined by golden section on
/// the distance itself, whose minimum is a corner where it is zero.
double distance(const Face& face, const Curve2& curve, const Vec3& p) {
  const auto at = [&](double t) {
    const Vec2 uv = point_at(curve, t);
    const auto* surface = std::get_if<Developable>(&face.surface);
    return ((surface != nullptr ? point_on(*surface, uv)
                                : std::get<Frame>(face.surface).point(uv)) -
            p)
        .norm();
  };
  constexpr int samples = 400;
  int best = 0;
  for (int i = 1; i <= samples; ++i)
    if (at(double(i) / samples) < at(double(best) / samples)) best = i;
  double lo = std::max(0.0, (best - 1.0) / samples), hi = std::min(1.0, (best + 1.0) / samples);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  while (hi - lo > 1e-14) {
    const double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    (at(a) < at(b) ? hi : lo) = at(a) < at(b) ? b : a;
  }
  return std::min({at(lo), at(hi), at(double(best) / samples)});
}

}  // namespace

Sheet moved(Sheet sheet, const Eigen::Isometry3d& motion) {
  for (Face& face : sheet.faces)
    std::visit(Move{motion}, face.surface);
  return sheet;
}

Sheet scaled(Sheet sheet, double factor) {
  sheet.thickness *= factor;
  if (sheet.volume) *sheet.volume *= factor * factor * factor;
  for (Bend& bend : sheet.bends)
    bend.inside_radius *= factor;
  for (Face& face : sheet.faces) {
    std::visit(Scale{factor}, face.surface);
    const bool plane = std::holds_alternative<Frame>(face.surface);
    for (BorderLoop& loop : face.loops)
      for (Border& border : loop) {
        border.curve = stretched(border.curve, {plane ? factor : 1.0, factor});
        if (border.edge_length) *border.edge_length *= factor;
      }
  }
  return sheet;
}

Sheet as_ruled(Sheet sheet, Angle step) {
  for (Face& face : sheet.faces) {
    const auto* surface = std::get_if<Developable>(&face.surface);
    if (surface == nullptr) continue;
    Box2 extent;
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop)
        extent.add(bounds(border.curve));
    const double at = extent.lo.y();
    face.surface = ruled_from(*surface, extent, at, step.radians());
    sheet.bends[std::get<BendId>(face.part_of)].kind = BendKind::general;
    for (BorderLoop& loop : face.loops)
      for (Border& border : loop)
        border.curve = shifted(border.curve, -at);
  }
  return sheet;
}

EdgeDistance edge_distance(const Sheet& sheet) {
  std::map<int, std::pair<Face, Curve2>> edges;
  for (const Face& face : sheet.faces)
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop)
        if (border.edge) edges.try_emplace(*border.edge, face, border.curve);
  return [edges](int edge, const Vec3& p) {
    const auto& [face, curve] = edges.at(edge);
    return distance(face, curve, p);
  };
}

}  // namespace planish::test
