#include "outline.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// A contour in the forms that DXF holds: a circle, a polyline with bulges, or a chain where there
// are splines. Cutting programs do not tolerate doubled vertices, so curves without length are left
// out, and a joint takes the end that is a stored point, since one computed from an arc's angle is
// off by rounding. Arcs of more than half a turn are halved, as some readers go the shorter way,
// and very large ones become cubics.

namespace planish::io_detail {
namespace {

using std::numbers::pi;

// In the file's unit, whatever it is: vertices closer than this are one vertex.
constexpr double kSamePoint = 1e-9;
constexpr double kStraightBulge = tolerance::kRounding;
// Beyond this radius the angles of an ARC, as doubles in degrees, no longer place its ends to 1e-9.
constexpr double kLargestArcRadius = 1e5;

bool has_spline(const Loop& loop) {
  return std::ranges::any_of(
      loop, [](const Curve2& c) { return std::holds_alternative<CubicSpline>(c); });
}

Loop without_splines(const Loop& loop, double tolerance) {
  Loop result;
  for (const Curve2& curve : loop) {
    const std::vector<Curve2> arcs = to_arcs(curve, tolerance);
    result.insert(result.end(), arcs.begin(), arcs.end());
  }
  return result;
}

/// Halves arcs of more than half a turn: some readers take the shorter way around.
Loop with_short_arcs(const Loop& loop) {
  Loop result;
  for (const Curve2& curve : loop) {
    const Arc* arc = std::get_if<Arc>(&curve);
    // Half turns have rounding errors; they stay one curve.
    if (arc && std::abs(arc->sweep) > pi * (1.0 + tolerance::kComputed)) {
      Arc half = *arc;
      half.sweep *= 0.5;
      result.emplace_back(half);
      half.start += half.sweep;
      result.emplace_back(half);
    } else {
      result.push_back(curve);
    }
  }
  return result;
}

/// Where `next` starts. Prefers the end that is a stored point to one computed from an arc's angle,
/// so that the designer's coordinates are written.
Vec2 joint(const Curve2& previous, const Curve2& next) {
  const bool computed = std::holds_alternative<Arc>(next);
  return computed && !std::holds_alternative<Arc>(previous) ? end_of(previous) : start_of(next);
}

/// The curves that have a length, each with its start: a curve without length would give a double
/// vertex, which cutting programs do not tolerate.
struct OutlineCurve {
  Curve2 curve;
  Vec2 start;
};

std::vector<OutlineCurve> curves_of(const Loop& loop) {
  std::vector<Vec2> joints;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    joints.push_back(joint(loop[(i + loop.size() - 1) % loop.size()], loop[i]));
  }
  std::vector<OutlineCurve> curves;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double gap = (joints[(i + 1) % loop.size()] - joints[i]).norm();
    const bool closed_spline = loop.size() == 1 && std::holds_alternative<CubicSpline>(loop[i]);
    if (gap >= kSamePoint || closed_spline) curves.push_back({loop[i], joints[i]});
  }
  return curves;
}

double bulge_of(const Curve2& curve) {
  const Arc* arc = std::get_if<Arc>(&curve);
  const double bulge = arc ? std::tan(arc->sweep / 4.0) : 0.0;
  return std::abs(bulge) < kStraightBulge ? 0.0 : bulge;
}

Polyline polyline_of(const Loop& loop) {
  Polyline result;
  for (const OutlineCurve& curve : curves_of(loop))
    result.vertices.push_back({curve.start, bulge_of(curve.curve)});
  return result;
}

/// Cubic equal to the arc up to rounding: only for the small sweeps of very large radii.
CubicSpline flat_arc(const Vec2& a, const Vec2& b, double bulge) {
  const Vec2 chord = b - a;
  const double handle = (1.0 + bulge * bulge) / 3.0;
  const Eigen::Rotation2Dd half_sweep(2.0 * std::atan(bulge));
  return {{a, a + handle * (half_sweep.inverse() * chord), b - handle * (half_sweep * chord), b}};
}

Curve2 between(const Curve2& curve, const Vec2& a, const Vec2& b) {
  if (const auto* spline = std::get_if<CubicSpline>(&curve)) {
    CubicSpline moved = *spline;
    moved.poles.front() = a;
    moved.poles.back() = b;
    return moved;
  }
  Curve2 result = bulge_curve(a, b, bulge_of(curve));
  const Arc* arc = std::get_if<Arc>(&result);
  if (arc && arc->radius > kLargestArcRadius) return flat_arc(a, b, bulge_of(curve));
  return result;
}

Loop chain_of(const Loop& loop) {
  const std::vector<OutlineCurve> curves = curves_of(loop);
  Loop result;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Vec2& end = curves[(i + 1) % curves.size()].start;
    result.push_back(between(curves[i].curve, curves[i].start, end));
  }
  return result;
}

}  // namespace

Curve2 bulge_curve(const Vec2& a, const Vec2& b, double bulge) {
  if (std::abs(bulge) < kStraightBulge) return Segment{a, b};
  const Vec2 chord = b - a;
  const Vec2 left = perpendicular(chord);
  const Vec2 center = 0.5 * (a + b) + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
  const double radius = chord.norm() * (1.0 + bulge * bulge) / (4.0 * std::abs(bulge));
  const Vec2 from = a - center;
  return Arc{center, radius, std::atan2(from.y(), from.x()), 4.0 * std::atan(bulge)};
}

Outline outline_of(const Loop& loop, const OutlineOptions& options) {
  const bool keep = options.splines == Splines::keep && has_spline(loop);
  Loop curves = keep ? loop : without_splines(loop, options.arc_tolerance);
  for (Curve2& curve : curves)
    curve = scaled(curve, options.scale);
  if (curves.size() == 1) {
    if (const Arc* arc = std::get_if<Arc>(&curves[0])) return Circle{arc->center, arc->radius};
  }
  curves = with_short_arcs(curves);
  if (keep) return chain_of(curves);
  return polyline_of(curves);
}

Loop curves_of_slit(const Curve2& slit, const OutlineOptions& options) {
  Loop curves = options.splines == Splines::keep ? Loop{slit}
                                                 : to_arcs(slit, options.arc_tolerance);
  for (Curve2& curve : curves)
    curve = scaled(curve, options.scale);
  return with_short_arcs(curves);
}

Box2 bounds(const Outline& outline) {
  Box2 box;
  if (const auto* circle = std::get_if<Circle>(&outline)) {
    box.add(Vec2(circle->center.array() - circle->radius));
    box.add(Vec2(circle->center.array() + circle->radius));
  } else if (const auto* polyline = std::get_if<Polyline>(&outline)) {
    const auto& v = polyline->vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
      box.add(bounds(bulge_curve(v[i].point, v[(i + 1) % v.size()].point, v[i].bulge)));
    }
  } else {
    box.add(bounds(std::get<Loop>(outline)));
  }
  return box;
}

}  // namespace planish::io_detail
