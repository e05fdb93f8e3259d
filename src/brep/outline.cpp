#include "outline.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Which faces lie opposite each other, and how far apart. Coarse polygons in the parameters of a
// face (u in mm) are enough: of a face and the projection of another onto it the common area is
// summed along lines of constant v. Only faces of one kind of surface can be opposite, since an
// offset keeps the kind. Depth is measured along the normal at the nearest point, so curved faces
// are treated as plane ones are.

namespace planish::brep {
namespace {

void add_points(const SpaceCurve& curve, bool forward, std::vector<Vec3>& ring) {
  int pieces = 1;
  if (curve.kind == SpaceCurve::Kind::circle)
    pieces = std::max(2,
                      static_cast<int>(std::ceil((curve.t1 - curve.t0) / (std::numbers::pi / 12))));
  if (curve.kind == SpaceCurve::Kind::other) pieces = 12;
  for (int i = 0; i < pieces; ++i) {
    const double share = static_cast<double>(forward ? i : pieces - i) / pieces;
    ring.push_back(curve.point(curve.t0 + share * (curve.t1 - curve.t0)));
  }
}

Vec2 flat_point(const SolidFace& face, const Outline& outline, const Vec3& p, double u_near) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->local2(p);
  const Vec2 uv = parameters_of(std::get<Developable>(face.surface), p, u_near / outline.u_scale);
  return {uv.x() * outline.u_scale, uv.y()};
}

double scale_of(const SolidFace& face, const Vec3& p) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  if (!surface) return 1.0;
  if (const auto* cylinder = std::get_if<Cylinder>(surface)) return cylinder->radius;
  if (const auto* cone = std::get_if<Cone>(surface))
    return std::max(parameters_of(*surface, p, 0.0).y() * std::sin(cone->half_angle),
                    tolerance::kTiniest);
  const auto& knots = std::get<Ruled>(*surface).knots;
  return std::max(knots[knots.size() / 2].b_prime.norm(), tolerance::kTiniest);
}

/// Not `planish::ring_area`: between faces of one size the last bits decide which is measured from,
/// and reports of a part should not change with how a sum is rounded.
double area_about_origin(const std::vector<Vec2>& ring) {
  double twice = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

Outline outline_of(const SolidModel& model, const SolidFace& face) {
  Outline outline;
  for (const auto& loop : face.loops) {
    std::vector<Vec3>& ring = outline.rings.emplace_back();
    for (const CoEdge& use : loop)
      add_points(model.edges[use.edge].curve, use.forward, ring);
  }
  if (outline.rings.empty() || outline.rings.front().empty()) return {};
  for (const auto& ring : outline.rings)
    for (const Vec3& p : ring)
      outline.space.extend(p);
  if (std::holds_alternative<DoublyCurved>(face.surface)) return outline;
  outline.u_scale = scale_of(face, outline.rings.front().front());
  double u_near = 0.0;
  for (const auto& ring : outline.rings) {
    std::vector<Vec2>& flat = outline.flat.emplace_back();
    for (const Vec3& p : ring) {
      flat.push_back(flat_point(face, outline, p, u_near));
      u_near = flat.back().x();
      outline.box.add(flat.back());
    }
    outline.area += area_about_origin(flat);
    u_near = (outline.box.lo.x() + outline.box.hi.x()) / 2;
  }
  outline.area = std::abs(outline.area);
  outline.outer = outer_loop(outline);
  outline.u_middle = u_near / outline.u_scale;
  outline.inner_point = outline.rings.front().front();
  outline.inner_normal = outward_normal_at(face, outline.inner_point);
  return outline;
}

/// u-intervals of the inside of rings along the line of constant v.
std::vector<double> cuts(const std::vector<std::vector<Vec2>>& rings, double v) {
  std::vector<double> us;
  for (const auto& ring : rings)
    for (const auto& [a, b] : sides_of(ring)) {
      if ((a.y() > v) == (b.y() > v)) continue;
      us.push_back(a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  std::ranges::sort(us);
  return us;
}

double common_length(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    sum += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return sum;
}

double overlap_area(const Outline& a, const std::vector<std::vector<Vec2>>& b, const Box2& b_box) {
  constexpr int kLines = 16;
  const double lo = std::max(a.box.lo.y(), b_box.lo.y());
  const double hi = std::min(a.box.hi.y(), b_box.hi.y());
  if (hi <= lo || !a.box.overlaps(b_box)) return 0.0;
  double sum = 0.0;
  for (int i = 0; i < kLines; ++i) {
    const double v = lo + (hi - lo) * (i + 0.5) / kLines;
    sum += common_length(cuts(a.flat, v), cuts(b, v));
  }
  return sum * (hi - lo) / kLines;
}

/// Depth of a point below face A, and its image in A's outline plane.
struct Projection {
  Vec2 flat;
  double depth;
};
Projection project(const SolidFace& face, const Outline& outline, const Vec3& p, double u_near) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) {
    const Vec3 local = plane->local(p);
    return {local.head<2>(), -local.z()};
  }
  const auto& surface = std::get<Developable>(face.surface);
  const Vec2 uv = parameters_of(surface, p, u_near);
  const double height = (p - point_on(surface, uv)).dot(normal_on(surface, uv.x()));
  return {{uv.x() * outline.u_scale, uv.y()}, -face.sense * height};
}

}  // namespace

bool same_kind(const SolidFace& a, const SolidFace& b) {
  if (a.surface.index() != b.surface.index()) return false;
  const auto* first = std::get_if<Developable>(&a.surface);
  return !first || first->index() == std::get<Developable>(b.surface).index();
}

double depth_below(const SolidFace& face, const Outline& outline, const Vec3& point) {
  return project(face, outline, point, outline.u_middle).depth;
}

Vec3 outward_normal_at(const SolidFace& face, const Vec3& point) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->z;
  const auto& surface = std::get<Developable>(face.surface);
  return face.sense * normal_on(surface, parameters_of(surface, point, 0.0).x());
}

int outer_loop(const Outline& outline) {
  int best = 0;
  double best_area = -1.0;
  for (int l = 0; l < std::ssize(outline.flat); ++l) {
    const double area = std::abs(area_about_origin(outline.flat[l]));
    if (area <= best_area) continue;
    best_area = area;
    best = l;
  }
  return best;
}

std::vector<Outline> outlines_of(const SolidModel& model) {
  return mapped(model.faces, [&](const SolidFace& face) { return outline_of(model, face); });
}

std::optional<Opposite> opposite(const SolidModel& model, const std::vector<Outline>& outlines,
                                 int a, int b) {
  const SolidFace& face = model.faces[a];
  const Outline& from = outlines[a];
  const Outline& to = outlines[b];
  if (from.flat.empty() || to.flat.empty() || !same_kind(face, model.faces[b])) return {};
  constexpr double kAntiparallel = -0.9995;  // cosine; 1.8°
  if (outward_normal_at(face, to.inner_point).dot(to.inner_normal) > kAntiparallel) return {};
  Opposite result;
  double lo = std::numeric_limits<double>::infinity();
  double hi = -lo;
  double sum = 0.0;
  double count = 0.0;
  std::vector<std::vector<Vec2>> rings;
  Box2 box;
  double u_near = from.u_middle;
  for (const auto& ring : to.rings) {
    std::vector<Vec2>& flat = rings.emplace_back();
    for (const Vec3& p : ring) {
      const Projection projection = project(face, from, p, u_near);
      flat.push_back(projection.flat);
      box.add(projection.flat);
      u_near = projection.flat.x() / from.u_scale;
      lo = std::min(lo, projection.depth);
      hi = std::max(hi, projection.depth);
      sum += projection.depth;
      count += 1.0;
    }
  }
  if (hi <= 0.0) return {};
  result.depth = sum / count;
  result.spread = hi - lo;
  result.overlap = overlap_area(from, rings, box);
  if (result.overlap <= 0.0) return {};
  return result;
}

}  // namespace planish::brep
