#include "planar.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <numbers>

// Points, derivatives, parts, chords and crossings of segments, arcs and cubic splines. What can be
// exact is: ends of parts are copied, arcs are sampled by the sagitta, spans by the bound h²/8
// max|B''|, whose B'' is largest at an end. Crossings with a line are roots of the heights of the
// poles above it, in Bernstein form, where an end that lies on the line is found from either side.

namespace planish {
namespace {

using namespace geometry_detail;
using std::numbers::pi;

Vec2 arc_point(const Arc& arc, double angle) {
  return arc.center + arc.radius * direction_of(angle);
}

std::vector<Vec2> arc_samples(const Arc& arc, double chord) {
  // A chord over the angle s deviates from the arc by r (1 − cos(s/2)) = 2 r sin²(s/4). At most a
  // quarter turn, so that a circle remains a polygon however coarse the chord.
  const double ratio = std::min(1.0, std::sqrt(chord / (2.0 * arc.radius)));
  const double step = std::min(pi / 2.0, 4.0 * std::asin(ratio));
  const auto n = static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(arc.sweep) / step)));
  std::vector<Vec2> points;
  points.reserve(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    points.push_back(arc_point(arc, arc.start + t * arc.sweep));
  }
  return points;
}

std::vector<Vec2> spline_samples(const CubicSpline& spline, double chord) {
  std::vector<Vec2> points{first_pole(spline)};
  for (std::size_t i = 0; i < span_count(spline); ++i) {
    const Bezier b = span(spline, i);
    // A chord over a parameter step h deviates from the curve by at most h²/8 max|B''|, and B'' is
    // largest at an end of the span.
    const double second = std::max(bezier_second(b, 0.0).norm(), bezier_second(b, 1.0).norm());
    const auto n = static_cast<std::size_t>(
        std::max(1.0, std::ceil(std::sqrt(second / (8.0 * chord)))));
    for (std::size_t k = 1; k < n; ++k) {
      points.push_back(bezier_point(b, static_cast<double>(k) / static_cast<double>(n)));
    }
    points.push_back(b[3]);
  }
  return points;
}

/// The rounding noise of the heights of a, b above the line, for coordinates this large.
double height_noise(const Vec2& a, const Vec2& b, const Vec2& origin) {
  return 4.0 * kEpsilon * (largest(a) + largest(b) + largest(origin));
}

std::vector<double> arc_crossings(const Arc& arc, const Vec2& origin, const Vec2& normal) {
  const double height = normal.dot(arc.center - origin);
  if (std::abs(height) > arc.radius) return {};
  const double middle = angle_of(normal);
  const double half = std::acos(std::clamp(-height / arc.radius, -1.0, 1.0));
  const double size = std::abs(arc.sweep);
  // An end that lies on the line is found from either side of it.
  const double noise = 8.0 * kEpsilon * (pi + std::abs(arc.start) + size);
  std::vector<double> found;
  for (const double angle : {middle - half, middle + half}) {
    double delta = std::remainder((angle - arc.start) * (arc.sweep < 0.0 ? -1.0 : 1.0), 2.0 * pi);
    if (delta < -noise) delta += 2.0 * pi;
    if (delta <= size + noise) found.push_back(std::clamp(delta / size, 0.0, 1.0));
  }
  std::ranges::sort(found);
  return found;
}

std::vector<double> spline_crossings(const CubicSpline& spline, const Vec2& origin,
                                     const Vec2& normal) {
  const std::size_t n = span_count(spline);
  std::vector<double> found;
  for (std::size_t i = 0; i < n; ++i) {
    const Bezier b = span(spline, i);
    std::array<double, 4> height{};
    double highest = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      height[k] = normal.dot(b[k] - origin);
      highest = std::max(highest, std::abs(height[k]));
    }
    const auto [low, high] = std::ranges::minmax_element(height);
    if (*low > 0.0 || *high < 0.0) continue;
    if (highest <= std::max(height_noise(b[0], b[1], origin), height_noise(b[2], b[3], origin)))
      continue;
    for (const double root : roots(height)) {
      const double t = (static_cast<double>(i) + root) / static_cast<double>(n);
      // A crossing at a joint is the end of one span and the start of the next.
      if (found.empty() || t > found.back()) found.push_back(t);
    }
  }
  return found;
}

CubicSpline trimmed_spline(const CubicSpline& spline, double t0, double t1) {
  const std::size_t n = span_count(spline);
  // A rounded parameter of a joint must not leave a span of no length.
  const auto snapped = [n](double t) {
    const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(n);
    const double whole = std::round(x);
    return std::abs(x - whole) <= 4.0 * kEpsilon * static_cast<double>(n) ? whole : x;
  };
  const double from = snapped(t0);
  const double to = snapped(t1);
  const std::size_t first = std::min(static_cast<std::size_t>(from), n - 1);
  const std::size_t last = std::max(first + 1,
                                    std::min(static_cast<std::size_t>(std::ceil(to)), n));
  CubicSpline part;
  for (std::size_t i = first; i < last; ++i) {
    const double base = static_cast<double>(i);
    const Bezier b = bezier_part(span(spline, i), std::max(0.0, from - base),
                                 std::min(1.0, to - base));
    part.poles.insert(part.poles.end(), b.begin() + (part.poles.empty() ? 0 : 1), b.end());
  }
  return part;
}

}  // namespace

bool is_regular(const Curve2& curve) {
  struct Regular {
    static bool in_reach(const Vec2& p) { return (p.array().abs() <= kFarthest).all(); }
    bool operator()(const Segment& s) const { return in_reach(s.a) && in_reach(s.b); }
    bool operator()(const Arc& a) const {
      return (a.center.array().abs() <= kLargestRadius).all() && a.radius > 0.0 &&
             a.radius <= kLargestRadius && is_turn(a) && in_reach(arc_point(a, a.start)) &&
             in_reach(arc_point(a, a.start + a.sweep));
    }
    bool operator()(const CubicSpline& s) const {
      return s.poles.size() >= 4 && s.poles.size() % 3 == 1 &&
             std::ranges::all_of(s.poles, in_reach);
    }
  };
  return std::visit(Regular{}, curve);
}

bool is_regular(const Loop& loop) {
  return std::ranges::all_of(loop, [](const Curve2& curve) { return is_regular(curve); });
}

Vec2 point_at(const Curve2& curve, double t) {
  return std::visit(Overloaded{
                        [t](const Segment& s) -> Vec2 { return (1.0 - t) * s.a + t * s.b; },
                        [t](const Arc& a) -> Vec2 { return arc_point(a, a.start + t * a.sweep); },
                        [t](const CubicSpline& s) -> Vec2 {
                          const auto [i, local] = locate(s, t);
                          return bezier_point(span(s, i), local);
                        },
                    },
                    curve);
}

Vec2 derivative_at(const Curve2& curve, double t) {
  return std::visit(
      Overloaded{
          [](const Segment& s) -> Vec2 { return s.b - s.a; },
          [t](const Arc& a) -> Vec2 {
            return a.radius * a.sweep * perpendicular(direction_of(a.start + t * a.sweep));
          },
          [t](const CubicSpline& s) -> Vec2 {
            const auto [i, local] = locate(s, t);
            return static_cast<double>(span_count(s)) * bezier_derivative(span(s, i), local);
          },
      },
      curve);
}

Vec2 start_of(const Curve2& curve) { return point_at(curve, 0.0); }
Vec2 end_of(const Curve2& curve) { return point_at(curve, 1.0); }

Curve2 reversed(const Curve2& curve) {
  return std::visit(Overloaded{
                        [](const Segment& s) -> Curve2 {
                          return Segment{s.b, s.a};
                        },
                        [](const Arc& a) -> Curve2 {
                          return Arc{a.center, a.radius, a.start + a.sweep, -a.sweep};
                        },
                        [](const CubicSpline& s) -> Curve2 {
                          return CubicSpline{{s.poles.rbegin(), s.poles.rend()}};
                        },
                    },
                    curve);
}

Loop reversed(const Loop& loop) {
  Loop back;
  back.reserve(loop.size());
  for (auto it = loop.rbegin(); it != loop.rend(); ++it)
    back.push_back(reversed(*it));
  return back;
}

Curve2 transformed(const Curve2& curve, const Isometry2& motion) {
  return std::visit(
      Overloaded{
          [&](const Segment& s) -> Curve2 {
            return Segment{motion * s.a, motion * s.b};
          },
          [&](const Arc& a) -> Curve2 {
            const double sense = motion.linear().determinant() < 0.0 ? -1.0 : 1.0;
            const Vec2 to_start = motion.linear() * direction_of(a.start);
            return Arc{motion * a.center, a.radius, angle_of(to_start), sense * a.sweep};
          },
          [&](const CubicSpline& s) -> Curve2 {
            CubicSpline moved = s;
            for (Vec2& pole : moved.poles)
              pole = motion * pole;
            return moved;
          },
      },
      curve);
}

Loop transformed(const Loop& loop, const Isometry2& motion) {
  return mapped(loop, [&](const Curve2& curve) { return transformed(curve, motion); });
}

Curve2 scaled(const Curve2& curve, double factor, const Vec2& about) {
  const auto moved = [&](const Vec2& p) -> Vec2 { return about + factor * (p - about); };
  Curve2 made = curve;
  if (auto* segment = std::get_if<Segment>(&made)) {
    *segment = {moved(segment->a), moved(segment->b)};
  } else if (auto* arc = std::get_if<Arc>(&made)) {
    arc->center = moved(arc->center);
    arc->radius *= factor;
  } else {
    for (Vec2& pole : std::get<CubicSpline>(made).poles)
      pole = moved(pole);
  }
  return made;
}

Loop scaled(const Loop& loop, double factor, const Vec2& about) {
  return mapped(loop, [&](const Curve2& curve) { return scaled(curve, factor, about); });
}

std::vector<Vec2> sampled(const Curve2& curve, double chord) {
  PLANISH_ASSERT(chord > 0.0);
  return std::visit(Overloaded{
                        [](const Segment& s) {
                          return std::vector<Vec2>{s.a, s.b};
                        },
                        [chord](const Arc& a) { return arc_samples(a, chord); },
                        [chord](const CubicSpline& s) { return spline_samples(s, chord); },
                    },
                    curve);
}

std::vector<Vec2> sampled(const Loop& loop, double chord) {
  std::vector<Vec2> ring;
  for (const Curve2& curve : loop) {
    const std::vector<Vec2> points = sampled(curve, chord);
    ring.insert(ring.end(), points.begin(), points.end() - 1);
  }
  return ring;
}

std::vector<double> crossings(const Curve2& curve, const Vec2& origin, const Vec2& direction) {
  const Vec2 normal = perpendicular(direction.stableNormalized());
  return std::visit(Overloaded{
                        [&](const Segment& s) -> std::vector<double> {
                          const double from = normal.dot(s.a - origin);
                          const double to = normal.dot(s.b - origin);
                          const double noise = height_noise(s.a, s.b, origin);
                          if (std::abs(from) <= noise && std::abs(to) <= noise) return {};
                          if ((from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)) return {};
                          return {from / (from - to)};
                        },
                        [&](const Arc& a) { return arc_crossings(a, origin, normal); },
                        [&](const CubicSpline& s) { return spline_crossings(s, origin, normal); },
                    },
                    curve);
}

Curve2 trimmed(const Curve2& curve, double t0, double t1) {
  PLANISH_ASSERT(t0 < t1);
  return std::visit(
      Overloaded{
          [&](const Segment& s) -> Curve2 {
            return Segment{point_at(s, t0), point_at(s, t1)};
          },
          [&](const Arc& a) -> Curve2 {
            return Arc{a.center, a.radius, a.start + t0 * a.sweep, (t1 - t0) * a.sweep};
          },
          [&](const CubicSpline& s) -> Curve2 { return trimmed_spline(s, t0, t1); },
      },
      curve);
}

}  // namespace planish
