#pragma once

// Vectors, Bézier spans and Bernstein polynomials for the sources of geometry.

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace planish::geometry_detail {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

inline Vec2 direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// Angle from a to b in (−π, π].
inline double turn(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }
inline double largest(const Vec2& v) { return v.cwiseAbs().maxCoeff(); }

/// Helper for std::visit.
template <typename... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <typename... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

using Bezier = std::array<Vec2, 4>;

inline std::size_t span_count(const CubicSpline& s) {
  PLANISH_ASSERT(s.poles.size() >= 4 && s.poles.size() % 3 == 1);
  return (s.poles.size() - 1) / 3;
}
/// Whether start and sweep are angles: not beyond a full turn, and not where doubles are coarse.
inline bool is_turn(const Arc& arc) {
  constexpr double kMostTurn = 2.0 * std::numbers::pi * (1.0 + tolerance::kComputed);
  constexpr double kFarthestStart = 1e6;  // radians
  return std::abs(arc.start) <= kFarthestStart && std::abs(arc.sweep) <= kMostTurn;
}

/// The first pole; a spline without poles stops at an assertion.
inline const Vec2& first_pole(const CubicSpline& s) {
  PLANISH_ASSERT(span_count(s) > 0);
  return s.poles.front();
}
inline Bezier span(const CubicSpline& s, std::size_t i) {
  return {s.poles[3 * i], s.poles[3 * i + 1], s.poles[3 * i + 2], s.poles[3 * i + 3]};
}
/// The span, and the parameter in it, at the global parameter t in [0, 1].
inline std::pair<std::size_t, double> locate(const CubicSpline& s, double t) {
  const std::size_t n = span_count(s);
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(n);
  const std::size_t i = std::min(static_cast<std::size_t>(x), n - 1);
  return {i, x - static_cast<double>(i)};
}

inline Vec2 bezier_point(const Bezier& b, double t) {
  const double s = 1.0 - t;
  return s * s * s * b[0] + 3.0 * s * s * t * b[1] + 3.0 * s * t * t * b[2] + t * t * t * b[3];
}
inline Vec2 bezier_derivative(const Bezier& b, double t) {
  const double s = 1.0 - t;
  return 3.0 * (s * s * (b[1] - b[0]) + 2.0 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]));
}
inline Vec2 bezier_second(const Bezier& b, double t) {
  return 6.0 * ((1.0 - t) * (b[2] - 2.0 * b[1] + b[0]) + t * (b[3] - 2.0 * b[2] + b[1]));
}

/// Bernstein coefficients (numbers or points) of both parts of a polynomial cut at t.
template <typename T, std::size_t M>
std::pair<std::array<T, M>, std::array<T, M>> split(std::array<T, M> c, double t) {
  std::array<T, M> left = c;
  for (std::size_t level = 1; level < M; ++level) {
    for (std::size_t i = 0; i + level < M; ++i)
      c[i] = (1.0 - t) * c[i] + t * c[i + 1];
    left[level] = c[0];
  }
  return {left, c};
}
/// The part of a span between t0 < t1; ends at 0 and 1 are kept to the bit.
inline Bezier bezier_part(const Bezier& b, double t0, double t1) {
  Bezier part = b;
  if (t1 < 1.0) part = split(part, t1).first;
  if (t0 > 0.0) part = split(part, t0 / t1).second;
  return part;
}

template <std::size_t M>
int sign_changes(const std::array<double, M>& c) {
  int changes = 0;
  double last = 0.0;
  for (const double x : c) {
    if (x == 0.0) continue;
    if (last != 0.0 && (x > 0.0) != (last > 0.0)) ++changes;
    last = x;
  }
  return changes;
}

/// The root in (0, 1) of Bernstein coefficients with exactly one change of sign: Newton, held
/// inside a shrinking bracket.
template <std::size_t M>
double single_root(const std::array<double, M>& c) {
  double left = 0.0;
  for (const double x : c) {
    if (left == 0.0) left = x;
  }
  double a = 0.0;
  double b = 1.0;
  double t = 0.5;
  for (int step = 0; step < 200; ++step) {
    std::array<double, M> work = c;
    double slope = 0.0;
    for (std::size_t level = 1; level < M; ++level) {
      if (level == M - 1) slope = static_cast<double>(M - 1) * (work[1] - work[0]);
      for (std::size_t i = 0; i + level < M; ++i)
        work[i] = (1.0 - t) * work[i] + t * work[i + 1];
    }
    const double value = work[0];
    if (value == 0.0) return t;
    ((value > 0.0) == (left > 0.0) ? a : b) = t;
    double next = t - value / slope;
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    if (std::abs(next - t) <= kEpsilon * t) return next;
    t = next;
  }
  return t;
}

template <std::size_t M>
void add_inner_roots(const std::array<double, M>& c, double lo, double hi,
                     std::vector<double>& out) {
  const int changes = sign_changes(c);
  if (changes == 0) return;
  if (changes == 1) {
    out.push_back(lo + (hi - lo) * single_root(c));
    return;
  }
  const double mid = 0.5 * (lo + hi);
  if (hi - lo <= 2.0 * kEpsilon) {  // a multiple root, or two that doubles cannot separate
    out.push_back(mid);
    return;
  }
  const auto [left, right] = split(c, 0.5);
  add_inner_roots(left, lo, mid, out);
  if (right[0] == 0.0) out.push_back(mid);
  add_inner_roots(right, mid, hi, out);
}

/// Roots in [0, 1], ascending, of a polynomial in Bernstein form; none for the zero polynomial.
/// Coefficients without a change of sign have no root, those with one change exactly one
/// (Descartes), so halving isolates all roots.
template <std::size_t M>
std::vector<double> roots(const std::array<double, M>& c) {
  std::vector<double> found;
  if (std::ranges::all_of(c, [](double x) { return x == 0.0; })) return found;
  if (c.front() == 0.0) found.push_back(0.0);
  add_inner_roots(c, 0.0, 1.0, found);
  if (c.back() == 0.0) found.push_back(1.0);
  return found;
}

/// |B|² in Bernstein form, of degree six. Its coefficients enclose its values.
inline std::array<double, 7> square(const Bezier& b) {
  constexpr std::array<double, 4> kCubic{1.0, 3.0, 3.0, 1.0};
  constexpr std::array<double, 7> kSextic{1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0};
  std::array<double, 7> c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      c[i + j] += kCubic[i] * kCubic[j] / kSextic[i + j] * b[i].dot(b[j]);
    }
  }
  return c;
}

/// Parameters inside (0, 1) where coordinate `axis` of a span is extremal.
inline std::vector<double> extrema(const Bezier& b, int axis) {
  return roots(std::array<double, 3>{b[1][axis] - b[0][axis], b[2][axis] - b[1][axis],
                                     b[3][axis] - b[2][axis]});
}

/// The arc from a to b that turns by `sweep` (|sweep| < 2π). Its ends miss a and b by at most a few
/// ε·radius: a centre that far away permits no better.
inline Arc arc_between(const Vec2& a, const Vec2& b, double sweep) {
  const Vec2 chord = b - a;
  const Vec2 to_center = chord / 2.0 + perpendicular(chord) / (2.0 * std::tan(sweep / 2.0));
  return {a + to_center, to_center.norm(), angle_of(-to_center), sweep};
}

}  // namespace planish::geometry_detail
