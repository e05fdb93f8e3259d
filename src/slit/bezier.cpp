#include <planish/base/assert.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/slit/bezier.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Bézier curves of any degree: points by de Casteljau, stable for every degree, lengths by
// Gauss–Legendre on halved intervals. The tightest bend is looked for among samples, 64 for each
// degree, and refined by golden section between neighbours; a nearest point among samples, then by
// Newton, as the best sample is near enough to it.

namespace planish {
namespace {

constexpr int kSamplesPerDegree = 64;

int sample_count(const BezierCurve& curve) {
  return kSamplesPerDegree * std::max<int>(1, static_cast<int>(curve.poles.size()) - 1);
}

/// Gauss–Legendre on five points.
double gauss_length(const BezierCurve& curve, double from, double to) {
  constexpr std::array<double, 5> kNodes{-0.9061798459386640, -0.5384693101056831, 0.0,
                                         0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 5> kWeights{0.2369268850561891, 0.4786286704993665,
                                           0.5688888888888889, 0.4786286704993665,
                                           0.2369268850561891};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i)
    sum += kWeights[i] * bezier_at(curve, middle + half * kNodes[i]).first.norm();
  return half * sum;
}

double adaptive_length(const BezierCurve& curve, double from, double to, double whole,
                       double tolerance, int depth) {
  const double middle = 0.5 * (from + to);
  const double left = gauss_length(curve, from, middle), right = gauss_length(curve, middle, to);
  if (depth == 0 || std::abs(left + right - whole) <= tolerance) return left + right;
  return adaptive_length(curve, from, middle, left, tolerance, depth - 1) +
         adaptive_length(curve, middle, to, right, tolerance, depth - 1);
}

double radius_at(const BezierCurve& curve, double t) {
  const BezierPoint p = bezier_at(curve, t);
  const double speed = p.first.norm();
  const double turn = std::abs(cross(p.first, p.second));
  if (turn > 0.0) return speed * speed * speed / turn;
  return speed > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

/// Golden section between two parameters around a sampled minimum.
TightestBend refined(const BezierCurve& curve, double low, double high) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSteps = 60;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = radius_at(curve, a), at_b = radius_at(curve, b);
  for (int i = 0; i < kSteps; ++i) {
    if (at_a <= at_b) {
      high = b, b = a, at_b = at_a;
      a = high - kGolden * (high - low), at_a = radius_at(curve, a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + kGolden * (high - low), at_b = radius_at(curve, b);
    }
  }
  return at_a <= at_b ? TightestBend{at_a, a} : TightestBend{at_b, b};
}

}  // namespace

bool is_regular(const BezierCurve& curve) {
  return !curve.poles.empty() && std::ranges::all_of(curve.poles, [](const Vec2& pole) {
    return (pole.array().abs() <= kFarthest).all();
  });
}

BezierPoint bezier_at(const BezierCurve& curve, double t) {
  PLANISH_ASSERT(!curve.poles.empty());
  std::vector<Vec2> level = curve.poles;
  const double degree = static_cast<double>(level.size()) - 1.0;
  BezierPoint result;
  for (std::size_t count = level.size(); count > 1; --count) {
    if (count == 3)
      result.second = degree * (degree - 1.0) * (level[2] - 2.0 * level[1] + level[0]);
    if (count == 2) result.first = degree * (level[1] - level[0]);
    for (std::size_t i = 0; i + 1 < count; ++i)
      level[i] += t * (level[i + 1] - level[i]);
  }
  result.point = level[0];
  return result;
}

double length(const BezierCurve& curve) {
  PLANISH_ASSERT(is_regular(curve));
  double polygon = 0.0;
  for (std::size_t i = 0; i + 1 < curve.poles.size(); ++i)
    polygon += (curve.poles[i + 1] - curve.poles[i]).norm();
  constexpr int kPieces = 4, kDepth = 24;
  constexpr double kAllowed = 1e-13;  // of the control polygon, in each piece
  double sum = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double from = static_cast<double>(i) / kPieces, to = static_cast<double>(i + 1) / kPieces;
    sum += adaptive_length(curve, from, to, gauss_length(curve, from, to), kAllowed * polygon,
                           kDepth);
  }
  return sum;
}

std::vector<Vec2> points_at_lengths(const BezierCurve& curve, const std::vector<double>& lengths) {
  PLANISH_ASSERT(is_regular(curve));
  const int count = sample_count(curve);
  std::vector<double> until{0.0};
  for (int i = 0; i < count; ++i)
    until.push_back(until.back() + gauss_length(curve, static_cast<double>(i) / count,
                                                static_cast<double>(i + 1) / count));
  std::vector<Vec2> points;
  for (const double length : lengths) {
    const auto after = std::upper_bound(until.begin() + 1, until.end() - 1, length);
    const double from = *(after - 1),
                 share = *after > from ? (length - from) / (*after - from) : 0.0;
    const double t = (static_cast<double>(after - until.begin()) - 1.0 + share) / count;
    points.push_back(bezier_at(curve, std::clamp(t, 0.0, 1.0)).point);
  }
  return points;
}

TightestBend tightest_bend(const BezierCurve& curve, double from, double to) {
  PLANISH_ASSERT(is_regular(curve));
  const int count = sample_count(curve);
  const auto at = [&](int i) { return from + (to - from) * i / count; };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= count; ++i)
    if (const double radius = radius_at(curve, at(i)); radius < least) least = radius, best = i;
  if (!(least < std::numeric_limits<double>::infinity())) return {least, from};
  const TightestBend between = refined(curve, at(std::max(0, best - 1)),
                                       at(std::min(count, best + 1)));
  return between.radius < least ? between : TightestBend{least, at(best)};
}

BezierSearch::BezierSearch(BezierCurve curve) : curve_(std::move(curve)) {
  PLANISH_ASSERT(is_regular(curve_));
  const int count = sample_count(curve_);
  for (int i = 0; i <= count; ++i)
    samples_.push_back(bezier_at(curve_, static_cast<double>(i) / count).point);
}

BezierSearch::Foot BezierSearch::nearest(const Vec2& p) const {
  const auto closer = [&](const Vec2& a, const Vec2& b) {
    return (a - p).squaredNorm() < (b - p).squaredNorm();
  };
  const auto best = std::ranges::min_element(samples_, closer) - samples_.begin();
  const double step = 1.0 / (static_cast<double>(samples_.size()) - 1.0);
  const double low = std::max(0.0, (static_cast<double>(best) - 1.0) * step),
               high = std::min(1.0, (static_cast<double>(best) + 1.0) * step);
  double t = static_cast<double>(best) * step;
  constexpr int kIterations = 20;
  BezierPoint c = bezier_at(curve_, t);
  double slope = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    slope = c.first.squaredNorm() - (p - c.point).dot(c.second);
    const double next = slope > 0.0 ? std::clamp(t + (p - c.point).dot(c.first) / slope, low, high)
                                    : t;
    const double moved = std::abs(next - t);
    t = next;
    c = bezier_at(curve_, t);
    if (moved <= 4.0 * std::numeric_limits<double>::epsilon()) break;
  }
  Foot foot{t, c.point, Eigen::Matrix2d::Zero()};
  slope = c.first.squaredNorm() - (p - c.point).dot(c.second);
  if (t > 0.0 && t < 1.0 && slope > 0.0) foot.derivative = c.first * c.first.transpose() / slope;
  return foot;
}

}  // namespace planish
