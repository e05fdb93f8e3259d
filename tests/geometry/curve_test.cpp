#include "geometry/random_curves.hpp"
#include "geometry/sample_curves.hpp"

#include <planish/geometry/curve.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

/// y = x³ for x from −1 to 1, as one Bézier span.
CubicSpline cubic_parabola() { return {{{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}}; }

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
  if (const auto* s = std::get_if<CubicSpline>(&c)) {  // random spans meet in corners
    const double spans = static_cast<double>(s->poles.size() / 3);
    RC_PRE(std::floor((t - h) * spans) == std::floor((t + h) * spans));
  }
  const Vec2 difference = (point_at(c, t + h) - point_at(c, t - h)) / (2 * h);
  // A central difference is off by h²/6 of the third derivative, which is below 10⁴ sizes here.
  RC_ASSERT((difference - derivative_at(c, t)).norm() <= 1e-6 * (1 + extent(c)));
}

RC_GTEST_PROP(RigidMotion, MovesEveryPoint, ()) {
  const Curve2 c = *any_curve();
  const Isometry2 motion = *any_motion();
  const double t = *test::number_in(0, 1);
  const Vec2 expected = motion * point_at(c, t);
  RC_ASSERT((point_at(transformed(c, motion), t) - expected).norm() <=
            1e-12 * (extent(c) + expected.norm()));
}

RC_GTEST_PROP(Scaled, MovesEveryPointAwayFromTheMiddle, ()) {
  const Curve2 c = *any_curve();
  const Vec2 about = *point_in(-100, 100);
  const double factor = *test::number_in(0.01, 100), t = *test::number_in(0, 1);
  const Vec2 expected = about + factor * (point_at(c, t) - about);
  RC_ASSERT((point_at(scaled(c, factor, about), t) - expected).norm() <=
            1e-12 * (factor * (extent(c) + about.norm()) + expected.norm()));
}

RC_GTEST_PROP(Reversed, RunsThroughTheSamePointsBackwards, ()) {
  const Curve2 c = *any_curve();
  const double t = *test::number_in(0, 1);
  RC_ASSERT((point_at(reversed(c), 1 - t) - point_at(c, t)).norm() <= 1e-13 * extent(c));
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

TEST(IsRegular, HoldsOfCurvesThatEveryFunctionCanTake) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const Curve2& sound :
       {Curve2(Segment{{0, 0}, {1, 2}}), Curve2(Arc{{1, 2}, 3.0, -1.0, 2.0 * pi}),
        Curve2(Arc{{0, 1e9}, 1e9, -pi / 2, 1e-6}),
        Curve2(CubicSpline{{{0, 0}, {1, 0}, {2, 1}, {3, 1}}})})
    EXPECT_TRUE(is_regular(sound));
  for (const Curve2& broken :
       {Curve2(Segment{{0, nan}, {1, 2}}), Curve2(Segment{{0, 0}, {1e8, 0}}),
        Curve2(Arc{{0, 0}, 0.0, 0.0, 1.0}), Curve2(Arc{{0, 0}, -1.0, 0.0, 1.0}),
        Curve2(Arc{{0, 0}, 1.0, 0.0, 6.3}), Curve2(Arc{{0, 0}, 1.0, 0.0, -1e9}),
        Curve2(Arc{{0, 0}, 1.0, 1e300, 1.0}), Curve2(Arc{{0, 0}, 1.0, nan, 1.0}),
        Curve2(Arc{{0, 0}, 1.0, 0.0, nan}), Curve2(Arc{{0, inf}, 1.0, 0.0, 1.0}),
        Curve2(Arc{{0, 0}, inf, 0.0, 1.0}), Curve2(CubicSpline{}),
        Curve2(CubicSpline{{{0, 0}, {1, 1}}}),
        Curve2(CubicSpline{{{0, 0}, {1, 0}, {1e200, 0}, {3, 0}}})})
    EXPECT_FALSE(is_regular(broken));
  EXPECT_FALSE(is_regular(Loop{Segment{{0, 0}, {1, 0}}, CubicSpline{}}));
}

TEST(AnArcThatTurnsWithoutEnd, StopsAtAnAssertion) {
  for (const Arc& arc : {Arc{{0, 0}, 1.0, 1e300, 1.0}, Arc{{0, 0}, 1.0, 0.0, 1e9},
                         Arc{{0, 0}, 1.0, 0.0, std::nan("")}})
    EXPECT_DEATH((void)bounds(Curve2(arc)), "is_turn");
}

TEST(ASplineWithoutPoles, StopsAtAnAssertion) {
  const Curve2 none = CubicSpline{};
  EXPECT_DEATH((void)bounds(none), "poles");
  EXPECT_DEATH((void)sampled(none, 0.1), "poles");
}

}  // namespace
}  // namespace planish::test
