#include "surface_checks.hpp"

#include <planish/geometry/general_cone.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace planish {
namespace {

using std::numbers::pi;
using test::any;
using test::simpson;

Vec3 any_point(double size) { return {any(-size, size), any(-size, size), any(-size, size)}; }

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The circle at distance s from the apex of a right cone, over its azimuth.
SpaceCurve circle_of(const Cone& cone, double s) {
  return [=](double u) -> SpaceCurvePoint {
    const Frame& f = cone.frame;
    const double r = s * std::sin(cone.half_angle);
    const Vec3 out = std::cos(u) * f.x + std::sin(u) * f.y;
    return {f.origin + s * std::cos(cone.half_angle) * f.z + r * out,
            r * (std::cos(u) * f.y - std::sin(u) * f.x), -r * out};
  };
}

Cone tilted_cone() {
  return {frame_from_axes({10, -20, 5}, Vec3(1, 2, 3).normalized(), Vec3::UnitX()), 0.4};
}

/// Apex and arc of an oblique cone whose arc is far from a circle.
struct Corner {
  Vec3 apex{3, -5, 90}, p0{40, 0, 0}, tangent_point{45, 38, 4}, p1{-10, 50, -6};
  SpaceCurve arc() const { return conic_arc(p0, tangent_point, p1); }
};

Corner any_corner() {
  Corner c{any_point(100), any_point(50), any_point(50), any_point(50)};
  const Vec3 in = c.tangent_point - c.p0, out = c.p1 - c.tangent_point;
  RC_PRE(in.norm() > 5.0 && out.norm() > 5.0);
  const double turn = angle_between(in, out);
  RC_PRE(turn > 0.1 && turn < 2.6);
  const double height = std::abs((c.apex - c.p0).dot(in.cross(out).normalized()));
  RC_PRE(height > 20.0);
  return c;
}

/// The cone of math.md#general-cone itself, without knots.
struct ExactCone {
  Vec3 apex;
  SpaceCurve curve;

  double reach(double t) const { return (curve(t).point - apex).norm(); }
  Vec3 ruling(double t) const { return (curve(t).point - apex).normalized(); }
  Vec3 point(double t, double v) const { return curve(t).point + v * ruling(t); }
  Vec3 normal(double t) const {
    return curve(t).derivative.cross(curve(t).point - apex).normalized();
  }
  /// Rate of the azimuth in the plane.
  double turning(double t) const {
    const SpaceCurvePoint c = curve(t);
    return (c.point - apex).cross(c.derivative).norm() / (c.point - apex).squaredNorm();
  }
};

// --- the arc -------------------------------------------------------------------------------------

RC_GTEST_PROP(ConicArc, TouchesItsTangentsAtItsEnds, ()) {
  const Corner c = any_corner();
  const SpaceCurve arc = c.arc();
  RC_ASSERT((arc(0).point - c.p0).norm() <= 1e-12 * 100);
  RC_ASSERT((arc(1).point - c.p1).norm() <= 1e-12 * 100);
  RC_ASSERT(angle_between(arc(0).derivative, c.tangent_point - c.p0) <= 1e-12);
  RC_ASSERT(angle_between(arc(1).derivative, c.p1 - c.tangent_point) <= 1e-12);
}

RC_GTEST_PROP(ConicArc, HasItsOwnDerivatives, ()) {
  const SpaceCurve arc = any_corner().arc();
  const double t = any(0, 1), h = 1e-5;
  const SpaceCurvePoint before = arc(t - h), at = arc(t), after = arc(t + h);
  RC_ASSERT(((after.point - before.point) / (2 * h) - at.derivative).norm() <= 1e-6);
  RC_ASSERT(((after.derivative - before.derivative) / (2 * h) - at.second).norm() <= 1e-5);
}

RC_GTEST_PROP(ConicArc, OfEqualTangentsIsACircularArc, ()) {
  // Tangents of length R tan(α/2), centre at distance R / cos(α/2).
  const double radius = any(1, 100), turn = any(0.01, 3.0);
  const Frame f = frame_from_normal(any_point(100),
                                    Vec3(any(0.1, 1), any(-1, 1), any(-1, 1)).normalized());
  const auto at = [&](double r, double azimuth) {
    return f.point(r * Vec2(std::cos(azimuth), std::sin(azimuth)));
  };
  const double start = any(0, 6);
  const SpaceCurve arc = conic_arc(at(radius, start),
                                   at(radius / std::cos(turn / 2), start + turn / 2),
                                   at(radius, start + turn));
  for (int i = 0; i <= 10; ++i)
    RC_ASSERT((arc(i / 10.0).point - at(radius, start + turn * i / 10)).norm() <=
              1e-9 * radius / turn);
}

RC_GTEST_PROP(ConicArc, LiesOnOneEllipse, ()) {
  // In the axes where p0 = (0, 0), the tangent point (1, 0) and p1 (1, 1), the conics that touch
  // there are (x − y)² = k y (1 − x); ellipses have 0 < k < 4.
  const Corner c = any_corner();
  const SpaceCurve arc = c.arc();
  Eigen::Matrix<double, 3, 2> axes;
  axes << c.tangent_point - c.p0, c.p1 - c.tangent_point;
  const auto ratio = [&](double t) {
    const Vec2 p = axes.colPivHouseholderQr().solve(arc(t).point - c.p0);
    const double chord = p.x() - p.y(), first = p.y(), second = 1 - p.x();
    return chord * chord / (first * second);
  };
  const double k = ratio(0.5);
  RC_ASSERT(k < 4.0);
  for (double t : {0.1, 0.3, 0.8, 0.95})
    RC_ASSERT(std::abs(ratio(t) - k) <= 1e-7 * std::max(1.0, k));
}

// --- the cone ------------------------------------------------------------------------------------

TEST(ConeOver, ACircleAboutTheAxisIsTheRightCone) {
  const Cone cone = tilted_cone();
  const double s = 50, u0 = -0.5, u1 = 2.2, tolerance = 1e-11;
  const Ruled ruled = cone_over(cone.frame.origin, circle_of(cone, s), u0, u1, tolerance);
  for (double u : {-0.5, -0.1234, 0.77, 1.9, 2.2}) {
    EXPECT_LT((normal_on(ruled, u) - normal_on(cone, u)).norm(), 1e-8) << u;
    EXPECT_LT((ruling_on(ruled, u) - ruling_on(cone, u)).norm(), 1e-11) << u;
    for (double v : {-49.0, -20.0, 0.0, 30.0})
      EXPECT_LT((point_on(ruled, {u, v}) - point_on(cone, {u, s + v})).norm(), 1e-10) << u;
  }
}

/// The motion that puts the image of a cone where a ruled surface has its own: first knot to the
/// origin, first ruling along +y.
Isometry2 to_first_ruling(const Development& image, const Vec2& first) {
  const Vec2 along = image.jacobian(first).col(1);
  Isometry2 motion = Isometry2::Identity();
  motion.linear() << along.y(), -along.x(), along.x(), along.y();
  motion.pretranslate(-(motion.linear() * image.develop(first)));
  return motion;
}

TEST(ConeOver, ARightConeDevelopsAsTheRightCone) {
  const Cone cone = tilted_cone();
  const double s = 50, u0 = -0.5, u1 = 2.2;
  const Ruled ruled = cone_over(cone.frame.origin, circle_of(cone, s), u0, u1, 1e-11);
  for (double offset : {-1.5, 0.0, 2.0}) {
    const Development of_cone(cone, offset, 1.0), of_ruled(ruled, offset);
    const Isometry2 motion = to_first_ruling(of_cone, {u0, s});
    for (double u : {-0.5, 0.3, 1.234, 2.2})
      for (double v : {-40.0, -10.0, 0.0, 25.0}) {
        const Vec2 expected = motion * of_cone.develop({u, s + v});
        EXPECT_LT((of_ruled.develop({u, v}) - expected).norm(), 1e-9) << u << ' ' << v;
      }
  }
}

TEST(ConeOver, ObliqueConesHaveTheAreaAndLengthsOfTheirQuadrature) {
  const Corner corner;
  const ExactCone exact{corner.apex, corner.arc()};
  const Ruled ruled = cone_over(corner.apex, corner.arc(), 0, 1, 1e-11);
  const Development image(ruled, 0.0);
  const Vec2 apex = image.develop({0, -exact.reach(0)});

  // Polar coordinates about the image of the apex.
  for (double t : {0.25, 0.5, 0.9, 1.0}) {
    EXPECT_LT((image.develop({t, -exact.reach(t)}) - apex).norm(), 1e-9);
    const Vec2 first = -apex, p = image.develop({t, 0}) - apex;
    EXPECT_NEAR(p.norm(), exact.reach(t), 1e-9);
    const double turn = std::atan2(first.x() * p.y() - first.y() * p.x(), first.dot(p));
    EXPECT_NEAR(-turn, simpson([&](double x) { return exact.turning(x); }, 0, t), 1e-11);
  }

  // Lengths and area of the image, as polygons of it and of the surface have them in the limit.
  const double length = simpson([&](double t) { return corner.arc()(t).derivative.norm(); }, 0, 1);
  const auto speed = [&](double t) { return image.jacobian({t, 0}).col(0).norm(); };
  EXPECT_NEAR(simpson(speed, 0, 1), length, 1e-8 * length);
  const double area = simpson(
      [&](double t) { return 0.5 * exact.turning(t) * exact.reach(t) * exact.reach(t); }, 0, 1);
  const auto swept = [&](double t) {
    const Vec2 p = image.develop({t, 0}) - apex, d = image.jacobian({t, 0}).col(0);
    return 0.5 * (p.y() * d.x() - p.x() * d.y());
  };
  EXPECT_NEAR(simpson(swept, 0, 1), area, 1e-9 * area);
}

RC_GTEST_PROP(ConeOver, IsTangentAtItsEndsToThePlanesOfTheTangents, ()) {
  const Corner c = any_corner();
  const Ruled ruled = cone_over(c.apex, c.arc(), 0, 1, 1e-6);
  const Vec3 first = (c.tangent_point - c.p0).cross(c.p0 - c.apex).normalized();
  const Vec3 last = (c.p1 - c.tangent_point).cross(c.p1 - c.apex).normalized();
  RC_ASSERT((normal_on(ruled, 0.0) - first).norm() <= 1e-12);
  RC_ASSERT((normal_on(ruled, 1.0) - last).norm() <= 1e-12);
}

RC_GTEST_PROP(ConeOver, KeepsItsTolerance, ()) {
  const Corner c = any_corner();
  const ExactCone exact{c.apex, c.arc()};
  const double tolerance = std::pow(10.0, -*rc::gen::inRange(2, 10));
  const Ruled ruled = cone_over(c.apex, c.arc(), 0, 1, tolerance);
  for (int i = 0; i < 50; ++i) {
    const double t = any(0, 1), share = any(-1, 1), v = share * exact.reach(t);
    const double deviation = (point_on(ruled, {t, v}) - exact.point(t, v)).norm();
    RC_ASSERT(deviation <= (share <= 0 ? 1.0 : 3.0) * tolerance);
    double size = 0;
    for (int k = 0; k <= 100; ++k)
      size = std::max(size, exact.reach(k / 100.0));
    RC_ASSERT((normal_on(ruled, t) - exact.normal(t)).norm() <=
              std::pow(tolerance / size, 0.75) * 1.01);
  }
}

TEST(ConeOver, TakesKnotsAsTheFourthRootOfTheTolerance) {
  const Corner c;
  const auto knots = [&](double tolerance) {
    return static_cast<double>(cone_over(c.apex, c.arc(), 0, 1, tolerance).knots.size());
  };
  EXPECT_LT(knots(1e-6), 100.0);
  EXPECT_NEAR(std::log2(knots(1e-10) / knots(1e-6)), std::log2(10.0), 1.0);
}

TEST(ConeOver, PutsKnotsWhereTheCurveTurns) {
  // A flat ellipse turns at its ends.
  const SpaceCurve flat = [](double t) -> SpaceCurvePoint {
    return {{100 * std::cos(t), 5 * std::sin(t), 0},
            {-100 * std::sin(t), 5 * std::cos(t), 0},
            {-100 * std::cos(t), -5 * std::sin(t), 0}};
  };
  const Ruled ruled = cone_over({0, 0, 80}, flat, -0.5 * pi, 0.5 * pi, 1e-6);
  const auto interval = [&](double t) {
    const auto next = std::ranges::upper_bound(ruled.knots, t, {}, &Ruled::Knot::u);
    return next->u - std::prev(next)->u;
  };
  EXPECT_LT(interval(0.0), interval(1.5));
}

RC_GTEST_PROP(ConeOver, IsDevelopedIsometrically, ()) {
  const Corner c = any_corner();
  const ExactCone exact{c.apex, c.arc()};
  const Ruled ruled = cone_over(c.apex, c.arc(), 0, 1, 1e-9);
  const Development image(ruled, 0.0);
  const double t = any(0.01, 0.99), v = any(-0.9, 0.5) * exact.reach(t), h = 1e-5;
  const Vec3 by_t = (exact.point(t + h, v) - exact.point(t - h, v)) / (2 * h);
  const Vec3 by_v = exact.ruling(t);
  const Eigen::Matrix2d j = image.jacobian({t, v}), plane = j.transpose() * j;
  Eigen::Matrix2d space;
  space << by_t.dot(by_t), by_t.dot(by_v), by_t.dot(by_v), 1.0;
  RC_ASSERT((plane - space).norm() <= 1e-5 * (1.0 + space.norm()));
  RC_ASSERT((image.fold(image.develop({t, v})) - Vec2(t, v)).norm() <= 1e-8);
}

/// Length of the straight chain through points of the surface over a segment of (u, v).
double length_of(const std::function<Vec3(const Vec2&)>& point, const Vec2& a, const Vec2& b) {
  return simpson(
      [&](double s) {
        const double h = 1e-5;
        return ((point(a + (s + h) * (b - a)) - point(a + (s - h) * (b - a))) / (2 * h)).norm();
      },
      0, 1, 400);
}

TEST(ConeOver, KeepsTheLengthsOfCurvesThatAreDeveloped) {
  const Corner c;
  const ExactCone exact{c.apex, c.arc()};
  const Ruled ruled = cone_over(c.apex, c.arc(), 0, 1, 1e-10);
  const auto on_cone = [&](const Vec2& uv) { return exact.point(uv.x(), uv.y()); };
  const Development image(ruled, 0.0);
  for (const auto& [a, b] :
       {std::pair(Vec2(0, 0), Vec2(1, 0)), std::pair(Vec2(0, -60), Vec2(1, -60)),
        std::pair(Vec2(0.1, -50), Vec2(0.9, 20))}) {
    const double meant = length_of(on_cone, a, b);
    EXPECT_NEAR(length(image.develop(Curve2(Segment{a, b}), 1e-9)), meant, 1e-8 * meant);
  }
}

TEST(ConeOver, OffsetsDevelopAsTheSurfaceAtThatDistance) {
  const Corner c;
  const ExactCone exact{c.apex, c.arc()};
  const Ruled ruled = cone_over(c.apex, c.arc(), 0, 1, 1e-10);
  for (double offset : {-2.0, 1.5}) {
    const Development image(ruled, offset);
    const auto beside = [&](const Vec2& uv) {
      return Vec3(exact.point(uv.x(), uv.y()) + offset * exact.normal(uv.x()));
    };
    for (double v : {-60.0, 0.0}) {
      const double meant = length_of(beside, {0, v}, {1, v});
      EXPECT_NEAR(length(image.develop(Curve2(Segment{{0, v}, {1, v}}), 1e-9)), meant,
                  1e-7 * meant);
    }
  }
}

RC_GTEST_PROP(ConeOver, DoesNotSeeWhereItLiesAndScales, ()) {
  const Corner c = any_corner();
  const double factor = any(0.1, 10);
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.rotate(Eigen::AngleAxisd(any(0, 6), Vec3(any(0.1, 1), any(-1, 1), 0.3).normalized()));
  motion.scale(factor);
  motion.pretranslate(any_point(100));
  const Corner d{motion * c.apex, motion * c.p0, motion * c.tangent_point, motion * c.p1};
  const Ruled before = cone_over(c.apex, c.arc(), 0, 1, 1e-6);
  const Ruled after = cone_over(d.apex, d.arc(), 0, 1, factor * 1e-6);
  const double t = any(0, 1), v = any(-30, 30);
  const Vec3 p = point_on(before, {t, v});
  RC_ASSERT((point_on(after, {t, factor * v}) - motion * p).norm() <= 4e-6 * factor);
}

TEST(ConeOverDeathTest, RefusesATangentThroughTheApex) {
  const SpaceCurve line = [](double t) -> SpaceCurvePoint {
    return {{t, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  };
  EXPECT_DEATH(cone_over({-1, 0, 0}, line, 0, 1, 1e-6), "b_prime");
  EXPECT_DEATH(cone_over({0, 0, 1}, line, 0, 1, 0.0), "tolerance");
}

}  // namespace
}  // namespace planish
