// Whether a path is a line or an arc within a tolerance: candidates by least squares through its
// ends, then the worst distance where it can be: for splines at every extreme of the deviation,
// which are roots of polynomials. Nothing is decided by samples alone.

#include "recognition.hpp"

#include <planish/geometry/fit.hpp>

#include <numbers>

// The line or the circle that a path is, if it is one. Circles are least squares through both ends
// (or through the one end of a closed path), and their sweep follows from half chord and height,
// which is exact however flat the arc. The test is no sample: a spline is compared at its extremes
// along and across the chord, and stays in a ring if the Bernstein coefficients of |B|² do, halved
// where they do not tell; and it may not run back.

namespace planish {
namespace geometry_detail {
namespace {

using std::numbers::pi;

/// Circle through the first station and, by least squares, the others: |d|² = 2 v·d for d from
/// the first station and v from there to the centre.
std::optional<Vec2> center_through_one(const std::vector<Station>& path) {
  const Vec2 a = path.front().point;
  Eigen::Matrix2d m = Eigen::Matrix2d::Zero();
  Vec2 r = Vec2::Zero();
  for (const Station& s : path) {
    const Vec2 d = s.point - a;
    m += 4.0 * s.weight * d * d.transpose();
    r += 2.0 * s.weight * d.squaredNorm() * d;
  }
  // Points of one line determine no circle.
  if (m.determinant() <= kSamePoint * m.trace() * m.trace()) return std::nullopt;
  return Vec2(a + m.inverse() * r);
}

/// The same through both ends: the centre lies at height k over the middle of the chord, where
/// x² + y² − h² = 2 k y for points (x, y) and half the chord h.
std::optional<Vec2> center_through_two(const std::vector<Station>& path) {
  const Vec2 middle = 0.5 * (path.front().point + path.back().point);
  const Vec2 chord = path.back().point - path.front().point;
  const double half = 0.5 * chord.norm();
  const Vec2 normal = perpendicular(chord) / (2.0 * half);
  double above = 0.0;
  double below = 0.0;
  for (const Station& s : path) {
    const Vec2 d = s.point - middle;
    const double y = normal.dot(d);
    above += s.weight * y * (d.squaredNorm() - half * half);
    below += 2.0 * s.weight * y * y;
  }
  if (!(below > 0.0)) return std::nullopt;
  return Vec2(middle + above / below * normal);
}

double total_turn(const std::vector<Station>& path, const Vec2& center) {
  double total = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    total += turn(path[i - 1].point - center, path[i].point - center);
  }
  return total;
}

}  // namespace

double size_of(const std::vector<Station>& path) {
  Box2 box;
  double coordinates = 0.0;
  for (const Station& s : path) {
    box.add(s.point);
    coordinates = std::max(coordinates, largest(s.point));
  }
  // Coordinates far from the origin have rounding errors of their own.
  return std::max(largest(box.size()), kEpsilon / kSamePoint * coordinates);
}

std::optional<Segment> line_along(const std::vector<Station>& path, double tolerance) {
  const Segment line{path.front().point, path.back().point};
  const double size = (line.b - line.a).norm();
  const Vec2 along = size > 0.0 ? Vec2((line.b - line.a) / size) : Vec2(Vec2::UnitX());
  double farthest = 0.0;
  double beyond = 0.0;
  double aside = 0.0;
  for (const Station& s : path) {
    const Vec2 d = s.point - line.a;
    const double x = along.dot(d);
    if (x < farthest - tolerance) return std::nullopt;
    farthest = std::max(farthest, x);
    beyond = std::max({beyond, -x, x - size});
    aside = std::max(aside, std::abs(cross(along, d)));
  }
  // What is beyond an end may be aside too; taking the worst of both is safe.
  if (!(std::hypot(beyond, aside) <= tolerance)) return std::nullopt;
  return line;
}

std::optional<Arc> arc_through(const std::vector<Station>& path) {
  const Vec2 a = path.front().point;
  const Vec2 chord = path.back().point - a;
  const bool closed = largest(chord) <= kSamePoint * size_of(path);
  const std::optional<Vec2> center = closed ? center_through_one(path) : center_through_two(path);
  if (!center || !center->allFinite()) return std::nullopt;
  const double turned = total_turn(path, *center);
  const double sense = turned < 0.0 ? -1.0 : 1.0;
  const Vec2 to_start = a - *center;
  double sweep = 2.0 * pi;
  if (!closed) {
    // From the half chord and the height of the centre above it: exact however flat the arc.
    const Vec2 to_middle = to_start + 0.5 * chord;
    const double height = -cross(chord, to_middle) / chord.norm();
    sweep = 2.0 * std::atan2(0.5 * chord.norm(), sense * height);
  }
  if (std::abs(turned - sense * sweep) > pi) return std::nullopt;  // goes around more than once
  return Arc{*center, to_start.norm(), angle_of(to_start), sense * sweep};
}

std::optional<double> beyond_ends(const std::vector<Station>& path, const Arc& arc,
                                  double tolerance) {
  const double sense = arc.sweep < 0.0 ? -1.0 : 1.0;
  double angle = 0.0;
  double farthest = 0.0;
  double beyond = 0.0;
  Vec2 last = path.front().point - arc.center;
  for (const Station& s : path) {
    const Vec2 d = s.point - arc.center;
    angle += sense * turn(last, d);
    if ((farthest - angle) * arc.radius > tolerance) return std::nullopt;
    farthest = std::max(farthest, angle);
    beyond = std::max({beyond, -angle, angle - std::abs(arc.sweep)});
    last = d;
  }
  return beyond * (arc.radius + tolerance);  // if the path is outside the circle
}

bool follows(const std::vector<Station>& path, const Arc& arc, double tolerance) {
  if (arc.radius <= tolerance) return false;
  const auto beyond = beyond_ends(path, arc, tolerance);
  return beyond && std::ranges::all_of(path, [&](const Station& s) {
           const double aside = (s.point - arc.center).norm() - arc.radius;
           return std::hypot(*beyond, aside) <= tolerance;
         });
}

}  // namespace geometry_detail

namespace {

using namespace geometry_detail;

/// Evenly spaced stations of a span, to fit a circle to and to follow its turning.
constexpr int kStationsPerSpan = 24;

/// Stations at every end, and wherever a span turns back along `chord` or is farthest from it: with
/// these the test for a line is exact.
std::vector<Station> extreme_stations(const CubicSpline& spline) {
  const Vec2 chord = spline.poles.back() - first_pole(spline);
  const Vec2 along = chord.isZero(0.0) ? Vec2(Vec2::UnitX()) : chord.stableNormalized();
  std::vector<Station> path{{spline.poles.front()}};
  for (std::size_t i = 0; i < span_count(spline); ++i) {
    const Bezier b = span(spline, i);
    Bezier turned;
    for (std::size_t k = 0; k < 4; ++k)
      turned[k] = {along.dot(b[k] - b[0]), cross(along, b[k] - b[0])};
    std::vector<double> at = extrema(turned, 0);
    for (const double t : extrema(turned, 1))
      at.push_back(t);
    std::ranges::sort(at);
    for (const double t : at)
      path.push_back({bezier_point(b, t)});
    path.push_back({b[3]});
  }
  return path;
}

/// Where the direction from `center` stops turning: (B − c) × B' = 0, of degree five.
std::vector<double> angular_extrema(const Bezier& b, const Vec2& center) {
  constexpr std::array<double, 4> kCubic{1.0, 3.0, 3.0, 1.0};
  constexpr std::array<double, 3> kQuadratic{1.0, 2.0, 1.0};
  constexpr std::array<double, 6> kQuintic{1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
  std::array<double, 6> c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i + j] += kCubic[i] * kQuadratic[j] / kQuintic[i + j] *
                  cross(b[i] - center, b[j + 1] - b[j]);
    }
  }
  return roots(c);
}

/// Evenly spaced stations, and those where the spline turns back about the centre (if given).
std::vector<Station> even_stations(const CubicSpline& spline, const std::optional<Vec2>& center) {
  std::vector<Station> path{{first_pole(spline), 0.0}};
  for (std::size_t i = 0; i < span_count(spline); ++i) {
    const Bezier b = span(spline, i);
    std::vector<double> at;
    for (int k = 1; k < kStationsPerSpan; ++k)
      at.push_back(k / double{kStationsPerSpan});
    if (center) {
      for (const double t : angular_extrema(b, *center))
        at.push_back(t);
      std::ranges::sort(at);
    }
    for (const double t : at) {
      const Vec2 p = bezier_point(b, t);
      path.push_back({p, (p - path.back().point).norm()});
    }
    path.push_back({b[3], (b[3] - path.back().point).norm()});
  }
  return path;
}

/// Whether |B|² with these coefficients stays in [low, high]: certainly if the coefficients do,
/// certainly not if an end does not; halving decides the rest.
bool within(const std::array<double, 7>& c, double low, double high, int halvings) {
  if (!(c.front() >= low && c.front() <= high && c.back() >= low && c.back() <= high)) return false;
  const auto [least, most] = std::ranges::minmax_element(c);
  if (*least >= low && *most <= high) return true;
  if (halvings == 0) return false;
  const auto [left, right] = split(c, 0.5);
  return within(left, low, high, halvings - 1) && within(right, low, high, halvings - 1);
}

/// Whether no point of the spline is more than `tolerance` off the arc's circle.
bool within_ring(const CubicSpline& spline, const Arc& arc, double tolerance) {
  const double inner = std::max(0.0, arc.radius - tolerance);
  const double outer = arc.radius + tolerance;
  for (std::size_t i = 0; i < span_count(spline); ++i) {
    Bezier b = span(spline, i);
    for (Vec2& pole : b)
      pole -= arc.center;
    constexpr int halvings = 20;  // a millionth of the span
    if (!within(square(b), inner * inner, outer * outer, halvings)) return false;
  }
  return true;
}

}  // namespace

Curve2 recognized(const CubicSpline& spline, double tolerance) {
  if (const auto line = line_along(extreme_stations(spline), tolerance)) return *line;
  const std::vector<Station> path = even_stations(spline, std::nullopt);
  const std::optional<Arc> arc = arc_through(path);
  // A path that may pass through the centre has no direction of turning.
  if (!arc || arc->radius <= tolerance || !within_ring(spline, *arc, tolerance)) return spline;
  const auto beyond = beyond_ends(even_stations(spline, arc->center), *arc, tolerance);
  if (!beyond || *beyond > tolerance) return spline;
  // What is beyond an end may be aside too; taking the worst of both is safe.
  const double aside = std::sqrt(tolerance * tolerance - *beyond * *beyond);
  if (*beyond > 0.0 && !within_ring(spline, *arc, aside)) return spline;
  return *arc;
}

}  // namespace planish
