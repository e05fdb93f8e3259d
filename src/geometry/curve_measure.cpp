// Lengths, areas and nearest points of curves. A spline's length is integrated by Gauss's rule,
// halved until halves agree; its area is exact in terms of its poles. The nearest point is sought
// by subdivision: a part whose smallest coefficient of |B|² exceeds the best is left out, and a
// single minimum is found by Newton.

#include "planar.hpp"

#include <planish/base/id_vector.hpp>

#include <numbers>

// Lengths, areas, boxes and nearest points. Areas are exact: Green's integral of products of poles,
// about a point nearby, since far from the origin rounding would swamp them. Lengths of spans are
// Gauss–Legendre integrals, halved until they agree. The nearest point of a span is found by branch
// and bound: |B|² in Bernstein form is at least its smallest coefficient, so halves that cannot
// beat the best are left out, and where one minimum remains Newton finishes in a bracket.

namespace planish {
namespace {

using namespace geometry_detail;
using std::numbers::pi;

constexpr std::size_t kGaussPoints = 16;

struct GaussRule {
  std::array<double, kGaussPoints> node{};  // on [0, 1]
  std::array<double, kGaussPoints> weight{};
};

/// Gauss–Legendre rule: nodes are roots of the Legendre polynomial, found by Newton.
const GaussRule& gauss_rule() {
  static const GaussRule rule = [] {
    GaussRule r;
    const double n = static_cast<double>(kGaussPoints);
    for (std::size_t i = 0; i < kGaussPoints; ++i) {
      double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
      double slope = 0.0;
      for (int step = 0; step < 10; ++step) {
        double before = 1.0;
        double value = x;
        for (std::size_t k = 2; k <= kGaussPoints; ++k) {
          const double d = static_cast<double>(k);
          before = std::exchange(value, ((2.0 * d - 1.0) * x * value - (d - 1.0) * before) / d);
        }
        slope = n * (before - x * value) / (1.0 - x * x);
        x -= value / slope;
      }
      r.node[i] = 0.5 * (1.0 - x);
      r.weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    return r;
  }();
  return rule;
}

double gauss_length(const Bezier& b, double t0, double t1) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kGaussPoints; ++i) {
    const double t = t0 + (t1 - t0) * gauss_rule().node[i];
    sum += gauss_rule().weight[i] * bezier_derivative(b, t).norm();
  }
  return sum * (t1 - t0);
}

/// Halves until both halves agree with the whole. At a cusp the speed has a corner; the error there
/// shrinks with the square of the step, so that 30 halvings reach the last bit.
double adaptive_length(const Bezier& b, double t0, double t1, double whole, double allowed,
                       int depth) {
  const double mid = 0.5 * (t0 + t1);
  const double left = gauss_length(b, t0, mid);
  const double right = gauss_length(b, mid, t1);
  if (depth == 0 || std::abs(left + right - whole) <= allowed) return left + right;
  return adaptive_length(b, t0, mid, left, allowed, depth - 1) +
         adaptive_length(b, mid, t1, right, allowed, depth - 1);
}

double span_length(const Bezier& b) {
  const double polygon = (b[1] - b[0]).norm() + (b[2] - b[1]).norm() + (b[3] - b[2]).norm();
  const double allowed = 32.0 * kEpsilon * polygon;
  return adaptive_length(b, 0.0, 1.0, gauss_length(b, 0.0, 1.0), allowed, 30);
}

/// Green integral about `o`, exact for cubics: ½∫ B × B' dt in terms of products of poles.
double span_green(const Bezier& b, const Vec2& o) {
  const Vec2 p0 = b[0] - o;
  const Vec2 p1 = b[1] - o;
  const Vec2 p2 = b[2] - o;
  const Vec2 p3 = b[3] - o;
  return (6.0 * (cross(p0, p1) + cross(p2, p3)) +
          3.0 * (cross(p0, p2) + cross(p1, p2) + cross(p1, p3)) + cross(p0, p3)) /
         20.0;
}

double green_area_about(const Curve2& curve, const Vec2& o) {
  return std::visit(Overloaded{
                        [&](const Segment& s) { return 0.5 * cross(s.a - o, s.b - o); },
                        [&](const Arc& a) {
                          // End minus start, without the noise of a centre far away.
                          const double half = 0.5 * a.sweep;
                          const Vec2 chord = 2.0 * a.radius * std::sin(half) *
                                             perpendicular(direction_of(a.start + half));
                          return 0.5 * (cross(a.center - o, chord) + a.radius * a.radius * a.sweep);
                        },
                        [&](const CubicSpline& s) {
                          double sum = 0.0;
                          for (std::size_t i = 0; i < span_count(s); ++i)
                            sum += span_green(span(s, i), o);
                          return sum;
                        },
                    },
                    curve);
}

Box2 arc_bounds(const Arc& arc) {
  PLANISH_ASSERT(is_turn(arc));
  Box2 box;
  box.add(start_of(arc));
  box.add(end_of(arc));
  const double lo = std::min(arc.start, arc.start + arc.sweep);
  const double hi = std::max(arc.start, arc.start + arc.sweep);
  // The four extreme points, each at quarter turns k with lo <= k·90° <= hi.
  for (double k = std::ceil(lo / (pi / 2.0)); k <= hi / (pi / 2.0); k += 1.0) {
    const auto quarter = static_cast<int>(k - 4.0 * std::floor(k / 4.0));
    const std::array<Vec2, 4> out{Vec2::UnitX(), Vec2::UnitY(), -Vec2::UnitX(), -Vec2::UnitY()};
    box.add(arc.center + arc.radius * out[quarter]);
  }
  return box;
}

Nearest nearest_on_segment(const Segment& s, const Vec2& p) {
  const double t = nearest_share(s, p);
  return {(point_at(s, t) - p).norm(), t};
}

Nearest nearest_on_arc(const Arc& arc, const Vec2& p) {
  const Vec2 d = p - arc.center;
  const double size = std::abs(arc.sweep);
  const Vec2 from = direction_of(arc.start);
  double delta = d.isZero(0.0) ? 0.0 : turn(from, d) * (arc.sweep < 0.0 ? -1.0 : 1.0);
  if (delta < 0.0) delta += 2.0 * pi;
  if (delta <= size) return {std::abs(d.norm() - arc.radius), std::min(1.0, delta / size)};
  const double to_start = (start_of(arc) - p).norm();
  const double to_end = (end_of(arc) - p).norm();
  return to_start <= to_end ? Nearest{to_start, 0.0} : Nearest{to_end, 1.0};
}

/// Finds the point of one span nearest to the origin of `poles`, if it beats `best`.
struct NearestOnSpan {
  Bezier poles;  // relative to the point
  double best;   // squared distance to beat
  double t = -1.0;

  void offer(double at) {
    const double d = bezier_point(poles, at).squaredNorm();
    if (d < best) {
      best = d;
      t = at;
    }
  }

  /// The only minimum in [a, b]: Newton on B·B' = 0 inside a bracket.
  void polish(double a, double b) {
    double x = 0.5 * (a + b);
    for (int step = 0; step < 100; ++step) {
      const Vec2 value = bezier_point(poles, x);
      const Vec2 first = bezier_derivative(poles, x);
      const double g = value.dot(first);
      const double slope = first.squaredNorm() + value.dot(bezier_second(poles, x));
      (g < 0.0 ? a : b) = x;
      double next = slope > 0.0 ? x - g / slope : a;
      if (!(next > a && next < b)) next = 0.5 * (a + b);
      if (std::abs(next - x) <= kEpsilon) break;
      x = next;
    }
    offer(x);
  }

  void search(const std::array<double, 7>& c, double lo, double hi) {
    const auto [least, most] = std::ranges::minmax_element(c);
    // |B|² is at least its smallest coefficient; a gain within rounding of the best is no gain.
    if (*least >= best - 8.0 * kEpsilon * *most) return;
    std::array<double, 6> rise{};
    for (std::size_t i = 0; i < 6; ++i)
      rise[i] = c[i + 1] - c[i];
    offer(lo);
    offer(hi);
    const int changes = sign_changes(rise);
    if (changes == 0) return;
    if (changes == 1) {
      const auto first = std::ranges::find_if(rise, [](double r) { return r != 0.0; });
      if (*first < 0.0) polish(lo, hi);
      return;
    }
    if (hi - lo <= 2.0 * kEpsilon) return;
    const auto [left, right] = split(c, 0.5);
    search(left, lo, 0.5 * (lo + hi));
    search(right, 0.5 * (lo + hi), hi);
  }
};

Nearest nearest_on_spline(const CubicSpline& spline, const Vec2& p) {
  const std::size_t n = span_count(spline);
  double best = std::numeric_limits<double>::infinity();
  double at = 0.0;
  for (std::size_t i = 0; i <= n; ++i) {  // joints first: a good bound skips most spans
    const double d = (spline.poles[3 * i] - p).squaredNorm();
    if (d < best) {
      best = d;
      at = static_cast<double>(i);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    NearestOnSpan task{span(spline, i), best};
    Box2 hull;
    for (Vec2& pole : task.poles) {
      pole -= p;
      hull.add(pole);
    }
    const Vec2 gap = hull.lo.cwiseMax(-hull.hi).cwiseMax(Vec2::Zero());
    if (gap.squaredNorm() >= best) continue;
    task.search(square(task.poles), 0.0, 1.0);
    if (task.best < best) {
      best = task.best;
      at = static_cast<double>(i) + task.t;
    }
  }
  return {std::sqrt(best), at / static_cast<double>(n)};
}

}  // namespace

double length(const Curve2& curve) {
  return std::visit(Overloaded{
                        [](const Segment& s) { return (s.b - s.a).norm(); },
                        [](const Arc& a) { return a.radius * std::abs(a.sweep); },
                        [](const CubicSpline& s) {
                          double sum = 0.0;
                          for (std::size_t i = 0; i < span_count(s); ++i)
                            sum += span_length(span(s, i));
                          return sum;
                        },
                    },
                    curve);
}

double length(const Loop& loop) {
  return sum_of(loop, [&](const Curve2& curve) { return length(curve); });
}

double green_area(const Curve2& curve) { return green_area_about(curve, Vec2::Zero()); }

double signed_area(const Loop& loop) {
  if (loop.empty()) return 0.0;
  // About a point of the loop: far from the origin, rounding of the products would swamp a small
  // area.
  const Vec2 o = start_of(loop.front());
  return sum_of(loop, [&](const Curve2& curve) { return green_area_about(curve, o); });
}

Box2 bounds(const Curve2& curve) {
  return std::visit(Overloaded{
                        [](const Segment& s) {
                          Box2 box;
                          box.add(s.a);
                          box.add(s.b);
                          return box;
                        },
                        [](const Arc& a) { return arc_bounds(a); },
                        [](const CubicSpline& s) {
                          Box2 box;
                          box.add(first_pole(s));
                          for (std::size_t i = 0; i < span_count(s); ++i) {
                            const Bezier b = span(s, i);
                            box.add(b[3]);
                            for (const int axis : {0, 1}) {
                              for (const double t : extrema(b, axis))
                                box.add(bezier_point(b, t));
                            }
                          }
                          return box;
                        },
                    },
                    curve);
}

Box2 bounds(const Loop& loop) {
  Box2 box;
  for (const Curve2& curve : loop)
    box.add(bounds(curve));
  return box;
}

Nearest nearest(const Curve2& curve, const Vec2& p) {
  return std::visit(Overloaded{
                        [&](const Segment& s) { return nearest_on_segment(s, p); },
                        [&](const Arc& a) { return nearest_on_arc(a, p); },
                        [&](const CubicSpline& s) { return nearest_on_spline(s, p); },
                    },
                    curve);
}

}  // namespace planish
