// A function as a chain of cubic Hermite spans within a tolerance: halved, level by level, where
// the distance at equal parameters, and if need be the true one, is too large. Its error behaves as
// t²(1−t)²(a + bt), which says where to look.

#include "planar.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>

// A parametric curve as cubics. A Hermite span is compared with the curve where the error of one,
// t²(1−t)²(a + bt), is largest, and halved until all are near enough; all spans of a level are
// halved before the next, so that a hard place does not use up the limit on spans. The distance at
// equal parameters bounds the true one from above, and the nearest point is asked for only where
// that bound does not do. Ends are met exactly.

namespace planish {
namespace {

using namespace geometry_detail;

constexpr std::size_t kMostSpans = 4096;
/// Halvings of one place; beyond these, doubles cannot distinguish the parameters.
constexpr int kMostHalvings = 40;
/// Where a Hermite span is compared with the function. Its error behaves as t²(1−t)²(a + bt), which
/// is largest at the middle for b = 0 and at 0.5 ± √5/10 for a = −b/2; the outer two detect steeper
/// errors.
constexpr std::array<double, 5> kChecks{0.112, 0.276, 0.5, 0.724, 0.888};

struct Knot {
  double t = 0.0;
  CurveSample sample;
};

struct Span {
  Knot from;
  Knot to;
  Bezier poles;
  double deviation = 0.0;
  int halvings = 0;
};

/// A derivative that moves the point by less than this share of the span's size gives no direction:
/// half the digits, as for a difference quotient.
bool tells_direction(const Vec2& derivative, double step, double size) {
  return (derivative * step).norm() > std::sqrt(kEpsilon) * size;
}

struct Fitter {
  const CurveFunction& f;
  double tolerance;

  Knot knot(double t) const { return {t, f(t)}; }

  /// Pole next to the knot `at`, on the side of the knot `other`.
  Vec2 inner_pole(const Knot& at, const Knot& other, double size) const {
    const double step = other.t - at.t;
    if (tells_direction(at.sample.derivative, step, size)) {
      return at.sample.point + at.sample.derivative * step / 3.0;
    }
    // The curve stops here: its direction is where it goes next.
    const Vec2 chord = other.sample.point - at.sample.point;
    const double nearby = std::cbrt(kEpsilon);
    Vec2 ahead = f(at.t + nearby * step).point - at.sample.point;
    if (ahead.norm() <= 64.0 * kEpsilon * (size + largest(at.sample.point))) ahead = chord;
    if (ahead.isZero(0.0)) return at.sample.point;
    return at.sample.point + ahead.normalized() * chord.norm() / 3.0;
  }

  Span span_between(const Knot& from, const Knot& to, int halvings) const {
    std::array<Vec2, kChecks.size()> wanted;
    Box2 box;
    box.add(from.sample.point);
    box.add(to.sample.point);
    for (std::size_t i = 0; i < kChecks.size(); ++i) {
      wanted[i] = f(from.t + kChecks[i] * (to.t - from.t)).point;
      box.add(wanted[i]);
    }
    const double size = largest(box.size());
    Span made{from, to, {}, 0.0, halvings};
    made.poles = {from.sample.point, inner_pole(from, to, size), inner_pole(to, from, size),
                  to.sample.point};
    // Handles longer than the chord may make a span double back over points that it should pass
    // once.
    const double handles = (made.poles[1] - made.poles[0]).norm() +
                           (made.poles[3] - made.poles[2]).norm();
    const bool orderly = handles <= (made.poles[3] - made.poles[0]).norm();
    const CubicSpline alone{{made.poles.begin(), made.poles.end()}};
    // The distance at equal parameters bounds the distance between the curves from above; the true
    // distance is computed only where the bound is not enough, and only until the first that is not
    // enough either.
    std::array<double, kChecks.size()> apart;
    for (std::size_t i = 0; i < kChecks.size(); ++i)
      apart[i] = (bezier_point(made.poles, kChecks[i]) - wanted[i]).norm();
    for (std::size_t i = 0; orderly && i < kChecks.size(); ++i) {
      if (apart[i] <= tolerance) continue;
      const double nearer = nearest(alone, wanted[i]).distance;
      if (nearer > tolerance) break;
      apart[i] = nearer;
    }
    made.deviation = *std::ranges::max_element(apart);
    return made;
  }

  /// Knot near the middle, away from a place where f stands still, which has no common tangent.
  Knot middle(const Span& p) const {
    const double step = p.to.t - p.from.t;
    const double size = (p.to.sample.point - p.from.sample.point).norm();
    for (const double share : {0.5, 0.4375, 0.5625}) {
      const Knot k = knot(p.from.t + share * step);
      if (tells_direction(k.sample.derivative, step, size)) return k;
    }
    return knot(p.from.t + 0.5 * step);
  }
};

}  // namespace

FitReport fit_cubics(const CurveFunction& f, double t0, double t1, double tolerance) {
  const Fitter fitter{f, tolerance};
  std::vector<Span> spans{fitter.span_between(fitter.knot(t0), fitter.knot(t1), 0)};
  const auto wants_halving = [tolerance](const Span& p) {
    return p.deviation > tolerance && p.halvings < kMostHalvings;
  };
  // Level by level, so that the whole curve shares the limit on spans.
  while (std::ranges::any_of(spans, wants_halving) && spans.size() < kMostSpans) {
    std::vector<Span> finer;
    finer.reserve(2 * spans.size());
    std::size_t room = kMostSpans - spans.size();
    for (const Span& p : spans) {
      if (!wants_halving(p) || room == 0) {
        finer.push_back(p);
        continue;
      }
      --room;
      const Knot mid = fitter.middle(p);
      finer.push_back(fitter.span_between(p.from, mid, p.halvings + 1));
      finer.push_back(fitter.span_between(mid, p.to, p.halvings + 1));
    }
    spans = std::move(finer);
  }
  FitReport report;
  report.spline.poles.push_back(spans.front().poles[0]);
  for (const Span& p : spans) {
    report.spline.poles.insert(report.spline.poles.end(), p.poles.begin() + 1, p.poles.end());
    report.deviation = std::max(report.deviation, p.deviation);
  }
  return report;
}

CubicSpline fit_cubics_on_surface(const CurveFunction& f, double t0, double t1, double u_scale,
                                  double tolerance) {
  const auto scaled = [&](double t) {
    CurveSample sample = f(t);
    sample.point.x() *= u_scale;
    sample.derivative.x() *= u_scale;
    return sample;
  };
  CubicSpline spline = fit_cubics(scaled, t0, t1, tolerance).spline;
  for (Vec2& pole : spline.poles)
    pole.x() /= u_scale;
  return spline;
}

}  // namespace planish
