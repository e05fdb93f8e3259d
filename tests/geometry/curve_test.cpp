#include "geometry/random_curves.hpp"

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using test::any_curve;
using test::any_loop;
using test::any_motion;
using test::extent;
using test::scaled;

constexpr double pi = std::numbers::pi;

Loop unit_square() {
  return {Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {1, 1}}, Segment{{1, 1}, {0, 1}},
          Segment{{0, 1}, {0, 0}}};
}

/// y = x³ for x from −1 to 1, as one Bézier piece.
CubicSpline cubic_parabola() { return {{{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}}; }

/// (t², t³) for t from −1 to 1: comes in, stops at a cusp in the origin, goes out.
CubicSpline semicubical() { return {{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}}; }

void expect_near(const Vec2& a, const Vec2& b, double bound) {
  EXPECT_LE((a - b).norm(), bound) << a.transpose() << " and " << b.transpose();
}

TEST(PointAt, EndsOfSegmentsAndSplinesAreExact) {
  const Segment s{{0.1, 0.7}, {1e9 / 3.0, -0.3}};
  EXPECT_EQ(start_of(s), s.a);
  EXPECT_EQ(end_of(s), s.b);
  const CubicSpline c = cubic_parabola();
  EXPECT_EQ(start_of(c), c.poles.front());
  EXPECT_EQ(end_of(c), c.poles.back());
}

TEST(PointAt, ArcTurnsTheWayOfItsSweep) {
  expect_near(point_at(Arc{{1, 2}, 2, 0, pi}, 0.5), {1, 4}, 1e-15);
  expect_near(point_at(Arc{{1, 2}, 2, 0, -pi}, 0.5), {1, 0}, 1e-15);
}

TEST(PointAt, PiecesOfASplineShareTheParameterEqually) {
  const CubicSpline two{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}}};
  expect_near(point_at(two, 0.25), {1.5, 0}, 1e-15);
  expect_near(point_at(two, 0.5), {3, 0}, 0.0);
  expect_near(point_at(two, 0.75), {3, 1.5}, 1e-15);
  expect_near(derivative_at(two, 0.75), {0, 6}, 1e-14);
}

RC_GTEST_PROP(DerivativeAt, IsTheLimitOfDifferences, ()) {
  const Curve2 c = *any_curve();
  const double t = *test::number_in(0.1, 0.9);
  const double h = 1e-5;
  if (const auto* s = std::get_if<CubicSpline>(&c)) {  // random pieces meet in corners
    const double pieces = static_cast<double>(s->poles.size() / 3);
    RC_PRE(std::floor((t - h) * pieces) == std::floor((t + h) * pieces));
  }
  const Vec2 difference = (point_at(c, t + h) - point_at(c, t - h)) / (2 * h);
  // A central difference is off by h²/6 of the third derivative, which is below 10⁴ sizes here.
  RC_ASSERT((difference - derivative_at(c, t)).norm() <= 1e-6 * (1 + extent(c)));
}

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
  // A cusp that is not in the middle of the piece.
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

RC_GTEST_PROP(RigidMotion, MovesEveryPoint, ()) {
  const Curve2 c = *any_curve();
  const Isometry2 motion = *any_motion();
  const double t = *test::number_in(0, 1);
  const Vec2 expected = motion * point_at(c, t);
  RC_ASSERT((point_at(transformed(c, motion), t) - expected).norm() <=
            1e-12 * (extent(c) + expected.norm()));
}

RC_GTEST_PROP(Scaling, TimesTenGivesTenTimesTheLengthAndHundredTimesTheArea, ()) {
  const Loop loop = *any_loop();
  const double scale = extent(loop);
  RC_ASSERT(std::abs(length(scaled(loop, 10)) - 10 * length(loop)) <= 1e-11 * length(loop));
  RC_ASSERT(std::abs(signed_area(scaled(loop, 10)) - 100 * signed_area(loop)) <=
            1e-10 * scale * scale);
}

RC_GTEST_PROP(Reversed, RunsThroughTheSamePointsBackwards, ()) {
  const Curve2 c = *any_curve();
  const double t = *test::number_in(0, 1);
  RC_ASSERT((point_at(reversed(c), 1 - t) - point_at(c, t)).norm() <= 1e-13 * extent(c));
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

RC_GTEST_PROP(Sampled, KeepsTheCurveWithinTheChord, ()) {
  const Curve2 c = *any_curve();
  const double chord = *test::number_in(1e-4, 1.0);
  const std::vector<Vec2> points = sampled(c, chord);
  RC_ASSERT((points.front() - start_of(c)).norm() <= 1e-14 * extent(c));
  RC_ASSERT((points.back() - end_of(c)).norm() <= 1e-14 * extent(c));
  for (int k = 0; k <= 100; ++k) {
    const Vec2 p = point_at(c, k / 100.0);
    double least = (points.front() - p).norm();
    for (std::size_t i = 1; i < points.size(); ++i) {
      least = std::min(least, nearest(Segment{points[i - 1], points[i]}, p).distance);
    }
    RC_ASSERT(least <= chord * (1 + 1e-9));
  }
}

TEST(Sampled, KeepsACircleAPolygonHoweverCoarse) {
  const std::vector<Vec2> ring = sampled(Loop{Arc{{0, 0}, 1, 0, 2 * pi}}, 1000.0);
  EXPECT_EQ(ring.size(), 4u);
}

TEST(Sampled, RepeatsNoCornerOfALoop) { EXPECT_EQ(sampled(unit_square(), 0.1).size(), 4u); }

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

TEST(Crossings, OfASegmentAreItsOneOrNone) {
  const Segment s{{0, -1}, {0, 3}};
  EXPECT_EQ(crossings(s, {5, 0}, {1, 0}), std::vector<double>{0.25});
  EXPECT_TRUE(crossings(s, {5, 4}, {1, 0}).empty());
}

TEST(Crossings, OfACurveOnTheLineAreNone) {
  EXPECT_TRUE(crossings(Segment{{1, 1}, {4, 4}}, {0, 0}, {1, 1}).empty());
  EXPECT_TRUE(crossings(Segment{{0.1, 0.3}, {0.7, 2.1}}, {0, 0}, {1, 3}).empty());
  EXPECT_TRUE(crossings(CubicSpline{{{1, 1}, {2, 2}, {3, 3}, {4, 4}}}, {0, 0}, {1, 1}).empty());
}

TEST(Crossings, OfACircleAreTwo) {
  const std::vector<double> t = crossings(Arc{{0, 0}, 1, 0, 2 * pi}, {0, 0.5}, {1, 0});
  ASSERT_EQ(t.size(), 2u);  // at 30° and 150°
  EXPECT_NEAR(t[0], 1.0 / 12, 1e-15);
  EXPECT_NEAR(t[1], 5.0 / 12, 1e-15);
  EXPECT_TRUE(crossings(Arc{{0, 0}, 1, 0, 2 * pi}, {0, 1.5}, {1, 0}).empty());
}

TEST(Crossings, AtTheEndOfAnArcAreFound) {
  const std::vector<double> t = crossings(Arc{{0, 0}, 1, 0, pi / 2}, {-3, 0}, {1, 0});
  ASSERT_EQ(t.size(), 1u);
  EXPECT_EQ(t[0], 0.0);
}

TEST(Crossings, OfACubicAreItsThreeRoots) {
  // y = x³ meets y = x/4 at −1/2, 0, 1/2; x runs evenly from −1 to 1.
  const std::vector<double> t = crossings(cubic_parabola(), {0, 0}, {4, 1});
  ASSERT_EQ(t.size(), 3u);
  EXPECT_NEAR(t[0], 0.25, 1e-15);
  EXPECT_NEAR(t[1], 0.5, 1e-15);
  EXPECT_NEAR(t[2], 0.75, 1e-15);
}

TEST(Crossings, AtAJointOfASplineIsOne) {
  const CubicSpline s{{{-3, 1}, {-2, 1}, {-1, 0}, {0, 0}, {1, 0}, {2, -1}, {3, -1}}};
  EXPECT_EQ(crossings(s, {0, 5}, {0, 1}), std::vector<double>{0.5});
}

RC_GTEST_PROP(Crossings, LieOnTheLineAndSeparateItsSides, ()) {
  const Curve2 c = *any_curve();
  const Vec2 origin = *test::point_in(-10, 10);
  const double angle = *test::number_in(0, 2 * pi);
  const Vec2 u(std::cos(angle), std::sin(angle));
  const auto height = [&](double t) {
    const Vec2 d = point_at(c, t) - origin;
    return u.x() * d.y() - u.y() * d.x();
  };
  std::vector<double> ts = crossings(c, origin, u);
  const double noise = 1e-11 * (extent(c) + origin.norm());
  double last = 0.0;
  for (const double t : ts) {
    RC_ASSERT(t >= last);
    RC_ASSERT(t <= 1.0);
    RC_ASSERT(std::abs(height(t)) <= noise);
    last = t;
  }
  ts.push_back(1.0);
  double from = 0.0;
  for (const double to : ts) {  // between two crossings the curve stays on one side
    double lowest = 0.0;
    double highest = 0.0;
    for (int i = 0; i <= 20; ++i) {
      const double h = height(from + (to - from) * i / 20.0);
      lowest = std::min(lowest, h);
      highest = std::max(highest, h);
    }
    RC_ASSERT(lowest >= -noise || highest <= noise);
    from = to;
  }
}

RC_GTEST_PROP(Trimmed, PartsMeetAndAddUp, ()) {
  const Curve2 c = *any_curve();
  const double t = *test::number_in(0.01, 0.99);
  const Curve2 left = trimmed(c, 0, t);
  const Curve2 right = trimmed(c, t, 1);
  const double noise = 1e-13 * extent(c);
  RC_ASSERT((start_of(left) - start_of(c)).norm() <= noise);
  RC_ASSERT((end_of(right) - end_of(c)).norm() <= noise);
  RC_ASSERT((end_of(left) - point_at(c, t)).norm() <= noise);
  RC_ASSERT((start_of(right) - point_at(c, t)).norm() <= noise);
  RC_ASSERT(std::abs(length(left) + length(right) - length(c)) <= 1e-11 * length(c));
}

TEST(Trimmed, AtJointsOfASplineLeavesWholePieces) {
  const CubicSpline three{
      {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, -1}, {5, -1}, {6, 0}, {7, 1}, {8, 1}, {9, 0}}};
  const auto middle = std::get<CubicSpline>(trimmed(three, 1.0 / 3, 2.0 / 3));
  ASSERT_EQ(middle.poles.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(middle.poles[i], three.poles[3 + i]);
}

TEST(Frames, AreOrthonormalAndRightHanded) {
  for (const Vec3& z : {Vec3(0, 0, 2), Vec3(1e-9, 0, 0), Vec3(-3, 4, 12), Vec3(1e200, 1e200, 0)}) {
    const Frame f = frame_from_normal({1, 2, 3}, z);
    EXPECT_NEAR(f.z.dot(z.stableNormalized()), 1.0, 1e-15);
    EXPECT_NEAR((f.x.cross(f.y) - f.z).norm(), 0.0, 1e-15);
    EXPECT_NEAR(f.x.norm(), 1.0, 1e-15);
    EXPECT_NEAR(f.x.dot(f.z), 0.0, 1e-15);
  }
}

TEST(Frames, FollowTheHintForX) {
  const Frame f = frame_from_axes(Vec3::Zero(), {0, 0, 1}, {3, 0, 100});
  EXPECT_NEAR((f.x - Vec3::UnitX()).norm(), 0.0, 1e-14);
  // A hint only 1e-9 off the axis still gives a right angle.
  const Frame g = frame_from_axes(Vec3::Zero(), {1, 2, 3}, Vec3(1, 2, 3) + 1e-9 * Vec3(0, 0, 1));
  EXPECT_NEAR(g.x.dot(g.z), 0.0, 1e-15);
}

}  // namespace
}  // namespace planish
