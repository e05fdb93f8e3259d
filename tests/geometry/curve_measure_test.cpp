#include "geometry/random_curves.hpp"
#include "geometry/sample_curves.hpp"

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

/// (t², t³) for t from −1 to 1: comes in, stops at a cusp in the origin, goes out.
CubicSpline semicubical() { return {{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}}; }

TEST(Length, OfAnArcIsRadiusTimesAngle) {
  EXPECT_DOUBLE_EQ(length(Arc{{5, 5}, 3, 1, -pi / 2}), 1.5 * pi);
  EXPECT_DOUBLE_EQ(length(Arc{{5, 5}, 3, 1, 2 * pi}), 6 * pi);
}

TEST(Length, OfASplineThatIsASegmentIsItsDistance) {
  const CubicSpline s{{{0, 0}, {1, 1}, {2, 2}, {3, 3}}};
  EXPECT_NEAR(length(Curve2(s)), std::sqrt(18.0), 1e-12 * 5);
}

TEST(Length, OfAParabolaIsTheClosedForm) {
  // (t, t²) for t in [0, 1]: √5/2 + asinh(2)/4.
  const CubicSpline s{{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}, {1, 1}}};
  const double expected = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
  EXPECT_NEAR(length(Curve2(s)), expected, 1e-12 * expected);
}

TEST(Length, KeepsItsAccuracyAtACusp) {
  // ∫ |t| √(4 + 9t²) dt over [−1, 1] = 2 (13^1.5 − 8) / 27.
  const double expected = 2 * (std::pow(13.0, 1.5) - 8) / 27;
  EXPECT_NEAR(length(Curve2(semicubical())), expected, 1e-12 * expected);
  // A cusp that is not in the middle of the span.
  const Curve2 part = trimmed(semicubical(), 0.3, 1.0);
  const auto from_cusp = [](double t) { return (std::pow(4 + 9 * t * t, 1.5) - 8) / 27; };
  EXPECT_NEAR(length(part), from_cusp(0.4) + from_cusp(1), 1e-12 * expected);
}

TEST(Length, OfADegenerateSplineIsZero) {
  EXPECT_EQ(length(Curve2(CubicSpline{{{2, 3}, {2, 3}, {2, 3}, {2, 3}}})), 0.0);
}

TEST(SignedArea, OfKnownShapes) {
  EXPECT_DOUBLE_EQ(signed_area(unit_square()), 1.0);
  EXPECT_DOUBLE_EQ(signed_area({Arc{{7, -3}, 2, 0.3, 2 * pi}}), 4 * pi);
  EXPECT_DOUBLE_EQ(signed_area({Arc{{7, -3}, 2, 0.3, -2 * pi}}), -4 * pi);
  // A quarter disc.
  EXPECT_NEAR(
      signed_area({Segment{{0, 0}, {1, 0}}, Arc{{0, 0}, 1, 0, pi / 2}, Segment{{0, 1}, {0, 0}}}),
      pi / 4, 1e-15);
  // Under y = x² from 0 to 1: a third.
  const CubicSpline parabola{{{1, 1}, {2.0 / 3, 1.0 / 3}, {1.0 / 3, 0}, {0, 0}}};
  EXPECT_NEAR(signed_area({Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {1, 1}}, parabola}), 1.0 / 3,
              1e-15);
  EXPECT_EQ(signed_area({}), 0.0);
}

TEST(SignedArea, DoesNotDrownFarFromTheOrigin) {
  Isometry2 far = Isometry2::Identity();
  far.translation() = Vec2(1e6, -1e6);  // halves and ones: exact even there
  EXPECT_DOUBLE_EQ(signed_area(transformed(unit_square(), far)), 1.0);
}

RC_GTEST_PROP(GreenArea, OfACurveAndItsReverseCancel, ()) {
  const Curve2 c = *any_curve();
  const double scale = extent(c);
  RC_ASSERT(std::abs(green_area(c) + green_area(reversed(c))) <= 1e-13 * scale * scale);
}

RC_GTEST_PROP(SignedArea, IsNegatedByReversing, ()) {
  const Loop loop = *any_loop();
  const double scale = extent(loop);
  RC_ASSERT(std::abs(signed_area(reversed(loop)) + signed_area(loop)) <= 1e-12 * scale * scale);
}

RC_GTEST_PROP(SignedArea, DoesNotDependOnTheStart, ()) {
  Loop loop = *any_loop();
  const double before = signed_area(loop);
  std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  RC_ASSERT(std::abs(signed_area(loop) - before) <= 1e-12 * extent(loop) * extent(loop));
}

RC_GTEST_PROP(RigidMotion, KeepsLengthAndArea, ()) {
  const Loop loop = *any_loop();
  const Isometry2 motion = *any_motion();
  const Loop moved = transformed(loop, motion);
  const double sense = motion.linear().determinant();
  const double scale = extent(loop) + extent(moved);
  RC_ASSERT(std::abs(length(moved) - length(loop)) <=
            1e-12 * scale * static_cast<double>(loop.size()));
  RC_ASSERT(std::abs(signed_area(moved) - sense * signed_area(loop)) <= 1e-12 * scale * scale);
}

RC_GTEST_PROP(Scaling, TimesTenGivesTenTimesTheLengthAndHundredTimesTheArea, ()) {
  const Loop loop = *any_loop();
  const double scale = extent(loop);
  RC_ASSERT(std::abs(length(scaled(loop, 10)) - 10 * length(loop)) <= 1e-11 * length(loop));
  RC_ASSERT(std::abs(signed_area(scaled(loop, 10)) - 100 * signed_area(loop)) <=
            1e-10 * scale * scale);
}

TEST(Bounds, OfAnArcReachItsExtremePoints) {
  const Box2 half = bounds(Arc{{1, 1}, 2, 0, pi});
  expect_near(half.lo, {-1, 1}, 1e-15);
  expect_near(half.hi, {3, 3}, 1e-15);
  const Box2 clockwise = bounds(Arc{{0, 0}, 1, pi / 4, -pi / 2});
  expect_near(clockwise.lo, {std::sqrt(0.5), -std::sqrt(0.5)}, 1e-15);
  expect_near(clockwise.hi, {1, std::sqrt(0.5)}, 1e-15);
  const Box2 full = bounds(Arc{{0, 0}, 1, 100.0, -2 * pi});
  EXPECT_EQ(full.lo, Vec2(-1, -1));
  EXPECT_EQ(full.hi, Vec2(1, 1));
}

TEST(Bounds, OfASplineAreThoseOfTheCurveNotOfItsPoles) {
  // 3t(1−t) is highest in the middle, at 3/4.
  const Box2 box = bounds(Curve2(CubicSpline{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}));
  expect_near(box.lo, {0, 0}, 0.0);
  expect_near(box.hi, {1, 0.75}, 1e-15);
}

RC_GTEST_PROP(Bounds, HoldEveryPointAndAreTouched, ()) {
  const Curve2 c = *any_curve();
  const Box2 box = bounds(c);
  const double noise = 1e-13 * extent(c);
  Box2 seen;
  for (int i = 0; i <= 2004; ++i) {  // among them all joints
    seen.add(point_at(c, i / 2004.0));
  }
  RC_ASSERT((box.lo.array() <= seen.lo.array() + noise).all());
  RC_ASSERT((box.hi.array() >= seen.hi.array() - noise).all());
  RC_ASSERT((seen.lo - box.lo).norm() + (box.hi - seen.hi).norm() <= 1e-3 * extent(c));
}

TEST(Nearest, OfASegmentIsItsFootOrAnEnd) {
  const Segment s{{0, 0}, {10, 0}};
  EXPECT_DOUBLE_EQ(nearest(s, {3, 4}).distance, 4.0);
  EXPECT_DOUBLE_EQ(nearest(s, {3, 4}).t, 0.3);
  EXPECT_DOUBLE_EQ(nearest(s, {13, 4}).distance, 5.0);
  EXPECT_DOUBLE_EQ(nearest(Segment{{1, 1}, {1, 1}}, {4, 5}).distance, 5.0);
}

TEST(Nearest, OfAnArcIsTheRadialPointOrAnEnd) {
  const Arc arc{{0, 0}, 2, -pi / 2, -pi};  // the left half, clockwise
  EXPECT_DOUBLE_EQ(nearest(arc, {-5, 0}).distance, 3.0);
  EXPECT_DOUBLE_EQ(nearest(arc, {-5, 0}).t, 0.5);
  EXPECT_NEAR(nearest(arc, {3, 2}).distance, 3.0, 1e-15);
  EXPECT_DOUBLE_EQ(nearest(arc, {3, 2}).t, 1.0);
  EXPECT_DOUBLE_EQ(nearest(arc, {0, 0}).distance, 2.0);
}

TEST(Nearest, OfASplineIsTheGlobalOneOfSeveral) {
  // A narrow hairpin: both branches are near the axis, the point a little nearer the lower.
  const CubicSpline hairpin{{{0, -1}, {20, -1}, {20, 1}, {0, 1}}};
  const Nearest below = nearest(hairpin, {1, -0.01});
  const Nearest above = nearest(hairpin, {1, 0.01});
  EXPECT_LT(below.t, 0.5);
  EXPECT_GT(above.t, 0.5);
  EXPECT_DOUBLE_EQ(below.distance, above.distance);
}

RC_GTEST_PROP(Nearest, IsNoFartherThanAnySampleAndIsAttained, ()) {
  const Curve2 c = *any_curve();
  const Vec2 p = *test::point_in(-20, 20);
  const Nearest found = nearest(c, p);
  const double noise = 1e-12 * (extent(c) + p.norm());
  RC_ASSERT(std::abs((point_at(c, found.t) - p).norm() - found.distance) <= noise);
  for (int i = 0; i <= 1000; ++i) {
    RC_ASSERT(found.distance <= (point_at(c, i / 1000.0) - p).norm() + noise);
  }
}

RC_GTEST_PROP(Nearest, OfAPointOnTheCurveIsZero, ()) {
  const Curve2 c = *any_curve();
  const double t = *test::number_in(0, 1);
  // Squares of distances cannot tell less than √ε apart from zero; Newton on the curve itself can.
  RC_ASSERT(nearest(c, point_at(c, t)).distance <= 1e-12 * extent(c));
}

TEST(Nearest, IsFastAndRightAtTheCentreOfRoundCurves) {
  // Every point of a circle is nearest to its centre; a spline of quarter circles is out by 2.7e-4.
  const double k = 4.0 / 3.0 * (std::sqrt(2.0) - 1);
  const CubicSpline quarter{{{1, 0}, {1, k}, {k, 1}, {0, 1}}};
  const Nearest found = nearest(quarter, {0, 0});
  EXPECT_NEAR(found.distance, 1.0, 1e-12);
}

}  // namespace
}  // namespace planish::test
