#include "surface_checks.hpp"

#include <planish/geometry/developable.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using std::numbers::pi;
using test::any;
using test::Tangents;

Frame any_frame() {
  Vec3 z(any(-1, 1), any(-1, 1), any(-1, 1));
  RC_PRE(z.norm() > 0.1);
  z.normalize();
  const Vec3 x = z.unitOrthogonal();
  return {Vec3(any(-50, 50), any(-50, 50), any(-50, 50)), x, z.cross(x), z};
}

/// A surface, an offset at which it is regular, and a point on it.
struct Case {
  Developable surface;
  double offset;
  Vec2 uv;
};

Case any_case() {
  if (*rc::gen::arbitrary<bool>())
    return {Cylinder{any_frame(), any(1, 100)}, any(-0.9, 5), {any(-9, 9), any(-50, 50)}};
  const double half_angle = any(0.05, 1.5);
  const double offset = any(-2, 5);
  const double v = any(0.5, 100) + std::max(0.0, -offset / std::tan(half_angle));
  return {Cone{any_frame(), half_angle}, offset, {any(-9, 9), v}};
}

Cone cone_of(double half_angle) { return {Frame{}, half_angle}; }

RC_GTEST_PROP(Development, IsAnIsometryOfEveryOffset, ()) {
  const Case c = any_case();
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  const Eigen::Matrix2d j = Development(c.surface, c.offset).jacobian(c.uv);
  const Eigen::Matrix2d plane = j.transpose() * j;
  Eigen::Matrix2d space;
  space << t.u.dot(t.u), t.u.dot(t.v), t.u.dot(t.v), t.v.dot(t.v);
  RC_ASSERT((plane - space).norm() <= 1e-7 * (1.0 + plane.norm()));
}

RC_GTEST_PROP(Development, IsNotMirroredSeenFromTheNormal, ()) {
  const Case c = any_case();
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  const double area = t.u.cross(t.v).dot(normal_on(c.surface, c.uv.x()));
  const double image = Development(c.surface, c.offset).jacobian(c.uv).determinant();
  RC_ASSERT(area > 0.0);
  RC_ASSERT(std::abs(image - area) <= 1e-7 * (1.0 + area));
}

RC_GTEST_PROP(Development, HasItsOwnDerivative, ()) {
  const Case c = any_case();
  const Development image(c.surface, c.offset);
  constexpr double h = 1e-5;
  const Eigen::Matrix2d j = image.jacobian(c.uv);
  for (const Vec2& e : {Vec2(1, 0), Vec2(0, 1)}) {
    const Vec2 slope = (image.develop(c.uv + h * e) - image.develop(c.uv - h * e)) / (2 * h);
    RC_ASSERT((slope - j * e).norm() <= 1e-7 * (1.0 + j.norm()));
  }
}

RC_GTEST_PROP(Development, IsUndoneByFold, ()) {
  const Case c = any_case();
  const Development image(c.surface, c.offset, c.uv.x() + any(-3, 3));
  RC_ASSERT((image.fold(image.develop(c.uv)) - c.uv).norm() <= 1e-10 * (1.0 + c.uv.norm()));
}

RC_GTEST_PROP(Development, FoldsStraightLinesToGeodesics, ()) {
  const Case c = any_case();
  const Development image(c.surface, c.offset, c.uv.x());
  const Vec2 middle = image.develop(c.uv);
  const double angle = any(0, 2 * pi);
  const double h = 1e-3 * image.jacobian(c.uv).col(0).norm();
  const Vec2 step = h * Vec2(std::cos(angle), std::sin(angle));
  const auto folded = [&](double k) {
    return point_on(c.surface, image.fold(middle + k * step), c.offset);
  };
  // The acceleration of a geodesic has no part in the tangent plane.
  const Vec3 acceleration = (folded(1) - 2 * folded(0) + folded(-1)) / (h * h);
  const Vec3 n = normal_on(c.surface, c.uv.x());
  const double curvature_scale = 1.0 / image.jacobian(c.uv).col(0).norm();
  RC_ASSERT((acceleration - n * n.dot(acceleration)).norm() <= 1e-2 * curvature_scale);
}

RC_GTEST_PROP(Development, ScalesWithTheSurface, ()) {
  Case c = any_case();
  const Vec2 before = Development(c.surface, c.offset).develop(c.uv);
  if (auto* cylinder = std::get_if<Cylinder>(&c.surface)) cylinder->radius *= 10.0;
  const Vec2 after = Development(c.surface, 10 * c.offset).develop({c.uv.x(), 10 * c.uv.y()});
  RC_ASSERT((after - 10 * before).norm() <= 1e-12 * after.norm());
}

RC_GTEST_PROP(Offset, LiesAtItsDistanceAlongTheNormal, ()) {
  const Case c = any_case();
  const Vec3 shift = point_on(c.surface, c.uv, c.offset) - point_on(c.surface, c.uv);
  const Vec3 n = normal_on(c.surface, c.uv.x());
  RC_ASSERT((shift - c.offset * n).norm() <= 1e-10);
  const test::Tangents t = test::tangents(c.surface, c.uv, c.offset);
  RC_ASSERT(std::abs(t.u.dot(n)) <= 1e-7 * t.u.norm());
  RC_ASSERT((t.v - ruling_on(c.surface, c.uv.x())).norm() <= 1e-7);
}

RC_GTEST_PROP(ParametersOf, NamesTheNormalLineOfEveryOffset, ()) {
  const Case c = any_case();
  const Vec3 p = point_on(c.surface, c.uv, c.offset);
  const Vec2 uv = parameters_of(c.surface, p, c.uv.x() + any(-3, 3));
  RC_ASSERT((uv - c.uv).norm() <= 1e-8);
}

RC_GTEST_PROP(ParametersOf, FindsNoPointFartherThanAnyOther, ()) {
  const Case c = any_case();
  const Vec3 p(any(-90, 90), any(-90, 90), any(-90, 90));
  const Vec2 foot = parameters_of(c.surface, p, 0.0);
  const double distance = (point_on(c.surface, foot) - p).norm();
  RC_ASSERT(std::abs(foot.x()) <= pi + 1e-12);
  RC_ASSERT(distance <= (point_on(c.surface, c.uv) - p).norm() + 1e-9);
}

TEST(UnrollCylinder, MapsAzimuthToArcLengthOfTheNeutralRadius) {
  const Development image(Cylinder{Frame{}, 3.0}, 0.44);
  EXPECT_EQ(image.develop({0.5 * pi, 7.0}), Vec2(3.44 * 0.5 * pi, 7.0));
}

TEST(UnrollCylinder, FoldsALineToAHelixOfTheSameLength) {
  const Cylinder cylinder{Frame{}, 10.0};
  const Development image(cylinder, 0.0);
  const Vec2 a(0, 0), b(30, 40);
  double walked = 0.0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const auto at = [&](int k) { return point_on(cylinder, image.fold(a + (b - a) * k / steps)); };
    walked += (at(i + 1) - at(i)).norm();
    EXPECT_NEAR((at(i + 1) - at(i)).z(), 40.0 / steps, 1e-12);
  }
  EXPECT_NEAR(walked, 50.0, 1e-5);
}

TEST(UnrollCone, BecomesASectorOfTurnTimesSine) {
  const Development image(cone_of(pi / 6), 0.0);
  const Vec2 start = image.develop({0.0, 8.0});
  const Vec2 end = image.develop({2 * pi, 8.0});
  EXPECT_NEAR((start - Vec2(8, 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((end - Vec2(-8, 0)).norm(), 0.0, 1e-14);  // half a disc: sin 30° = 1/2
  EXPECT_LT(image.develop({pi, 8.0}).y(), 0.0);         // outside up: clockwise
}

TEST(UnrollCone, KeepsTheOffsetApexAtTheOrigin) {
  // The neutral cone inside by 1 at 45° has its apex 1/sin 45° up the axis, one unit of v further.
  const Cone cone = cone_of(pi / 4);
  EXPECT_NEAR((point_on(cone, {0.3, 1.0}, -1.0) - Vec3(0, 0, std::sqrt(2.0))).norm(), 0.0, 1e-14);
  EXPECT_NEAR(Development(cone, -1.0).develop({0.3, 1.0}).norm(), 0.0, 1e-14);
}

RC_GTEST_PROP(UnrollCone, FoldsLinesToCurvesOfClairaut, ()) {
  const Cone cone{any_frame(), any(0.1, 1.4)};
  const Development image(cone, 0.0);
  const Vec2 a = image.develop({any(-1, 1), any(20, 80)});
  const double bearing = any(0, 2 * pi);
  const Vec2 along(std::cos(bearing), std::sin(bearing));
  const auto clairaut = [&](double distance) {
    constexpr double h = 1e-4;
    const auto at = [&](double d) { return point_on(cone, image.fold(a + d * along)); };
    const Vec2 uv = image.fold(a + distance * along);
    const Vec3 tangent = (at(distance + h) - at(distance - h)) / (2 * h);
    const Vec3 parallel = -std::sin(uv.x()) * cone.frame.x + std::cos(uv.x()) * cone.frame.y;
    return uv.y() * std::sin(cone.half_angle) * tangent.dot(parallel);
  };
  RC_ASSERT(std::abs(clairaut(any(0, 15)) - clairaut(0.0)) <= 1e-6);
}

TEST(UnrollCone, FoldReturnsTheTurnAsked) {
  const Cone cone = cone_of(1.2);
  for (const double u : {-20.0, -3.5, 0.0, 3.5, 20.0}) {
    const Development image(cone, 0.2, u + 1.0);
    EXPECT_NEAR(image.fold(image.develop({u, 5.0})).x(), u, 1e-12);
  }
}

TEST(ParametersOf, ReturnsTheTurnAsked) {
  const Developable cylinder = Cylinder{Frame{}, 2.0};
  EXPECT_NEAR(parameters_of(cylinder, Vec3(0, 2, 1), 0.0).x(), 0.5 * pi, 1e-14);
  EXPECT_NEAR(parameters_of(cylinder, Vec3(0, 2, 1), 2 * pi).x(), 2.5 * pi, 1e-14);
  EXPECT_NEAR(parameters_of(cylinder, Vec3(0, 2, 1), -4.0).x(), -1.5 * pi, 1e-14);
}

TEST(ParametersOf, OnTheAxisKeepsTheAzimuthAsked) {
  EXPECT_EQ(parameters_of(Cylinder{Frame{}, 2.0}, Vec3(0, 0, 5), 1.25), Vec2(1.25, 5.0));
  EXPECT_EQ(parameters_of(cone_of(0.5), Vec3(0, 0, -5), 1.25), Vec2(1.25, 0.0));  // the apex
}

/// Whether the image runs with its preimage: the same place at the same t.
void expect_runs_with(const Development& image, const Curve2& uv_curve, const Curve2& result,
                      double tolerance) {
  for (int i = 0; i <= 32; ++i) {
    const double t = i / 32.0;
    EXPECT_NEAR((point_at(result, t) - image.develop(point_at(uv_curve, t))).norm(), 0.0,
                tolerance);
  }
}

/// Whether every point of the preimage has its image within tolerance of the result.
void expect_covers(const Development& image, const Curve2& uv_curve, const Curve2& result,
                   double tolerance) {
  EXPECT_NEAR((start_of(result) - image.develop(start_of(uv_curve))).norm(), 0.0, 1e-12);
  EXPECT_NEAR((end_of(result) - image.develop(end_of(uv_curve))).norm(), 0.0, 1e-12);
  for (int i = 0; i <= 200; ++i) {
    const Vec2 p = image.develop(point_at(uv_curve, i / 200.0));
    EXPECT_LE(nearest(result, p).distance, tolerance);
  }
}

TEST(DevelopCurve, OnACylinderSegmentsStaySegments) {
  const Development image(Cylinder{Frame{}, 5.0}, -0.5);
  for (const Segment& s :
       {Segment{{0, 0}, {1, 0}}, Segment{{2, 1}, {2, 9}}, Segment{{0, 1}, {3, -4}}}) {
    const Curve2 result = image.develop(Curve2(s), 1e-3);
    ASSERT_TRUE(std::holds_alternative<Segment>(result));
    expect_runs_with(image, s, result, 1e-13);
  }
}

TEST(DevelopCurve, OnACylinderSplinesAreExact) {
  const Development image(Cylinder{Frame{}, 5.0}, -0.5);
  const CubicSpline wave{{{0, 0}, {1, 3}, {2, -3}, {3, 0}, {4, 3}, {5, 9}, {6, 6}}};
  const Curve2 result = image.develop(Curve2(wave), 1.0);
  ASSERT_EQ(std::get<CubicSpline>(result).poles.size(), wave.poles.size());
  expect_runs_with(image, wave, result, 1e-13);
}

TEST(DevelopCurve, OnACylinderArcsAreFitted) {
  const Development image(Cylinder{Frame{}, 5.0}, 0.0);
  const Arc circle{{0.2, 1.0}, 0.3, 0.1, 2 * pi};
  expect_covers(image, circle, image.develop(Curve2(circle), 1e-5), 1e-5);
}

TEST(DevelopCurve, OnAConeRulingsAreSegments) {
  const Development image(cone_of(0.7), 0.3);
  const Segment ruling{{2.0, 3.0}, {2.0 + 1e-15, 9.0}};
  const Curve2 result = image.develop(Curve2(ruling), 1e-3);
  ASSERT_TRUE(std::holds_alternative<Segment>(result));
  expect_runs_with(image, ruling, result, 1e-13);
}

TEST(DevelopCurve, OnAConeParallelsAreArcsBothWays) {
  const Development image(cone_of(0.7), 0.3);
  for (const double turn : {5.0, -5.0, 2 * pi}) {
    const Segment parallel{{2.0, 4.0}, {2.0 + turn, 4.0 + 1e-15}};
    const Curve2 result = image.develop(Curve2(parallel), 1e-3);
    ASSERT_TRUE(std::holds_alternative<Arc>(result));
    EXPECT_NEAR(std::get<Arc>(result).sweep, -turn * std::sin(0.7), 1e-14);
    expect_runs_with(image, parallel, result, 1e-13);
  }
}

TEST(DevelopCurve, OnAConeAllElseIsFittedWithinTolerance) {
  const Development image(cone_of(0.7), -0.3);
  const Segment slanted{{-1, 3}, {2, 30}};
  const CubicSpline chain{{{0, 9}, {1, 12}, {2, 3}, {3, 9}, {3.1, 9.6}, {3.2, 10}, {3.3, 10}}};
  for (const double tolerance : {1e-2, 1e-6}) {
    expect_covers(image, slanted, image.develop(Curve2(slanted), tolerance), tolerance);
    expect_covers(image, chain, image.develop(Curve2(chain), tolerance), tolerance);
  }
}

TEST(DevelopCurve, KeepsTheAreaOfAPatch) {
  // Counter-clockwise in (u, v) stays counter-clockwise.
  const auto patch_area = [](const Development& image, const Vec2& lo, const Vec2& hi) {
    const Vec2 right(hi.x(), lo.y()), left(lo.x(), hi.y());
    double area = 0.0;
    for (const Segment& s :
         {Segment{lo, right}, Segment{right, hi}, Segment{hi, left}, Segment{left, lo}})
      area += green_area(image.develop(Curve2(s), 1e-9));
    return area;
  };
  const double turn = 2.5;
  EXPECT_NEAR(patch_area(Development(Cylinder{Frame{}, 4.0}, 0.5), {1, 2}, {1 + turn, 9}),
              4.5 * turn * 7, 1e-11);
  EXPECT_NEAR(patch_area(Development(cone_of(0.4), 0.0), {1, 2}, {1 + turn, 9}),
              0.5 * std::sin(0.4) * turn * (81 - 4), 1e-11);
}

}  // namespace
}  // namespace planish
