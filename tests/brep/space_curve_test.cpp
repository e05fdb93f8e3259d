#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

Frame leaning_frame() { return frame_from_axes({5, -3, 8}, {1, 2, 2}, {2, -1, 0}); }

/// A helix of radius 4 that rises by 3 a radian, over [0.5, 5].
SpaceCurve helix() {
  SpaceCurve curve;
  curve.t0 = 0.5;
  curve.t1 = 5.0;
  curve.evaluate = [](double t, Vec3& point, Vec3& derivative) {
    point = {4 * std::cos(t), 4 * std::sin(t), 3 * t};
    derivative = {-4 * std::sin(t), 4 * std::cos(t), 3};
  };
  curve.start = curve.point(curve.t0);
  curve.end = curve.point(curve.t1);
  return curve;
}

TEST(SolidCurve, HasItsEndsAtTheEndsOfItsParameter) {
  SpaceCurve shifted = line({1, 2, 3}, {4, 6, 3});
  shifted.t0 = 10;
  shifted.t1 = 20;
  EXPECT_NEAR((shifted.point(12) - Vec3(1.6, 2.8, 3)).norm(), 0.0, 1e-12);
  for (const SpaceCurve& curve : {shifted, arc(leaning_frame(), 7, 0.3, 2.0), helix()}) {
    EXPECT_NEAR((curve.point(curve.t0) - curve.start).norm(), 0.0, 1e-12);
    EXPECT_NEAR((curve.point(curve.t1) - curve.end).norm(), 0.0, 1e-12);
  }
}

TEST(SolidCurve, HasTheDerivativeOfItsPoints) {
  SpaceCurve shifted = line({1, 2, 3}, {4, 6, 3});
  shifted.t1 = 10;
  for (const SpaceCurve& curve : {shifted, arc(leaning_frame(), 7, 0.3, 2.0), helix()})
    for (const double share : {0.2, 0.5, 0.9}) {
      const double t = std::lerp(curve.t0, curve.t1, share), h = 1e-5;
      const Vec3 slope = (curve.point(t + h) - curve.point(t - h)) / (2 * h);
      EXPECT_NEAR((curve.derivative(t) - slope).norm(), 0.0, 1e-8);
      EXPECT_NEAR((curve.tangent(t) - slope.normalized()).norm(), 0.0, 1e-8);
    }
}

TEST(SolidCurve, IsAsLongAsItsClosedForm) {
  EXPECT_NEAR(line({1, 2, 3}, {4, 6, 3}).length(), 5, 1e-12);
  EXPECT_NEAR(arc(leaning_frame(), 7, 0.3, 2.0).length(), 7 * 1.7, 1e-12);
  EXPECT_NEAR(helix().length(), 5 * 4.5, 1e-10);
  SpaceCurve parabola;
  parabola.t1 = 2.0;
  parabola.evaluate = [](double t, Vec3& point, Vec3& derivative) {
    point = {t, t * t, 0};
    derivative = {1, 2 * t, 0};
  };
  EXPECT_NEAR(parabola.length(), std::sqrt(17) + std::asinh(4) / 4, 1e-10);
}

TEST(SolidCurve, IsAsFarFromAPointAsItsNearestOne) {
  const std::vector<Vec3> points{{0, 0, 0}, {9, 1, 7}, {4, -2, 12}, {-6, 3, 2}, {1, 8, 20}};
  for (const SpaceCurve& curve :
       {line({1, 2, 3}, {4, 6, 3}), arc(leaning_frame(), 7, 0.3, 2.0),
        arc(leaning_frame(), 7, 2.0, 6.5), arc(leaning_frame(), 7, -9.0, -8.0), helix()})
    for (const Vec3& p : points) {
      double nearest = 1e9;
      for (int i = 0; i <= 20000; ++i)
        nearest = std::min(nearest,
                           (curve.point(std::lerp(curve.t0, curve.t1, i / 20000.0)) - p).norm());
      EXPECT_NEAR(curve.distance(p), nearest, 1e-5);
      EXPECT_LE(curve.distance(p), nearest + 1e-9);
    }
}

TEST(SolidCurve, IsAtItsEndsBeyondThem) {
  const SpaceCurve edge = line({0, 0, 0}, {10, 0, 0});
  EXPECT_NEAR(edge.distance({-3, 4, 0}), 5, 1e-12);
  EXPECT_NEAR(edge.distance({13, 0, 4}), 5, 1e-12);
  EXPECT_NEAR(edge.distance({5, 3, 4}), 5, 1e-12);
  EXPECT_NEAR(line({1, 1, 1}, {1, 1, 1}).distance({1, 4, 5}), 5, 1e-12) << "without length";
  const SpaceCurve half = arc(Frame{}, 5, 0, pi);
  EXPECT_NEAR(half.distance({0, 8, 4}), 5, 1e-12);
  EXPECT_NEAR(half.distance({5, -12, 0}), 12, 1e-12);
  EXPECT_NEAR(half.distance({-5, -12, 0}), 12, 1e-12);
}

}  // namespace
}  // namespace planish::brep::test
