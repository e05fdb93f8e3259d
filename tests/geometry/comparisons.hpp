#pragma once

#include <planish/geometry/fit.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace planish::test {

using std::numbers::pi;

inline CurveFunction ellipse(double a, double b) {
  return [a, b](double t) {
    return CurveSample{{a * std::cos(t), b * std::sin(t)}, {-a * std::sin(t), b * std::cos(t)}};
  };
}

/// A circle of radius r run through with the angle φ(t).
inline CurveFunction on_circle(double r, std::function<double(double)> angle,
                               std::function<double(double)> speed) {
  return [=](double t) {
    const Vec2 u(std::cos(angle(t)), std::sin(angle(t)));
    return CurveSample{r * u, r * speed(t) * Vec2(-u.y(), u.x())};
  };
}

/// Farthest that points along `from` are off the nearest of `curves`.
inline double farthest(const std::vector<Curve2>& from, const std::vector<Curve2>& curves,
                       int samples) {
  double worst = 0.0;
  for (const Curve2& c : from) {
    for (int i = 0; i <= samples; ++i) {
      const Vec2 p = point_at(c, i / static_cast<double>(samples));
      double least = (start_of(curves.front()) - p).norm();
      for (const Curve2& other : curves)
        least = std::min(least, nearest(other, p).distance);
      worst = std::max(worst, least);
    }
  }
  return worst;
}

inline double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

}  // namespace planish::test
