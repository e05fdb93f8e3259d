#include "general_fit.hpp"

#include "corners.hpp"
#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/connect/edge_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// A general cone: one apex on the intersection line, a slope for each side (math.md#general-cone).
// For an apex the least extension of a side is its steepest line that does not cut it, so only
// apexes where an edge's own extension meets the line need be tried. The arc is elliptic and leaves
// both plates as their tangents do (math.md#corner-cone); by default it begins where it would be
// circular. Offsets keep the rulings (math.md#neutral-surface).

namespace planish::connect_detail {
namespace {

// An apex within this share of the extent beyond the first corner counts as being at it.
constexpr double kAtEnd = tolerance::kComputed;
// A tangent point within this share of the extent of the intersection line lies on it.
constexpr double kPointOnLine = 1e-5;
// Largest deviation of the surface between knots, as a share of the extent.
constexpr double kSurfaceTolerance = 1e-11;
// Number of places at which the tightest ruling is sought.
constexpr int kSamples = 64;

// The steepest line from the apex that does not cut a side.
std::optional<TangentLine> line_from(double apex, const std::vector<Vec2>& side) {
  double steepest = std::numeric_limits<double>::infinity();
  for (const Vec2& p : side)
    if (p.x() != apex) steepest = std::min(steepest, p.y() / std::abs(p.x() - apex));
  if (!(steepest > 0.0) || !std::isfinite(steepest)) return std::nullopt;
  const double slope = side.back().x() > apex ? steepest : -steepest;
  return TangentLine{slope, slope * apex};
}

double area_of(const std::vector<Vec2>& side, const TangentLine& line) {
  return 0.5 * extension_area({side, side}, EdgeKind::facing, line);
}

std::optional<GeneralLines> lines_from(double apex, const Corners& corners) {
  GeneralLines lines{apex, {}, 0.0};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto line = line_from(apex, corners[side]);
    if (!line) return std::nullopt;
    lines.lines[side] = *line;
    lines.area += area_of(corners[side], *line);
  }
  return lines;
}

bool beyond(double apex, const Corners& corners) {
  const double slack = kAtEnd * (high_x(corners) - low_x(corners));
  return apex <= low_x(corners) + slack || apex >= high_x(corners) - slack;
}

// Where the extensions of the edges meet the intersection line.
std::vector<double> edge_apexes(const Corners& corners) {
  std::vector<double> apexes;
  for (const auto& side : corners)
    for (std::size_t j = 0; j + 1 < side.size(); ++j) {
      const Vec2 d = side[j + 1] - side[j];
      const double x = side[j].x() - side[j].y() / d.y() * d.x();
      if (std::isfinite(x)) apexes.push_back(x);
    }
  return apexes;
}

/// Curvature of the cone's directions at a place of the arc: radius of curvature of the surface is
/// the distance from the apex over it.
double sharpness(const SpaceCurvePoint& c, const Vec3& apex) {
  const Vec3 arm = c.point - apex;
  const Vec3 g = arm.normalized();
  const Vec3 n = c.derivative.cross(g).normalized(), across = g.cross(n);
  const double speed = c.derivative.dot(across);
  return std::abs(c.second.dot(n)) * arm.norm() / (speed * speed);
}

// The point of the intersection line from which both ends are equally far: the arc is circular
// there.
Vec3 equidistant(const BendFrame& frame, const Vec3& apex, const std::array<Vec3, 2>& ends) {
  const Vec3 a = ends[0] - apex, b = ends[1] - apex;
  const double xa = a.dot(frame.d), xb = b.dot(frame.d);
  const double far = 0.5 * (xa + xb);
  // Ends with one foot: the quotient would be one of roundings.
  if (std::abs(xa - xb) <= kAtEnd * a.norm()) return apex + far * frame.d;
  const double x = 0.5 * (a.squaredNorm() - b.squaredNorm()) / (xa - xb);
  // Ends that differ too much for a circle: an ellipse from the middle of their feet.
  return apex + (x / far > 0.5 && x / far < 2.0 ? x : far) * frame.d;
}

Result<Vec3> checked_tangent_point(const BendFrame& frame, const Vec3& apex, const Vec3& point,
                                   double extent) {
  const Vec3 foot = frame.origin + (point - frame.origin).dot(frame.d) * frame.d;
  const double off = (point - foot).norm();
  if (off > kPointOnLine * extent)
    return fail(refuse::tangent_point_off, {{"at", place::point(point)},
                                            {"off", off, unit::mm},
                                            {"foot", place::point(foot)},
                                            {"field", place::pointer("/tangent_point")}});
  if ((foot - apex).norm() <= kPointOnLine * extent)
    return fail(refuse::tangent_point_at_apex,
                {{"at", place::point(point)}, {"field", place::pointer("/tangent_point")}});
  return foot;
}

}  // namespace

Result<GeneralLines> general_lines(const Corners& corners, EdgeKind edges,
                                   std::optional<double> apex) {
  if (edges == EdgeKind::averted)
    return fail(refuse::general_of_averted, {{"field", place::pointer("/surface")}});
  if (apex && !beyond(*apex, corners))
    return fail(refuse::apex_between, {{"apex", *apex, unit::mm},
                                       {"low", low_x(corners), unit::mm},
                                       {"high", high_x(corners), unit::mm},
                                       {"field", place::pointer("/apex")}});
  std::optional<GeneralLines> best;
  for (const double x : apex ? std::vector{*apex} : edge_apexes(corners)) {
    if (!beyond(x, corners)) continue;
    const auto lines = lines_from(x, corners);
    if (lines && (!best || lines->area < best->area)) best = *lines;
  }
  if (!best) return fail(refuse::general_without_apex, {{"field", place::pointer("/surface")}});
  return *best;
}

Result<BendSurface> general_surface(const BendFrame& frame, const GeneralLines& lines,
                                    const Corners& corners,
                                    const std::optional<Vec3>& tangent_point, double extent) {
  const Vec3 apex = frame.origin + lines.apex * frame.d;
  BendSurface surface;
  surface.kind = BendKind::general;
  std::array<Vec3, 2> ends;
  for (int side = 0; side < 2; ++side) {
    const double slope = lines.lines[side].slope;
    const Vec3 along = std::copysign(1.0, slope) * frame.d;
    const double phi = std::atan(std::abs(slope));
    const Vec3 ruling = std::cos(phi) * along + std::sin(phi) * frame.e[side];
    const Vec2 far = slope > 0.0 ? corners[side].back() : corners[side].front();
    Vec3& end = ends[side] = apex + (frame.point(side, far) - apex).dot(ruling) * ruling;
    surface.tangents[side] = {end, ruling, std::cos(phi) * frame.e[side] - std::sin(phi) * along};
    surface.rails[side] = (end - apex).norm();
    // The end of a plate that touches may lie where the planes meet, and edges may hardly run
    // apart.
    constexpr double kLeastSlope = 1e-6;
    const double off = surface.rails[side] * std::sin(phi);
    if (!(off > kPointOnLine * extent) || !(std::abs(slope) > kLeastSlope))
      return fail(refuse::general_without_apex, {{"field", place::pointer("/surface")}});
  }
  Vec3 meet = equidistant(frame, apex, ends);
  if (tangent_point) {
    const auto given = checked_tangent_point(frame, apex, *tangent_point, extent);
    if (!given) return pass_on(given);
    meet = *given;
  }
  SpaceCurve arc = conic_arc(ends[0], meet, ends[1]);
  // The normal c′ × g points away from the inside, as that of a cylinder or cone does.
  const SpaceCurvePoint middle = arc(0.5);
  if (middle.second.dot(middle.derivative.cross(middle.point - apex)) > 0.0) {
    surface.first = 1;
    arc = conic_arc(ends[1], meet, ends[0]);
  }
  double sharpest = 0.0;
  for (int s = 0; s <= kSamples; ++s) {
    const SpaceCurvePoint c = arc(static_cast<double>(s) / kSamples);
    sharpest = std::max(sharpest, sharpness(c, apex) / (c.point - apex).norm());
  }
  surface.tightest = 1.0 / sharpest;
  surface.mid = cone_over(apex, arc, 0.0, 1.0, kSurfaceTolerance * extent);
  surface.arc = std::move(arc);
  surface.apex = apex;
  surface.sweep = 1.0;
  return surface;
}

double middle_radius(const BendSurface& surface, const Curve2& low, const Curve2& high) {
  // A boundary only touches the rulings at its ends, which may then be missing.
  const auto v_of = [&](const Curve2& boundary, double u) {
    const auto at = crossings(boundary, {u, 0.0}, Vec2::UnitY());
    const double end = u < 0.5 * surface.sweep ? 0.0 : 1.0;
    return point_at(boundary, at.empty() ? end : at.front()).y();
  };
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int kRulings = 256;
  for (int i = 0; i <= kRulings; ++i) {
    const double u = surface.sweep * i / kRulings;
    const SpaceCurvePoint c = surface.arc(u);
    const double s = (c.point - surface.apex).norm() + 0.5 * (v_of(low, u) + v_of(high, u));
    smallest = std::min(smallest, s / sharpness(c, surface.apex));
  }
  return smallest;
}

Ruled offset_surface(const BendSurface& surface, double offset) {
  Ruled result = std::get<Ruled>(surface.mid);
  for (Ruled::Knot& knot : result.knots) {
    const Vec3 n = knot.b_prime.cross(knot.g).normalized();
    // n′ lies across the ruling; n·b′ = 0 all along, so n′·b′ = −n·b″.
    const Vec3 across = n.cross(knot.g);
    const Vec3 turning = -n.dot(surface.arc(knot.u).second) / across.dot(knot.b_prime) * across;
    knot.b += offset * n;
    knot.b_prime += offset * turning;
  }
  return result;
}

}  // namespace planish::connect_detail
