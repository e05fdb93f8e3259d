#include "exact_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;
using Kind = SpaceCurve::Kind;

/// A curve of no known kind.
template <typename Point, typename Derivative>
SpaceCurve other_curve(double t0, double t1, Point point, Derivative derivative) {
  SpaceCurve curve;
  curve.t0 = t0;
  curve.t1 = t1;
  curve.start = point(t0);
  curve.end = point(t1);
  curve.evaluate = [=](double t, Vec3& p, Vec3& d) {
    p = point(t);
    d = derivative(t);
  };
  return curve;
}

/// Run unevenly about (1, 2, 3) with radius 7, in a plane of its own.
SpaceCurve circular(double angle, double bump = 0.0) {
  const Frame frame = frame_from_normal({1, 2, 3}, Vec3(1, 2, 2).normalized());
  return other_curve(
      0, 1,
      [=](double t) -> Vec3 {
        const double a = angle * t * t;
        const double radius = 7 + bump * std::sin(pi * t);
        return frame.point(radius * Vec2(std::cos(a), std::sin(a)));
      },
      [=](double) -> Vec3 { return Vec3::Zero(); });
}

TEST(ExactCurve, RecognisesALine) {
  const auto straight = other_curve(
      0, 1,
      [](double t) -> Vec3 {
        return {t * t, 2 * t * t, 0};
      },
      [](double t) -> Vec3 {
        return {2 * t, 4 * t, 0};
      });
  EXPECT_EQ(exact_curve(straight, 1e-7).kind, Kind::line);
}

TEST(ExactCurve, LeavesALineThatTurnsBack) {
  const auto back = other_curve(
      0, 1,
      [](double t) -> Vec3 {
        return {std::sin(0.75 * pi * t), 0, 0};
      },
      [](double) -> Vec3 { return Vec3::Zero(); });
  EXPECT_EQ(exact_curve(back, 1e-7).kind, Kind::other);
}

TEST(ExactCurve, RecognisesAnArc) {
  const SpaceCurve curve = exact_curve(circular(2.0), 1e-7);
  ASSERT_EQ(curve.kind, Kind::circle);
  EXPECT_NEAR(curve.radius, 7.0, 1e-9);
  EXPECT_NEAR((curve.circle.origin - Vec3(1, 2, 3)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(curve.t1 - curve.t0, 2.0, 1e-9);
  EXPECT_NEAR((curve.point(curve.t1) - curve.end).norm(), 0.0, 1e-9);
}

TEST(ExactCurve, RecognisesAFullCircle) {
  const SpaceCurve curve = exact_curve(circular(2 * pi), 1e-7);
  ASSERT_EQ(curve.kind, Kind::circle);
  EXPECT_DOUBLE_EQ(curve.t1 - curve.t0, 2 * pi);
}

TEST(ExactCurve, RecognisesThemOverAnyParameters) {
  const auto about = [](double t) -> Vec3 { return {4 * std::cos(t), 4 * std::sin(t), 9}; };
  const auto slope = [](double t) -> Vec3 { return {-4 * std::sin(t), 4 * std::cos(t), 0}; };
  const SpaceCurve arc = exact_curve(other_curve(-2.0, 1.5, about, slope), 1e-7);
  ASSERT_EQ(arc.kind, Kind::circle);
  EXPECT_NEAR(arc.radius, 4, 1e-9);
  EXPECT_NEAR(arc.t1 - arc.t0, 3.5, 1e-9);
  for (const double share : {0.0, 0.4, 1.0})
    EXPECT_NEAR((arc.point(arc.t0 + 3.5 * share) - about(-2.0 + 3.5 * share)).norm(), 0.0, 1e-9);
  const auto along = [](double t) -> Vec3 { return {3 * t, 4 * t, 1}; };
  const SpaceCurve line = exact_curve(other_curve(5, 9, along,
                                                  [](double) -> Vec3 {
                                                    return {3, 4, 0};
                                                  }),
                                      1e-7);
  EXPECT_EQ(line.kind, Kind::line);
  EXPECT_NEAR(line.length(), 20, 1e-9);
}

TEST(ExactCurve, LeavesAHelix) {
  const auto helix = other_curve(
      0, 3,
      [](double t) -> Vec3 {
        return {4 * std::cos(t), 4 * std::sin(t), 0.1 * t};
      },
      [](double) -> Vec3 { return Vec3::Zero(); });
  EXPECT_EQ(exact_curve(helix, 1e-3).kind, Kind::other);
}

TEST(ExactCurve, LeavesWhatStraysFromTheCircle) {
  EXPECT_EQ(exact_curve(circular(2.0, 1e-5), 1e-7).kind, Kind::other);
  EXPECT_EQ(exact_curve(circular(2.0, 1e-5), 1e-3).kind, Kind::circle);
}

}  // namespace
}  // namespace planish::brep
