#pragma once

#include <planish/geometry/developable.hpp>

#include <rapidcheck.h>

#include <functional>

namespace planish::test {

/// A random number: a million steps are as good as all.
inline double any(double lo, double hi) {
  constexpr int steps = 1'000'000;
  return lo + (hi - lo) * *rc::gen::inRange(0, steps + 1) / steps;
}

/// Derivatives along the parameters, by differences.
struct Tangents {
  Vec3 u, v;
};
inline Tangents tangents(const Developable& surface, const Vec2& uv, double offset) {
  constexpr double h = 1e-5;
  const auto slope = [&](const Vec2& step) -> Vec3 {
    return (point_on(surface, uv + step, offset) - point_on(surface, uv - step, offset)) / (2 * h);
  };
  return {slope({h, 0}), slope({0, h})};
}

inline double simpson(const std::function<double(double)>& f, double a, double b,
                      int halves = 2000) {
  const double h = (b - a) / (2 * halves);
  double sum = f(a) + f(b);
  for (int i = 1; i < 2 * halves; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * f(a + i * h);
  return sum * h / 3;
}

}  // namespace planish::test
