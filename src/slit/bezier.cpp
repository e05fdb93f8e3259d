#include <planish/base/assert.hpp>
#include <planish/geometry/minimum.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/quadrature.hpp>
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

auto speed_of(const BezierCurve& curve) {
  return [&](double t) { return bezier_at(curve, t).first.norm(); };
}

double radius_at(const BezierCurve& curve, double t) {
  const BezierPoint p = bezier_at(curve, t);
  const double speed = p.first.norm();
  const double turn = std::abs(cross(p.first, p.second));
  if (turn > 0.0) return speed * speed * speed / turn;
  return speed > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
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
  constexpr int kPieces = 4, kHalvings = 24;
  constexpr double kAllowed = 1e-13;  // of the control polygon, in each piece
  const auto speed = speed_of(curve);
  double sum = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double from = static_cast<double>(i) / kPieces, to = static_cast<double>(i + 1) / kPieces;
    sum += adaptive_gauss(speed, from, to, gauss(speed, from, to), kAllowed * polygon, kHalvings);
  }
  return sum;
}

std::vector<Vec2> points_at_lengths(const BezierCurve& curve, const std::vector<double>& lengths) {
  PLANISH_ASSERT(is_regular(curve));
  const int count = sample_count(curve);
  std::vector<double> until{0.0};
  for (int i = 0; i < count; ++i)
    until.push_back(until.back() + gauss(speed_of(curve), static_cast<double>(i) / count,
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
  constexpr int kSteps = 60;
  const auto radius = [&](double t) { return radius_at(curve, t); };
  const double t = least_at(radius, from, to, sample_count(curve), kSteps);
  return {radius(t), t};
}

BezierSearch::BezierSearch(BezierCurve curve) : curve_(std::move(curve)) {
  PLANISH_ASSERT(is_regular(curve_));
  const int count = sample_count(curve_);
  for (int i = 0; i <= count; ++i)
    samples_.push_back(bezier_at(curve_, static_cast<double>(i) / count).point);
}

BezierSearch::Foot BezierSearch::nearest(const Vec2& p) const {
  const auto away = [&](const Vec2& sample) { return (sample - p).squaredNorm(); };
  const auto best = std::ranges::min_element(samples_, {}, away) - samples_.begin();
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
