#include "planar.hpp"

#include <planish/geometry/region.hpp>

#include <numbers>

namespace planish {
namespace {

using namespace planar;
constexpr double pi = std::numbers::pi;

/// Parameters inside (0, 1), ascending, where a curve turns from rising to falling or back.
std::vector<double> turning_points(const Curve2& curve) {
  return std::visit(
      Overloaded{
          [](const Segment&) { return std::vector<double>{}; },
          [](const Arc& arc) {
            std::vector<double> found;
            const double lo = std::min(arc.start, arc.start + arc.sweep);
            const double hi = std::max(arc.start, arc.start + arc.sweep);
            for (double k = std::ceil(lo / pi - 0.5); (k + 0.5) * pi <= hi; k += 1.0) {
              found.push_back(std::clamp(((k + 0.5) * pi - arc.start) / arc.sweep, 0.0, 1.0));
            }
            std::sort(found.begin(), found.end());
            return found;
          },
          [](const CubicSpline& spline) {
            const std::size_t n = piece_count(spline);
            std::vector<double> found;
            for (std::size_t i = 0; i < n; ++i) {
              if (i > 0) found.push_back(static_cast<double>(i) / static_cast<double>(n));
              for (const double t : extrema(piece(spline, i), 1)) {
                found.push_back((static_cast<double>(i) + t) / static_cast<double>(n));
              }
            }
            return found;
          },
      },
      curve);
}

/// x where the monotone part of a curve between parameters t0 and t1 passes height y.
double x_at_height(const Curve2& curve, double t0, double t1, double y) {
  if (const Segment* s = std::get_if<Segment>(&curve)) {
    return s->a.x() + (y - s->a.y()) / (s->b.y() - s->a.y()) * (s->b.x() - s->a.x());
  }
  if (const Arc* arc = std::get_if<Arc>(&curve)) {
    const double sine = std::clamp((y - arc->center.y()) / arc->radius, -1.0, 1.0);
    const double side = std::cos(arc->start + 0.5 * (t0 + t1) * arc->sweep) < 0.0 ? -1.0 : 1.0;
    return arc->center.x() + side * arc->radius * std::sqrt(1.0 - sine * sine);
  }
  const bool rises = point_at(curve, t1).y() > point_at(curve, t0).y();
  while (true) {
    const double mid = 0.5 * (t0 + t1);
    if (mid <= t0 || mid >= t1) return point_at(curve, mid).x();
    ((point_at(curve, mid).y() > y) == rises ? t1 : t0) = mid;
  }
}

/// Crossings of the ray from p towards +x with a curve that runs from a to b. Each monotone part
/// owns its lower end and not its upper, so that a joint on the ray counts once; neighbours are
/// handed the same joint, so that their rounding cannot open a gap.
int ray_crossings(const Curve2& curve, const Vec2& a, const Vec2& b, const Vec2& p) {
  const Box2 box = bounds(curve);
  const double top = std::max({box.hi.y(), a.y(), b.y()});
  const double bottom = std::min({box.lo.y(), a.y(), b.y()});
  if (p.y() < bottom || p.y() > top || p.x() > box.hi.x()) return 0;
  std::vector<double> ts = turning_points(curve);
  ts.push_back(1.0);
  int count = 0;
  double t0 = 0.0;
  double y0 = a.y();
  for (std::size_t i = 0; i < ts.size(); ++i) {
    const double y1 = i + 1 == ts.size() ? b.y() : point_at(curve, ts[i]).y();
    if ((y0 > p.y()) != (y1 > p.y()) && x_at_height(curve, t0, ts[i], p.y()) > p.x()) ++count;
    t0 = ts[i];
    y0 = y1;
  }
  return count;
}

bool encloses(const Loop& loop, const Vec2& p) {
  int count = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 end = start_of(loop[(i + 1) % loop.size()]);
    count += ray_crossings(loop[i], start_of(loop[i]), end, p);
  }
  return count % 2 == 1;
}

}  // namespace

double area(const Region& region) {
  double sum = std::abs(signed_area(region.outer));
  for (const Loop& opening : region.openings)
    sum -= std::abs(signed_area(opening));
  return sum;
}

bool contains(const Region& region, const Vec2& p) {
  return encloses(region.outer, p) && std::none_of(region.openings.begin(), region.openings.end(),
                                                   [&](const Loop& l) { return encloses(l, p); });
}

Polygon polygon_of(const Region& region, double chord) {
  Polygon polygon;
  polygon.outer = sampled(region.outer, chord);
  for (const Loop& opening : region.openings)
    polygon.holes.push_back(sampled(opening, chord));
  return polygon;
}

double ring_area(const std::vector<Vec2>& ring) {
  if (ring.empty()) return 0.0;
  // About the first corner: far from the origin the products would swallow a small area.
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  }
  return 0.5 * twice;
}

bool inside(const std::vector<std::vector<Vec2>>& rings, const Vec2& p) {
  bool in = false;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if ((cross(b - a, p - a) > 0.0) == (b.y() > a.y())) in = !in;
    }
  }
  return in;
}

namespace {

/// Convex hull, counter-clockwise, without points on its edges (Andrew's chains).
std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  const auto add_chain = [&hull](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *it - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*it);
    }
    hull.pop_back();  // begins the other chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

EnclosingRectangle rectangle(double along, double across, const Vec2& direction) {
  const Vec2 long_side = along >= across ? direction : perpendicular(direction);
  double angle = angle_of(long_side);
  if (angle > pi / 2.0) angle -= pi;
  if (angle <= -pi / 2.0) angle += pi;
  return {{std::max(along, across), std::min(along, across)}, angle};
}

}  // namespace

EnclosingRectangle smallest_rectangle(const std::vector<Vec2>& points) {
  const std::vector<Vec2> hull = hull_of(points);
  const std::size_t n = hull.size();
  if (n < 2) return {Vec2::Zero(), 0.0};
  if (n == 2)
    return rectangle((hull[1] - hull[0]).norm(), 0.0, (hull[1] - hull[0]).stableNormalized());

  // A smallest rectangle has a side on an edge of the hull. The three corners farthest ahead,
  // across and behind only move on as the edges turn.
  EnclosingRectangle best;
  double smallest = std::numeric_limits<double>::infinity();
  std::size_t ahead = 1;
  std::size_t across = 1;
  std::size_t behind = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 u = (hull[(i + 1) % n] - hull[i]).stableNormalized();
    const Vec2 v = perpendicular(u);
    const auto advance = [&](std::size_t& corner, const Vec2& direction) {
      for (std::size_t steps = 0; steps < n; ++steps) {
        const Vec2 step = hull[(corner + 1) % n] - hull[corner % n];
        if (!(direction.dot(step) > 0.0)) break;
        ++corner;
      }
    };
    ahead = std::max(ahead, i + 1);
    advance(ahead, u);
    across = std::max(across, ahead);
    advance(across, v);
    behind = std::max(behind, across);
    advance(behind, -u);
    const double width = u.dot(hull[ahead % n] - hull[behind % n]);
    const double height = v.dot(hull[across % n] - hull[i]);
    if (width * height < smallest) {
      smallest = width * height;
      best = rectangle(width, height, u);
    }
  }
  return best;
}

}  // namespace planish
