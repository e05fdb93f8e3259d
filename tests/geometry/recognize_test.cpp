#include "geometry/comparisons.hpp"
#include "geometry/random_curves.hpp"

#include <planish/geometry/fit.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

TEST(Recognized, FindsALineRunThroughUnevenly) {
  const CubicSpline s{{{0, 0}, {1, 2}, {1.5, 3}, {10, 20}}};
  const Curve2 found = recognized(s, 1e-9);
  ASSERT_TRUE(std::holds_alternative<Segment>(found));
  EXPECT_EQ(start_of(found), s.poles.front());
  EXPECT_EQ(end_of(found), s.poles.back());
}

TEST(Recognized, HoldsALineToTheTolerance) {
  // Poles at height 4/3 h lift the middle to h.
  const double h = 0.01;
  const CubicSpline s{{{0, 0}, {10, 4.0 / 3 * h}, {20, -4.0 / 3 * h}, {30, 0}}};
  // Here of both signs: 4h t(1−t)(1−2t), at most 4h/(6√3) = 2h/(3√3).
  const double height = 2 * h / (3 * std::sqrt(3.0));
  EXPECT_TRUE(std::holds_alternative<Segment>(recognized(s, height * (1 + 1e-9))));
  EXPECT_FALSE(std::holds_alternative<Segment>(recognized(s, height * (1 - 1e-9))));
}

TEST(Recognized, CountsWhatIsBeyondAndAsideTogether) {
  // Runs 0.24 past its end while up to 0.24 aside of the line: 0.34 away from it at most.
  const CubicSpline s{{{0, 0}, {10, 0.32}, {10.96, 0.32}, {10, 0}}};
  const Curve2 found = recognized(s, 0.3);
  EXPECT_LE(farthest({s}, {found}, 2000), 0.3);
}

TEST(Recognized, DoesNotTakeDoublingBackForALine) {
  const CubicSpline overshoots{{{0, 0}, {20, 0}, {20, 0}, {10, 0}}};
  EXPECT_TRUE(std::holds_alternative<CubicSpline>(recognized(overshoots, 1e-3)));
  const CubicSpline starts_back{{{0, 0}, {-1, 0}, {5, 0}, {10, 0}}};
  EXPECT_TRUE(std::holds_alternative<CubicSpline>(recognized(starts_back, 1e-3)));
  const CubicSpline hook{{{0, 0}, {3, 0}, {6, 0}, {9, 0}, {9.5, 0}, {9.5, 0}, {8.9, 0}}};
  EXPECT_TRUE(std::holds_alternative<CubicSpline>(recognized(hook, 1e-3)));
}

RC_GTEST_PROP(Recognized, FindsArcs, ()) {
  const double r = *number_in(0.5, 200);
  const double start = *number_in(-4, 4);
  const double sweep = *number_in(0.1, 6.2) * *rc::gen::element(-1.0, 1.0);
  const Isometry2 motion = *any_motion();
  const FitReport fit = fit_cubics(ellipse(r, r), start, start + sweep, 1e-7);
  CubicSpline spline = fit.spline;
  for (Vec2& pole : spline.poles)
    pole = motion * pole;
  const double sense = motion.linear().determinant();
  const Curve2 found = recognized(spline, 1e-6);
  // What a millionth of a millimetre does not tell from a chord is one.
  if (r * (1 - std::cos(sweep / 2)) < 2e-6) return;
  RC_ASSERT(std::holds_alternative<Arc>(found));
  const Arc& arc = std::get<Arc>(found);
  RC_ASSERT(arc.sweep * sense * sweep > 0.0);
  // Ends: only the rounding of an arc with this radius.
  const double noise = 1e-12 * (extent(spline) + arc.radius);
  RC_ASSERT((start_of(found) - spline.poles.front()).norm() <= noise);
  RC_ASSERT((end_of(found) - spline.poles.back()).norm() <= noise);
  RC_ASSERT(farthest({found}, {spline}, 200) <= 1e-6);
  RC_ASSERT(farthest({spline}, {found}, 200) <= 1e-6);
}

TEST(Recognized, FindsFullCircles) {
  for (const double sense : {1.0, -1.0}) {
    const FitReport fit = fit_cubics(ellipse(7, 7), 1.0, 1.0 + sense * 2 * pi, 1e-6);
    const Curve2 found = recognized(fit.spline, 1e-5);
    ASSERT_TRUE(std::holds_alternative<Arc>(found));
    const Arc& arc = std::get<Arc>(found);
    EXPECT_EQ(arc.sweep, sense * 2 * pi);
    EXPECT_NEAR(arc.radius, 7.0, 1e-6);
    EXPECT_LE(arc.center.norm(), 1e-6);
    EXPECT_LE((start_of(found) - fit.spline.poles.front()).norm(), 1e-14);
  }
}

TEST(Recognized, LeavesWhatIsNotAnArc) {
  const auto leaves = [](const CurveFunction& f, double t0, double t1) {
    const FitReport fit = fit_cubics(f, t0, t1, 1e-7);
    return std::holds_alternative<CubicSpline>(recognized(fit.spline, 1e-3));
  };
  EXPECT_TRUE(leaves(ellipse(10, 9.99), 0, 2 * pi));
  EXPECT_TRUE(leaves(ellipse(10, 10), 0, 4 * pi)) << "twice round";
  EXPECT_TRUE(leaves(ellipse(10, 10), 0, 3 * pi)) << "one and a half times round";
  const auto to_and_fro = on_circle(
      10, [](double t) { return std::sin(t); }, [](double t) { return std::cos(t); });
  EXPECT_TRUE(leaves(to_and_fro, 0, 2.5));
}

}  // namespace
}  // namespace planish::test
