#pragma once

// Random curves, loops and motions of ordinary size (a few mm to some tens) for properties.

#include <planish/geometry/curve.hpp>

#include <rapidcheck.h>

#include <cmath>
#include <numbers>

namespace planish::test {

inline rc::Gen<double> number_in(double lo, double hi) {
  // rapidcheck shrinks whole numbers; a million steps are as good as all.
  return rc::gen::map(rc::gen::inRange(0, 1000001),
                      [lo, hi](int i) { return lo + (hi - lo) * i / 1e6; });
}

inline rc::Gen<Vec2> point_in(double lo, double hi) {
  return rc::gen::map(rc::gen::pair(number_in(lo, hi), number_in(lo, hi)),
                      [](const std::pair<double, double>& p) { return Vec2(p.first, p.second); });
}

inline rc::Gen<Curve2> any_curve() {
  return rc::gen::exec([]() -> Curve2 {
    switch (*rc::gen::inRange(0, 3)) {
      case 0: {
        const Vec2 a = *point_in(-10, 10);
        const double angle = *number_in(0, 6.3);
        return Segment{a, a + *number_in(0.01, 10) * Vec2(std::cos(angle), std::sin(angle))};
      }
      case 1: {
        const double sweep = *number_in(0.01, 2 * std::numbers::pi);
        const double sense = *rc::gen::element(-1.0, 1.0);
        return Arc{*point_in(-10, 10), *number_in(0.1, 10), *number_in(-10, 10), sense * sweep};
      }
      default: {
        CubicSpline s;
        s.poles.push_back(*point_in(-10, 10));
        const int spans = *rc::gen::inRange(1, 4);
        for (int i = 0; i < 3 * spans; ++i)
          s.poles.push_back(*point_in(-10, 10));
        return s;
      }
    }
  });
}

/// Curves of all kinds one after another, closed by a segment; it may cross itself.
inline rc::Gen<Loop> any_loop() {
  return rc::gen::exec([]() -> Loop {
    Loop loop{*any_curve()};
    const int n = *rc::gen::inRange(1, 6);
    for (int i = 0; i < n; ++i) {
      const Curve2 next = *any_curve();
      Isometry2 shift = Isometry2::Identity();
      shift.translation() = end_of(loop.back()) - start_of(next);
      loop.push_back(transformed(next, shift));
    }
    loop.push_back(Segment{end_of(loop.back()), start_of(loop.front())});
    return loop;
  });
}

/// Turned by any angle, moved, and half of the time mirrored.
inline rc::Gen<Isometry2> any_motion() {
  return rc::gen::exec([]() -> Isometry2 {
    Isometry2 motion = Isometry2::Identity();
    motion.linear() = Eigen::Rotation2Dd(*number_in(-4, 4)).toRotationMatrix();
    motion.translation() = *point_in(-100, 100);
    if (*rc::gen::arbitrary<bool>()) motion.linear().col(1) *= -1.0;
    return motion;
  });
}

/// The size rounding is measured against: of the shape and of its coordinates.
inline double extent(const Curve2& curve) {
  const Box2 box = bounds(curve);
  return box.size().norm() + box.lo.norm() + box.hi.norm();
}
inline double extent(const Loop& loop) {
  double sum = 0.0;
  for (const Curve2& c : loop)
    sum += extent(c);
  return sum;
}

}  // namespace planish::test
