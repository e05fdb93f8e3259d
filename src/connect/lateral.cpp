#include "lateral.hpp"

#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/geometry/fit.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

// The sides of a bend (math.md#lateral-boundaries): straight in the flat between the plates'
// corners, at the neutral surface, or along a circle of the surface. A straight one must meet
// corner, ruling, other ruling and other corner in this order, and lean no more than 45°. The bend
// may run over neither plate: sections of the tangent rulings beside which there is no material are
// found from crossings of a line just below, after appendix 1 of bibliography.md#thesis.

namespace planish::connect_detail {
namespace {

// A bend has no width below this share of the plates' extent.
constexpr double kNoWidth = kNegligible;
// Accuracy of curves on a cone that are straight when flat, as a share of the extent.
constexpr double kCurveTolerance = 1e-10;
// If the boundary leans more than this (45°) from straight across the bend, the corners of the
// plates are not near each other.
constexpr double kLeaning = 1.0;

// The bend and the ends of the plates laid flat at the neutral surface.
class Flat {
 public:
  Flat(const BendSurface& surface, double neutral_offset)
      : surface_(surface), development_(surface.mid, neutral_offset, 0.5 * surface.sweep) {}

  // Image of a point (v, h) of a side.
  Vec2 image(int side, const Vec2& vh) const {
    const double u = surface_.azimuth(side);
    const Eigen::Matrix2d jacobian = development_.jacobian({u, vh.x()});
    const Vec2 along = jacobian.col(1).normalized();
    // The bend lies at growing u from its first side.
    const Vec2 away = (side == surface_.first ? 1.0 : -1.0) * perpendicular(along);
    return development_.develop({u, vh.x()}) + vh.y() * away;
  }

  // v at which the line from a to b crosses the ruling of a side.
  double crossing(int side, const Vec2& a, const Vec2& b) const {
    const double u = surface_.azimuth(side);
    const Vec2 origin = development_.develop({u, reference_});
    const Vec2 along = development_.jacobian({u, reference_}).col(1).normalized();
    const Vec2 n = perpendicular(along);
    const double ha = n.dot(a - origin), hb = n.dot(b - origin);
    const Vec2 p = a + ha / (ha - hb) * (b - a);
    return reference_ + along.dot(p - origin);
  }
  void set_reference(double v) { reference_ = v; }

  // The curve in (u, v) whose image is the straight line between the rulings, from azimuth 0 on.
  Curve2 straight(const std::array<double, 2>& v, double tolerance) const {
    const int last = 1 - surface_.first;
    const Vec2 start(0.0, v[surface_.first]);
    const Vec2 end(surface_.sweep, v[last]);
    if (std::holds_alternative<Cylinder>(surface_.mid)) return Segment{start, end};
    const Vec2 a = development_.develop(start), b = development_.develop(end);
    const auto curve = [&](double t) -> CurveSample {
      const Vec2 uv = development_.fold(a + t * (b - a));
      return {uv, development_.jacobian(uv).inverse() * (b - a)};
    };
    return fit_cubics_on_surface(curve, 0.0, 1.0, development_.jacobian(start).col(0).norm(),
                                 tolerance);
  }

 private:
  const BendSurface& surface_;
  Development development_;
  double reference_ = 1.0;
};

// The straight boundary between two corners; empty if it does not cross the rulings in order.
std::optional<Boundary> straight(const BendSurface& surface, const Flat& flat,
                                 const std::array<Vec2, 2>& corners, double extent) {
  const Vec2 a = flat.image(0, corners[0]), b = flat.image(1, corners[1]);
  Boundary boundary;
  for (int side = 0; side < 2; ++side) {
    // A corner on the ruling is where the boundary starts.
    const Vec2& corner = corners[side];
    double& v = boundary.v[side];
    v = corner.y() <= kCurveTolerance * extent ? corner.x() : flat.crossing(side, a, b);
    if (!std::isfinite(v) || surface.radius(surface.level(side, v)) <= 0.0) return std::nullopt;
  }
  const Vec2 p = flat.image(0, {boundary.v[0], 0.0}), q = flat.image(1, {boundary.v[1], 0.0});
  // In order: corner, its ruling, the other ruling, the other corner.
  const Vec2 way = b - a;
  if (way.dot(q - p) <= 0.0 || way.dot(p - a) < -extent * kNoWidth ||
      way.dot(b - q) < -extent * kNoWidth)
    return std::nullopt;
  boundary.curve = flat.straight(boundary.v, kCurveTolerance * extent);
  return boundary;
}

// Tangent of the angle by which the line between two corners leans from straight across the bend.
double leaning(const Flat& flat, const std::array<Vec2, 2>& corners) {
  const double v = 0.5 * (corners[0].x() + corners[1].x());
  const Vec2 across = flat.image(1, {v, 0.0}) - flat.image(0, {v, 0.0});
  const double way = across.norm() + corners[0].y() + corners[1].y();
  return std::abs(corners[1].x() - corners[0].x()) / way;
}

bool within(const BendSurface& surface, const Boundaries& b, const Spread& legal,
            double tolerance) {
  for (int side = 0; side < 2; ++side)
    if (b.low.v[side] < surface.v_at(side, legal.first) - tolerance ||
        b.high.v[side] > surface.v_at(side, legal.second) + tolerance)
      return false;
  return true;
}

std::optional<Spread> widest(const std::vector<Spread>& legal, double low, double high) {
  std::optional<Spread> best;
  for (const Spread& section : legal) {
    const Spread part{std::max(low, section.first), std::min(high, section.second)};
    if (!best || part.second - part.first > best->second - best->first) best = part;
  }
  return best;
}

std::optional<Boundaries> straight_boundaries(const BendSurface& surface, const Flat& flat,
                                              const RunEnds& ends, const LateralOptions& options) {
  const auto low = straight(surface, flat, ends.low, options.extent);
  const auto high = straight(surface, flat, ends.high, options.extent);
  if (!low || !high) return std::nullopt;
  Boundaries both{LateralBoundary::straight, *low, *high};
  for (std::size_t side = 0; side < 2; ++side)
    if (both.high.v[side] - both.low.v[side] <= kNoWidth * options.extent) return std::nullopt;
  const double tolerance = kNoWidth * options.extent;
  for (const Spread& section : options.legal)
    if (within(surface, both, section, tolerance)) return both;
  return std::nullopt;
}

Result<Boundaries> directrix_boundaries(const BendSurface& surface, const RunEnds& ends,
                                        LateralBoundary kind, const LateralOptions& options) {
  const std::array low_ends{surface.level(0, ends.low[0].x()), surface.level(1, ends.low[1].x())};
  const std::array high_ends{surface.level(0, ends.high[0].x()),
                             surface.level(1, ends.high[1].x())};
  const bool corner = kind == LateralBoundary::corner;
  double low = corner ? std::max(low_ends[0], low_ends[1]) : 0.5 * (low_ends[0] + low_ends[1]);
  double high = corner ? std::min(high_ends[0], high_ends[1]) : 0.5 * (high_ends[0] + high_ends[1]);
  if (const auto section = widest(options.legal, low, high)) {
    low = section->first;
    high = section->second;
  } else {
    high = low;
  }
  const double width = surface.v_at(0, high) - surface.v_at(0, low);
  if (width <= -kNoWidth * options.extent)
    return fail(refuse::ranges_apart, {{"gap", -width, unit::mm}});
  if (width <= kNoWidth * options.extent) return fail(refuse::no_width);
  return Boundaries{kind, along_directrix(surface, low, options.extent),
                    along_directrix(surface, high, options.extent)};
}

}  // namespace

Boundary along_directrix(const BendSurface& surface, double level, double extent) {
  return {{surface.v_at(0, level), surface.v_at(1, level)},
          surface.at_level(level, kCurveTolerance * extent)};
}

Result<Boundaries> lateral_boundaries(const BendSurface& surface, const RunEnds& ends,
                                      LateralBoundary wanted, const LateralOptions& options) {
  Flat flat(surface, options.neutral_offset);
  flat.set_reference(std::max({ends.high[0].x(), ends.high[1].x()}));
  if (wanted == LateralBoundary::straight || wanted == LateralBoundary::automatic) {
    const bool near = wanted == LateralBoundary::straight ||
                      std::max(leaning(flat, ends.low), leaning(flat, ends.high)) < kLeaning;
    if (near)
      if (auto both = straight_boundaries(surface, flat, ends, options)) return *both;
    if (wanted == LateralBoundary::straight) return fail(refuse::straight_over_plate);
    wanted = LateralBoundary::corner;
  }
  return directrix_boundaries(surface, ends, wanted, options);
}

std::vector<Spread> material_between(std::vector<double> crossings) {
  std::ranges::sort(crossings);
  std::vector<Spread> material;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    material.emplace_back(crossings[i], crossings[i + 1]);
  return material;
}

std::vector<Spread> left_free(std::vector<Spread> taken, double low, double high) {
  std::ranges::sort(taken);
  std::vector<Spread> free;
  double from = low;
  for (const auto& [first, last] : taken) {
    if (std::min(first, high) > from) free.emplace_back(from, std::min(first, high));
    from = std::max(from, last);
  }
  if (high > from) free.emplace_back(from, high);
  return free;
}

std::vector<Spread> legal_sections(const std::vector<std::vector<Vec2>>& rings, double low,
                                   double high, double tolerance) {
  // Crossings of the line just below h = 0: a corner on it counts as above.
  std::vector<double> crossings;
  for (const std::vector<Vec2>& ring : rings)
    for (const auto& [a, b] : sides_of(ring)) {
      const bool a_below = a.y() < -tolerance, b_below = b.y() < -tolerance;
      if (a_below == b_below) continue;
      const double t = std::clamp(a.y() / (a.y() - b.y()), 0.0, 1.0);
      crossings.push_back(a.x() + t * (b.x() - a.x()));
    }
  return left_free(material_between(std::move(crossings)), low, high);
}

}  // namespace planish::connect_detail
