// A smooth spline as arcs within a tolerance: biarcs, two arcs with a common tangent that match the
// tangents at both ends. Each is made as long as the tolerance allows, by halving from the length
// of the one before. Corners are kept; an arc that is nearly straight becomes its chord.

#include "planar.hpp"
#include "recognition.hpp"

#include <planish/geometry/fit.hpp>

#include <optional>

// A spline as arcs and lines. Between corners the longest part that one biarc follows within the
// tolerance is taken, again and again: two arcs with the spline's tangents at both ends that touch
// where they meet, at equal distances along those tangents. The length of the last step is the
// first guess of the next, doubled or halved. Both curves are measured from the other, so neither
// has a bulge that the other lacks; a part too short for an arc becomes its chord.

namespace planish {
namespace {

using namespace geometry_detail;

/// A joint of spans that turns by more (about 0.06°) is a corner and is kept; fitting leaves less
/// at the joints of a smooth curve.
constexpr double kCorner = 1e-3;
/// An arc that turns by less is replaced by its chord: the tangent is off by half of this, and with
/// a radius 10⁵ times the length, the arc's ends would have only eleven digits.
constexpr double kFlat = 1e-5;
/// Comparisons along a biarc: its distance from the curve has about four extremes.
constexpr int kComparisons = 32;

/// A part of the spline in its own parameter: span number plus parameter in the span.
struct Part {
  double from = 0.0;
  double to = 0.0;
};

/// A smooth spline, and the biarcs that follow it.
struct BiarcChain {
  const CubicSpline& spline;
  double tolerance;

  Vec2 point(double x) const {
    const auto [i, t] = local(x);
    return bezier_point(span(spline, i), t);
  }

  std::pair<std::size_t, double> local(double x) const {
    const std::size_t i = std::min(static_cast<std::size_t>(x), span_count(spline) - 1);
    return {i, x - static_cast<double>(i)};
  }

  /// Tangent just after x (`ahead` > 0) or just before it; where the derivative vanishes, the
  /// direction in which the curve continues.
  Vec2 tangent(double x, double ahead) const {
    auto [i, t] = local(x);
    if (ahead < 0.0 && t == 0.0 && i > 0) {
      --i;
      t = 1.0;
    }
    const Bezier b = span(spline, i);
    const double size = (b[1] - b[0]).norm() + (b[2] - b[1]).norm() + (b[3] - b[2]).norm();
    const Vec2 first = bezier_derivative(b, t);
    if (first.norm() > std::sqrt(kEpsilon) * size) return first.normalized();
    const Vec2 second = ahead * bezier_second(b, t);
    if (second.norm() > std::sqrt(kEpsilon) * size) return second.normalized();
    const Vec2 third = b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0];
    return third.isZero(0.0) ? Vec2(Vec2::UnitX()) : third.normalized();
  }

  /// The part with one span per span of the spline, for measuring distances to it.
  CubicSpline cut(const Part& part) const {
    const double n = static_cast<double>(span_count(spline));
    return std::get<CubicSpline>(trimmed(spline, part.from / n, part.to / n));
  }

  /// Arc from a to b that leaves a along `tangent`, or its chord if it is nearly straight.
  static Curve2 arc_leaving(const Vec2& a, const Vec2& along, const Vec2& b) {
    const double sweep = 2.0 * turn(along, b - a);
    if (std::abs(sweep) < kFlat) return Segment{a, b};
    return arc_between(a, b, sweep);
  }

  /// Two arcs with the part's tangents at its ends and a common tangent where they meet, at equal
  /// distances along the end tangents. Empty if those tangents point apart.
  std::optional<std::array<Curve2, 2>> biarc(const Part& part) const {
    const Vec2 a = point(part.from);
    const Vec2 b = point(part.to);
    const Vec2 ta = tangent(part.from, 1.0);
    const Vec2 tb = tangent(part.to, -1.0);
    const Vec2 v = b - a;
    const double forward = v.dot(ta + tb);
    const double square = v.squaredNorm();
    if (!(forward > 0.0) || v.dot(ta) <= 0.0 || v.dot(tb) <= 0.0) return std::nullopt;
    const double d = square /
                     (forward + std::sqrt(forward * forward + (ta - tb).squaredNorm() * square));
    const Vec2 joint = 0.5 * ((a + d * ta) + (b - d * tb));
    const Curve2 second = reversed(arc_leaving(b, -tb, joint));
    return std::array<Curve2, 2>{arc_leaving(a, ta, joint), second};
  }

  bool close(const std::array<Curve2, 2>& arcs, const Part& part) const {
    const double allowed = kBetweenStations * tolerance;
    const double spans = std::ceil(part.to) - std::floor(part.from);
    const int n = kComparisons * std::max(1, static_cast<int>(spans / 4.0));
    for (int k = 1; k < n; ++k) {
      const Vec2 p = point(part.from + (part.to - part.from) * k / n);
      if (std::min(nearest(arcs[0], p).distance, nearest(arcs[1], p).distance) > allowed)
        return false;
    }
    const CubicSpline alone = cut(part);
    for (const Curve2& arc : arcs) {
      for (int k = 1; k <= kComparisons / 4; ++k) {
        const Vec2 p = point_at(arc, k / (kComparisons / 4.0));
        if (nearest(alone, p).distance > allowed) return false;
      }
    }
    return true;
  }

  std::optional<std::array<Curve2, 2>> fitting(const Part& part) const {
    auto arcs = biarc(part);
    if (arcs && !close(*arcs, part)) arcs.reset();
    return arcs;
  }

  /// The longest possible biarcs, from first to last. Each step starts from the previous one's
  /// length; five halvings place its end within a thirtieth.
  std::vector<Curve2> along(const Part& whole) const {
    std::vector<Curve2> made;
    const auto add = [&made](const Curve2& curve) {
      if (length(curve) > 0.0) made.push_back(curve);
    };
    double x = whole.from;
    double step = whole.to - whole.from;
    while (x < whole.to) {
      const auto [reached, arcs] = longest(x, step, whole.to);
      if (arcs && std::ranges::any_of(
                      *arcs, [](const Curve2& c) { return std::holds_alternative<Arc>(c); })) {
        add((*arcs)[0]);
        add((*arcs)[1]);
      } else {
        add(Segment{point(x), point(reached)});
      }
      step = std::max(reached - x, 4.0 * kEpsilon * whole.to);
      x = reached;
    }
    return made;
  }

  std::pair<double, std::optional<std::array<Curve2, 2>>> longest(double x, double step,
                                                                  double end) const {
    double good = x;
    double bad = std::numeric_limits<double>::infinity();
    std::optional<std::array<Curve2, 2>> best;
    int refinements = 0;
    while (good < end && refinements < 6) {
      double next = best ? (std::isinf(bad) ? x + 2.0 * (good - x) : 0.5 * (good + bad)) : x + step;
      next = std::min(next, end);
      if (auto arcs = fitting({x, next})) {
        good = next;
        best = std::move(arcs);
      } else {
        bad = next;
        step *= 0.5;
        // Shorter than the tolerance, or than parameters can resolve: use the chord.
        if (!best && (short_part(x, next) || x + step <= x)) return {next, std::nullopt};
      }
      if (best && !std::isinf(bad)) ++refinements;
    }
    return {good, best};
  }

  bool short_part(double from, double to) const {
    const double size = length(cut({from, to}));
    return size <= tolerance || size <= 64.0 * kEpsilon * largest(point(from));
  }
};

/// Joints where the spline turns a corner, and both ends.
std::vector<std::size_t> corners(const CubicSpline& spline) {
  const BiarcChain chain{spline, 0.0};
  const std::size_t n = span_count(spline);
  std::vector<std::size_t> found{0};
  for (std::size_t i = 1; i < n; ++i) {
    const double x = static_cast<double>(i);
    if (std::abs(turn(chain.tangent(x, -1.0), chain.tangent(x, 1.0))) > kCorner) found.push_back(i);
  }
  found.push_back(n);
  return found;
}

}  // namespace

std::vector<Curve2> to_arcs(const Curve2& curve, double tolerance) {
  PLANISH_ASSERT(tolerance > 0.0);
  const CubicSpline* spline = std::get_if<CubicSpline>(&curve);
  if (!spline) return {curve};
  std::vector<Curve2> made;
  const std::vector<std::size_t> ends = corners(*spline);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const auto first = spline->poles.begin() + static_cast<std::ptrdiff_t>(3 * ends[k - 1]);
    const auto last = spline->poles.begin() + static_cast<std::ptrdiff_t>(3 * ends[k] + 1);
    const CubicSpline smooth{{first, last}};
    const Curve2 simple = recognized(smooth, tolerance);
    if (!std::holds_alternative<CubicSpline>(simple)) {
      if (length(simple) > 0.0) made.push_back(simple);
      continue;
    }
    const BiarcChain chain{smooth, tolerance};
    const std::vector<Curve2> arcs = chain.along({0.0, static_cast<double>(span_count(smooth))});
    made.insert(made.end(), arcs.begin(), arcs.end());
  }
  if (made.empty()) made.push_back(Segment{start_of(curve), end_of(curve)});
  return made;
}

}  // namespace planish
