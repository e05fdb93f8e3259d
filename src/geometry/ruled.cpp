// General developables by knots along two borders (math.md#general-developable): between knots
// Hermite cubics for the points and rulings. The development integrates along the directrix, each
// ruling keeping its angle; its inverse looks for the ruling through a point by Newton in a
// bracket, on the sheet's side of the edge of regression.

#include "ruled.hpp"

#include "planar.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

// Ruled surfaces and their isometry to the plane (math.md#general-developable). A tangent plane
// turns about its ruling only, so plane and surface have the same rates: angle, then directrix are
// integrated as Chebyshev series on spans, halved until the last terms vanish. Both inverses look
// for the ruling through a point: it is a rising root of a function of u; it falls beyond the edge
// of regression, which tells apart two roots of one interval. Newton is kept in a bracket.

namespace planish::geometry_detail {
namespace {

/// How far beyond its first and last ruling the surface is searched, in lengths of the end
/// intervals: points of a border must be found even if rounding puts them outside.
constexpr double kMargin = 0.1;

struct HermiteValue {
  Vec3 value, first, second;
};

/// Cubic with values p0, p1 and derivatives m0, m1 at s = 0 and s = 1; derivatives are with respect
/// to u = length · s.
HermiteValue hermite(const Vec3& p0, const Vec3& m0, const Vec3& p1, const Vec3& m1, double length,
                     double s) {
  const Vec3 chord = p1 - p0;
  const Vec3 c1 = length * m0;
  const Vec3 c2 = 3.0 * chord - length * (2.0 * m0 + m1);
  const Vec3 c3 = length * (m0 + m1) - 2.0 * chord;
  return {p0 + s * (c1 + s * (c2 + s * c3)), (c1 + s * (2.0 * c2 + 3.0 * s * c3)) / length,
          (2.0 * c2 + 6.0 * s * c3) / (length * length)};
}

/// Derivative of x/|x| when x has the derivative x_prime.
Vec3 derivative_of_unit(const Vec3& x, const Vec3& x_prime) {
  const Vec3 unit = x.normalized();
  return (x_prime - unit * unit.dot(x_prime)) / x.norm();
}

double first_u(const Ruled& ruled) {
  const auto& k = ruled.knots;
  return k[0].u - kMargin * (k[1].u - k[0].u);
}

double last_u(const Ruled& ruled) {
  const auto& k = ruled.knots;
  return k.back().u + kMargin * (k.back().u - k[k.size() - 2].u);
}

/// A function of u that is zero where the ruling through u passes a given point, negative where the
/// point lies ahead and positive where it lies behind.
struct Passing {
  double u;
  double value, slope;
};

/// Root in a bracket with a.value <= 0 <= b.value: Newton, halving the bracket if a step would
/// leave it or is longer than half the previous step.
template <class Function>
double root_between(const Function& passing, Passing a, Passing b) {
  const double finest = 4.0 * kEpsilon * std::max({std::abs(a.u), std::abs(b.u), b.u - a.u});
  Passing x = std::abs(a.value) < std::abs(b.value) ? a : b;
  double step = b.u - a.u;
  while (x.value != 0.0 && std::abs(step) > finest) {
    const double newton = -x.value / x.slope;
    const double target = x.u + newton;
    const bool use = target >= a.u && target <= b.u && std::abs(newton) < 0.5 * std::abs(step);
    step = use ? newton : 0.5 * (b.u - a.u);
    x = passing(use ? target : std::midpoint(a.u, b.u));
    (x.value < 0.0 ? a : b) = x;
  }
  return x.u;
}

/// Where the slope changes sign between a and b.
template <class Function>
Passing turning_point(const Function& passing, Passing a, Passing b) {
  const bool rises_first = a.slope > 0.0;
  const double finest = std::sqrt(kEpsilon) * (b.u - a.u);
  while (b.u - a.u > finest) {
    const Passing middle = passing(std::midpoint(a.u, b.u));
    ((middle.slope > 0.0) == rises_first ? a : b) = middle;
  }
  return a;
}

/// The roots at which the function rises; it falls at roots beyond the edge of regression. The
/// slopes distinguish two roots between neighbouring nodes, one on either side of that edge.
template <class Function>
std::vector<double> rising_roots(const Function& passing, const std::vector<Passing>& nodes) {
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Passing& a = nodes[i];
    const Passing& b = nodes[i + 1];
    if (a.value <= 0.0 && b.value > 0.0) {
      roots.push_back(root_between(passing, a, b));
    } else if (a.value * b.value > 0.0 && a.slope * b.slope < 0.0 && a.slope * a.value < 0.0) {
      const Passing turn = turning_point(passing, a, b);
      if (turn.value * a.value <= 0.0)
        roots.push_back(a.slope > 0.0 ? root_between(passing, a, turn)
                                      : root_between(passing, turn, b));
    }
  }
  return roots;
}

/// Knots, and points between them if knots are few, from slightly before the first to slightly
/// beyond the last.
std::vector<double> scan_positions(const Ruled& ruled) {
  constexpr std::size_t kEnough = 64;
  const auto& k = ruled.knots;
  const std::size_t parts = 1 + kEnough / k.size();
  std::vector<double> us{first_u(ruled)};
  for (std::size_t i = 0; i + 1 < k.size(); ++i)
    for (std::size_t j = 0; j < parts; ++j)
      us.push_back(
          std::lerp(k[i].u, k[i + 1].u, static_cast<double>(j) / static_cast<double>(parts)));
  us.push_back(k.back().u);
  us.push_back(last_u(ruled));
  return us;
}

/// Distance from p to the ruling through u, as a line.
double distance_to_ruling(const Ruled& ruled, const Vec3& p, double u) {
  const RulingFrame f = frame_at(ruled, u);
  return (p - f.b).cross(f.g).norm();
}

/// The ruling in `us` nearest to p; of equally near ones (relative to the distance of p from the
/// directrix), the one nearest to u_near.
double nearest_ruling(const Ruled& ruled, const Vec3& p, double u_near,
                      const std::vector<double>& us) {
  const double scale = (p - frame_at(ruled, us.front()).b).norm();
  double best = us.front();
  double best_distance = std::numeric_limits<double>::infinity();
  for (const double u : us) {
    const double distance = distance_to_ruling(ruled, p, u);
    const bool equal = std::abs(distance - best_distance) <= tolerance::kComputed * scale;
    if (equal ? std::abs(u - u_near) < std::abs(best - u_near) : distance < best_distance) {
      best = u;
      best_distance = distance;
    }
  }
  return best;
}

template <std::size_t n>
Vec3 series_at(const std::array<Vec3, n>& coefficients, double x) {
  Vec3 next = Vec3::Zero();
  Vec3 after = Vec3::Zero();
  for (std::size_t i = n - 1; i > 0; --i) {
    const Vec3 sum = coefficients[i] + 2.0 * x * next - after;
    after = next;
    next = sum;
  }
  return coefficients[0] + x * next - after;
}

/// cosines[j][i] = T_j at the i-th of n Chebyshev nodes; row 1 holds the nodes themselves.
template <std::size_t n>
const std::array<std::array<double, n>, n>& chebyshev_cosines() {
  static const auto cosines = [] {
    std::array<std::array<double, n>, n> table;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        table[j][i] = std::cos(std::numbers::pi * static_cast<double>(j * (2 * i + 1)) /
                               static_cast<double>(2 * n));
    return table;
  }();
  return cosines;
}

/// Chebyshev coefficients of the polynomial through the values at the Chebyshev nodes.
template <std::size_t n>
std::array<Vec3, n> series_through(const std::array<Vec3, n>& values) {
  const auto& cosines = chebyshev_cosines<n>();
  std::array<Vec3, n> coefficients;
  for (std::size_t j = 0; j < n; ++j) {
    coefficients[j] = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i)
      coefficients[j] += cosines[j][i] * values[i];
    coefficients[j] *= (j == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  return coefficients;
}

/// Antiderivative of the series, times `scale`, with the given value at x = −1.
template <std::size_t n>
std::array<Vec3, n + 1> antiderivative(const std::array<Vec3, n>& series, double scale,
                                       const Vec3& value_at_begin) {
  std::array<Vec3, n + 1> result;
  result[0] = value_at_begin;
  for (std::size_t j = 1; j <= n; ++j) {
    const Vec3 before = (j == 1 ? 2.0 : 1.0) * series[j - 1];
    const Vec3 after = j + 1 < n ? series[j + 1] : Vec3::Zero();
    result[j] = scale * (before - after) / (2.0 * static_cast<double>(j));
    result[0] -= (j % 2 == 0 ? 1.0 : -1.0) * result[j];
  }
  return result;
}

/// Perpendicular to the ruling at that angle, towards growing u.
Vec2 across(double angle) { return {std::sin(angle), -std::cos(angle)}; }

}  // namespace

RulingFrame frame_at(const Ruled& ruled, double u) {
  const auto& k = ruled.knots;
  PLANISH_ASSERT(k.size() >= 2);
  const auto past = std::upper_bound(k.begin() + 1, k.end() - 1, u,
                                     [](double x, const Ruled::Knot& knot) { return x < knot.u; });
  const Ruled::Knot& k0 = *(past - 1);
  const Ruled::Knot& k1 = *past;
  const double length = k1.u - k0.u;
  const double s = (u - k0.u) / length;
  const HermiteValue b = hermite(k0.b, k0.b_prime, k1.b, k1.b_prime, length, s);
  const HermiteValue h = hermite(k0.g, k0.g_prime, k1.g, k1.g_prime, length, s);

  RulingFrame f;
  f.b = b.value;
  f.b_prime = b.first;
  f.g = h.value.normalized();
  f.g_prime = derivative_of_unit(h.value, h.first);
  const Vec3 normal = f.b_prime.cross(f.g);
  f.n = normal.normalized();
  f.n_prime = derivative_of_unit(normal, b.second.cross(f.g) + f.b_prime.cross(f.g_prime));
  f.across = f.g.cross(f.n);
  return f;
}

Vec2 nearest_on(const Ruled& ruled, const Vec3& p, double u_near) {
  const auto passing = [&](double u) -> Passing {
    const RulingFrame f = frame_at(ruled, u);
    const Vec3 w = p - f.b;
    const Vec3 velocity = f.b_prime + w.dot(f.g) * f.g_prime + w.dot(f.n) * f.n_prime;
    return {u, -w.dot(f.across), velocity.dot(f.across)};
  };
  const std::vector<double> us = scan_positions(ruled);
  const auto nodes = mapped(us, [&](double u) { return passing(u); });

  std::vector<double> feet = rising_roots(passing, nodes);
  const auto regular = [](const Passing& node) { return node.slope > 0.0; };
  if (regular(nodes.front()) && nodes.front().value > 0.0) feet.push_back(us.front());
  if (regular(nodes.back()) && nodes.back().value < 0.0) feet.push_back(us.back());
  const double u = nearest_ruling(ruled, p, u_near, feet.empty() ? us : feet);
  const RulingFrame f = frame_at(ruled, u);
  return {u, (p - f.b).dot(f.g)};
}

RuledImage::RuledImage(const Ruled& ruled, double offset) {
  const auto& k = ruled.knots;
  PLANISH_ASSERT(k.size() >= 2);
  double extent = 0.0;
  for (std::size_t i = 0; i + 1 < k.size(); ++i) {
    PLANISH_ASSERT(k[i].u < k[i + 1].u);
    extent += (k[i + 1].b - k[i].b).norm();
  }
  constexpr int kHalvings = 12;
  for (std::size_t i = 0; i + 1 < k.size(); ++i)
    append(ruled, offset, i == 0 ? first_u(ruled) : k[i].u,
           i + 2 == k.size() ? last_u(ruled) : k[i + 1].u, extent, kHalvings);
  move_start_to_origin(k.front().u);

  lines_.reserve(spans_.size() + 1);
  for (const Span& span : spans_)
    lines_.push_back(line_at(span.begin));
  lines_.push_back(line_at(spans_.back().end));
}

RuledImage::Span RuledImage::integrated(const Ruled& ruled, double offset, double begin, double end,
                                        const Vec3& state_at_begin) {
  const double half = 0.5 * (end - begin);
  const std::array<double, kTerms>& nodes = chebyshev_cosines<kTerms>()[1];
  std::array<RulingFrame, kTerms> frames;
  std::array<Vec3, kTerms> rates;
  for (std::size_t i = 0; i < kTerms; ++i) {
    frames[i] = frame_at(ruled, std::midpoint(begin, end) + half * nodes[i]);
    rates[i] = {0.0, 0.0, -frames[i].g_prime.dot(frames[i].across)};
  }
  // The angle first: the directrix needs it.
  const auto angle = antiderivative(series_through(rates), half, state_at_begin);
  for (std::size_t i = 0; i < kTerms; ++i) {
    const double psi = series_at(angle, nodes[i]).z();
    const Vec3 velocity = frames[i].b_prime + offset * frames[i].n_prime;
    rates[i].head<2>() = velocity.dot(frames[i].g) * direction_of(psi) +
                         velocity.dot(frames[i].across) * across(psi);
  }
  const std::array<Vec3, kTerms> rate = series_through(rates);
  return {begin, end, rate, antiderivative(rate, half, state_at_begin)};
}

void RuledImage::append(const Ruled& ruled, double offset, double begin, double end, double extent,
                        int halvings) {
  constexpr double kTail = 1e-13;        // of the extent, and radians
  constexpr double kLargestTurn = 0.25;  // radians; `fold` looks for rulings at the ends of spans
  const Vec3 start = spans_.empty() ? Vec3(0.0, 0.0, 0.5 * std::numbers::pi)
                                    : series_at(spans_.back().state, 1.0);
  const Span span = integrated(ruled, offset, begin, end, start);
  // Two terms, because every other term of an even or odd function is zero.
  const Vec3 tail = span.state[kTerms].cwiseAbs().cwiseMax(span.state[kTerms - 1].cwiseAbs());
  const bool fine = tail.head<2>().maxCoeff() <= kTail * extent && tail.z() <= kTail &&
                    std::abs(series_at(span.state, 1.0).z() - start.z()) <= kLargestTurn;
  if (fine || halvings == 0) {
    spans_.push_back(span);
    return;
  }
  const double middle = std::midpoint(begin, end);
  append(ruled, offset, begin, middle, extent, halvings - 1);
  append(ruled, offset, middle, end, extent, halvings - 1);
}

void RuledImage::move_start_to_origin(double u) {
  const Vec3 start = line_at(u).state;
  const double turn = 0.5 * std::numbers::pi - start.z();
  const Eigen::AngleAxisd rotation(turn, Vec3::UnitZ());
  for (Span& span : spans_) {
    span.state[0] -= Vec3(start.x(), start.y(), 0.0);
    for (Vec3& c : span.state)
      c = rotation * c;
    for (Vec3& c : span.rate)
      c = rotation * c;
    span.state[0].z() += turn;
  }
}

RuledImage::Line RuledImage::line_at(double u) const {
  const auto past = std::upper_bound(spans_.begin() + 1, spans_.end(), u,
                                     [](double x, const Span& span) { return x < span.begin; });
  const Span& span = *(past - 1);
  const double x = ((u - span.begin) - (span.end - u)) / (span.end - span.begin);
  return {u, series_at(span.state, x), series_at(span.rate, x)};
}

Vec2 RuledImage::develop(const Vec2& uv) const {
  const Line line = line_at(uv.x());
  return line.state.head<2>() + uv.y() * direction_of(line.state.z());
}

Eigen::Matrix2d RuledImage::jacobian(const Vec2& uv) const {
  const Line line = line_at(uv.x());
  const double psi = line.state.z();
  Eigen::Matrix2d result;
  result.col(0) = line.rate.head<2>() - uv.y() * line.rate.z() * across(psi);
  result.col(1) = direction_of(psi);
  return result;
}

Vec2 RuledImage::fold(const Vec2& p) const {
  const auto passing_of = [&](const Line& line) -> Passing {
    const double psi = line.state.z();
    const Vec2 w = p - line.state.head<2>();
    const double speed = line.rate.head<2>().dot(across(psi)) -
                         w.dot(direction_of(psi)) * line.rate.z();
    return {line.u, -w.dot(across(psi)), speed};
  };
  const auto v_at = [&](double u) {
    const Line line = line_at(u);
    return (p - line.state.head<2>()).dot(direction_of(line.state.z()));
  };
  const auto nodes = mapped(lines_, [&](const Line& line) { return passing_of(line); });

  std::vector<double> us = rising_roots([&](double u) { return passing_of(line_at(u)); }, nodes);
  if (us.empty()) {
    const auto nearest = std::ranges::min_element(
        nodes, {}, [](const auto& node) { return std::abs(node.value); });
    us.push_back(nearest->u);
  }
  const double u = std::ranges::min(us, {}, [&](double at) { return std::abs(v_at(at)); });
  return {u, v_at(u)};
}

}  // namespace planish::geometry_detail
