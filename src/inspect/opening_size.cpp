// The largest circle that fits into an opening touches it: from places along its curves the circle
// that touches there is shrunk until it touches a second time; the best place is refined by halving
// steps. The search ends once a circle is as large as the rule wants.

#include "rule_checks.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/box_tree.hpp>

// The largest circle within an opening. It touches the opening, so places of contact are tried
// along its curves: a circle that touches there is shrunk until it touches the point nearest to its
// centre too, and the best place is refined by halving steps. Search stops at what the rule asks
// for, since more is not a finding.

namespace planish::inspect_detail {
namespace {

struct NearestPoint {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 point = Vec2::Zero();
};

NearestPoint nearest_point(const Opening& opening, const Vec2& p) {
  const Box2 place{p, p};
  NearestPoint best;
  for (size_t i = 0; i < opening.loop->size(); ++i) {
    if (box_distance(opening.boxed.boxes[i], place) >= best.distance) continue;
    const Curve2& curve = (*opening.loop)[i];
    const Nearest found = nearest(curve, p);
    if (found.distance < best.distance) best = {found.distance, point_at(curve, found.t)};
  }
  return best;
}

/// Radius of the largest circle within the opening that touches it at p, where `in` points inwards:
/// too large a circle is shrunk until it touches the point nearest to its centre.
double touching_radius(const Opening& opening, const Vec2& p, const Vec2& in) {
  double radius = opening.boxed.box.size().norm();
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps; ++step) {
    const NearestPoint touched = nearest_point(opening, p + radius * in);
    if (touched.distance >= radius * (1.0 - tolerance::kComputed)) break;
    const double ahead = (touched.point - p).dot(in);
    if (ahead <= 0.0) return 0.0;
    radius = std::min(radius, (touched.point - p).squaredNorm() / (2.0 * ahead));
  }
  return radius;
}

/// Number of places tried on a curve, away from its ends, where there may be corners.
int place_count(const Curve2& curve) {
  constexpr int kPlaces = 8;
  const auto* spline = std::get_if<CubicSpline>(&curve);
  return spline ? kPlaces * static_cast<int>(std::min<size_t>(spline->poles.size() / 3, 8))
                : kPlaces;
}

/// Radius of the largest circle that fits into the opening, sought only up to `enough`. A largest
/// circle touches the opening, so places of contact are tried along its curves, and the best is
/// refined by halving the steps.
double inscribed_radius(const Opening& opening, double enough) {
  const double turn = signed_area(*opening.loop) < 0.0 ? -1.0 : 1.0;
  const auto radius_at = [&](const Curve2& curve, double t) {
    const Vec2 along = derivative_at(curve, t).stableNormalized();
    return touching_radius(opening, point_at(curve, t), turn * perpendicular(along));
  };
  double best = 0.0;
  const Curve2* best_curve = nullptr;
  double best_t = 0.0;
  for (const Curve2& curve : *opening.loop) {
    const int places = place_count(curve);
    for (int i = 0; i < places && best < enough; ++i) {
      const double t = (i + 0.5) / places;
      const double radius = radius_at(curve, t);
      if (radius <= best) continue;
      best = radius;
      best_curve = &curve;
      best_t = t;
    }
  }
  constexpr double kFinest = 1e-6;  // of a curve
  for (double step = 1.0 / 16.0; step > kFinest && best < enough && best_curve; step *= 0.5) {
    for (const double t : {best_t - step, best_t + step}) {
      if (t <= 0.0 || t >= 1.0) continue;
      const double radius = radius_at(*best_curve, t);
      if (radius <= best) continue;
      best = radius;
      best_t = t;
    }
  }
  return best;
}

}  // namespace

std::vector<Observation> observe_opening_sizes(const Workpiece& workpiece, const Rules& rules) {
  const double limit = rules.smallest_opening_t * workpiece.thickness;
  std::vector<Observation> result;
  for (const Opening& opening : workpiece.openings) {
    if (opening.is_cut) continue;
    const double width = 2.0 * inscribed_radius(opening, 0.5 * limit);
    if (width >= limit - kDrawn) continue;
    const Facts facts{{"opening", place::point(opening.center)},
                      {"size", opening.size},
                      {"measured", width, unit::mm},
                      {"wanted", limit, unit::mm},
                      {"rule", factors_text(rules.smallest_opening_t)}};
    result.push_back({"smallest_opening",
                      breach(Severity::warning, say::small_opening, facts, {opening.center}),
                      width - limit});
  }
  return result;
}

}  // namespace planish::inspect_detail
