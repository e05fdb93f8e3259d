#include "geometry/random_curves.hpp"

#include <planish/geometry/fit.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using test::any_motion;
using test::extent;
using test::number_in;
using test::scaled;

constexpr double pi = std::numbers::pi;

CurveFunction ellipse(double a, double b) {
  return [a, b](double t) {
    return CurveSample{{a * std::cos(t), b * std::sin(t)}, {-a * std::sin(t), b * std::cos(t)}};
  };
}

/// A circle of radius r run through with the angle φ(t).
CurveFunction on_circle(double r, std::function<double(double)> angle,
                        std::function<double(double)> speed) {
  return [=](double t) {
    const Vec2 u(std::cos(angle(t)), std::sin(angle(t)));
    return CurveSample{r * u, r * speed(t) * Vec2(-u.y(), u.x())};
  };
}

std::size_t pieces_of(const CubicSpline& s) { return s.poles.size() / 3; }

/// Farthest that points along `from` are off the nearest of `curves`.
double farthest(const std::vector<Curve2>& from, const std::vector<Curve2>& curves, int samples) {
  double worst = 0.0;
  for (const Curve2& c : from) {
    for (int i = 0; i <= samples; ++i) {
      const Vec2 p = point_at(c, i / static_cast<double>(samples));
      double least = (start_of(curves.front()) - p).norm();
      for (const Curve2& other : curves)
        least = std::min(least, nearest(other, p).distance);
      worst = std::max(worst, least);
    }
  }
  return worst;
}

double angle_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

double worst_gap(const Loop& loop) {
  double worst = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 gap = end_of(loop[i]) - start_of(loop[(i + 1) % loop.size()]);
    worst = std::max(worst, gap.norm());
  }
  return worst;
}

Loop polygon(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  }
  return loop;
}

/// Every curve cut into `n` parts.
Loop cut_up(const Loop& loop, int n) {
  Loop made;
  for (const Curve2& c : loop) {
    for (int i = 0; i < n; ++i)
      made.push_back(trimmed(c, i / double(n), (i + 1) / double(n)));
  }
  return made;
}

/// A slot: two straight sides 40 long, two half circles of radius 5, counter-clockwise.
Loop slot() {
  return {Segment{{-20, -5}, {20, -5}}, Arc{{20, 0}, 5, -pi / 2, pi}, Segment{{20, 5}, {-20, 5}},
          Arc{{-20, 0}, 5, pi / 2, pi}};
}

TEST(FitCubics, KeepsTheTolerance) {
  for (const double tolerance : {1e-1, 1e-3, 1e-6, 1e-9}) {
    const FitReport fit = fit_cubics(ellipse(1, 1), 0.3, 6.0, tolerance);
    EXPECT_LE(fit.deviation, tolerance);
    double worst = 0.0;
    for (int i = 0; i <= 5000; ++i) {
      worst = std::max(worst, std::abs(point_at(fit.spline, i / 5000.0).norm() - 1.0));
    }
    EXPECT_LE(worst, tolerance);
  }
}

TEST(FitCubics, IsOfFourthOrder) {
  // A Hermite piece over the angle h is off by h⁴/384 at most, and halving overshoots by up to two.
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const FitReport fit = fit_cubics(ellipse(1, 1), 0, 2 * pi, tolerance);
    const double needed = 2 * pi / std::pow(384 * tolerance, 0.25);
    EXPECT_LE(static_cast<double>(pieces_of(fit.spline)), 2 * needed + 1);
  }
}

TEST(FitCubics, MeetsTheEndsExactlyAndIsTangentContinuous) {
  const CurveFunction f = ellipse(30, 7);
  const FitReport fit = fit_cubics(f, 0.1, 2.5, 1e-5);
  EXPECT_EQ(fit.spline.poles.front(), f(0.1).point);
  EXPECT_EQ(fit.spline.poles.back(), f(2.5).point);
  ASSERT_GT(pieces_of(fit.spline), 2u);
  for (std::size_t i = 3; i + 1 < fit.spline.poles.size(); i += 3) {
    const Vec2 before = fit.spline.poles[i] - fit.spline.poles[i - 1];
    const Vec2 after = fit.spline.poles[i + 1] - fit.spline.poles[i];
    EXPECT_LE(angle_between(before, after), 1e-12);
  }
}

TEST(FitCubics, ReproducesACubicInOnePiece) {
  const auto cubic = [](double t) { return CurveSample{{t, t * t * t}, {1, 3 * t * t}}; };
  const FitReport fit = fit_cubics(cubic, -1, 2, 1e-12);
  EXPECT_EQ(pieces_of(fit.spline), 1u);
  EXPECT_LE(fit.deviation, 1e-14);
}

TEST(FitCubics, RunsBackwardsToo) {
  const FitReport fit = fit_cubics(ellipse(3, 2), 2.0, 0.0, 1e-6);
  EXPECT_EQ(fit.spline.poles.front(), ellipse(3, 2)(2.0).point);
  EXPECT_LE(fit.deviation, 1e-6);
  EXPECT_LT(derivative_at(fit.spline, 1.0).y(), 0.0);  // downwards through (3, 0)
}

TEST(FitCubics, DoesNotDependOnTheScale) {
  const auto scaled_by = [](double s) {
    return [s](double t) {
      const CurveSample e = ellipse(3, 1)(t);
      return CurveSample{s * e.point, s * e.derivative};
    };
  };
  const std::size_t usual = pieces_of(fit_cubics(ellipse(3, 1), 0, 5, 1e-6).spline);
  EXPECT_EQ(pieces_of(fit_cubics(scaled_by(0x1p40), 0, 5, 0x1p40 * 1e-6).spline), usual);
  EXPECT_EQ(pieces_of(fit_cubics(scaled_by(0x1p-40), 0, 5, 0x1p-40 * 1e-6).spline), usual);
}

TEST(FitCubics, DoesNotDoubleBackWhereSpeedVaries) {
  // Straight, and fifteen times as fast at the ends as on average.
  const auto uneven = [](double t) {
    const double u = 2 * t - 1;
    return CurveSample{{std::pow(u, 15.0), 0}, {30 * std::pow(u, 14.0), 0}};
  };
  const FitReport fit = fit_cubics(uneven, 0, 1, 1e-6);
  EXPECT_LE(fit.deviation, 1e-6);
  EXPECT_NEAR(length(Curve2(fit.spline)), 2.0, 1e-6);
}

TEST(FitCubics, FindsTheTangentWhereTheFunctionStandsStill) {
  // Stops at both ends: the angle is t²(3 − 2t) times a right angle.
  const auto f = on_circle(
      10, [](double t) { return pi / 2 * t * t * (3 - 2 * t); },
      [](double t) { return pi * 3 * t * (1 - t); });
  const FitReport fit = fit_cubics(f, 0, 1, 1e-4);
  EXPECT_LE(fit.deviation, 1e-4);
  EXPECT_LE(angle_between(derivative_at(fit.spline, 0), {0, 1}), 1e-4);
  EXPECT_LE(angle_between(derivative_at(fit.spline, 1), {-1, 0}), 1e-4);
  for (int i = 0; i <= 1000; ++i)
    EXPECT_NEAR(point_at(fit.spline, i / 1000.0).norm(), 10, 1e-4);
}

TEST(FitCubics, PassesAPlaceWhereTheFunctionStandsStill) {
  const auto f = on_circle(
      10, [](double t) { return t * t * t; }, [](double t) { return 3 * t * t; });
  const FitReport fit = fit_cubics(f, -1, 1, 1e-4);
  EXPECT_LE(fit.deviation, 1e-4);
  EXPECT_LE(pieces_of(fit.spline), 64u);
  for (std::size_t i = 3; i + 1 < fit.spline.poles.size(); i += 3) {
    const Vec2 before = fit.spline.poles[i] - fit.spline.poles[i - 1];
    const Vec2 after = fit.spline.poles[i + 1] - fit.spline.poles[i];
    EXPECT_LE(angle_between(before, after), 1e-6);
  }
}

TEST(FitCubics, NarrowsDownOnACusp) {
  const auto cycloid = [](double t) {
    return CurveSample{{t - std::sin(t), 1 - std::cos(t)}, {1 - std::cos(t), std::sin(t)}};
  };
  for (const double from : {-pi, -2.0}) {
    const FitReport fit = fit_cubics(cycloid, from, pi, 1e-5);
    EXPECT_LE(fit.deviation, 1e-5);
    EXPECT_LE(pieces_of(fit.spline), 200u);
  }
}

TEST(FitCubics, TellsTheDeviationOfWhatCannotBeFitted) {
  const auto noise = [](double t) { return CurveSample{{t, std::sin(1e9 * t)}, {1, 0}}; };
  const FitReport rough = fit_cubics(noise, 0, 1, 1e-6);
  EXPECT_GT(rough.deviation, 1e-6);
  EXPECT_EQ(pieces_of(rough.spline), 4096u);
}

TEST(FitCubics, OfAPointIsThatPoint) {
  const auto still = [](double) { return CurveSample{{2, 3}, {0, 0}}; };
  const FitReport fit = fit_cubics(still, 0, 1, 1e-9);
  EXPECT_LE(fit.deviation, 1e-15);
  for (const Vec2& pole : fit.spline.poles)
    EXPECT_EQ(pole, Vec2(2, 3));
}

TEST(FitCubicsOnSurface, HoldsWhatIsMeasuredAlongRulings) {
  // On a cylinder of 200 mm radius a step of u is 200 mm long, and an oblique cut rises by as much.
  constexpr double kRadius = 200.0, kTolerance = 1e-7;
  const auto cut = [](double u) {
    return CurveSample{{u, kRadius * std::sin(u)}, {1.0, kRadius * std::cos(u)}};
  };
  const CubicSpline spline = fit_cubics_on_surface(cut, 0.0, 2.0, kRadius, kTolerance);
  for (int i = 0; i <= 1000; ++i) {
    const Vec2 p = point_at(spline, i / 1000.0);
    EXPECT_NEAR(p.y(), kRadius * std::sin(p.x()), 2.0 * kTolerance);
  }
}

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

TEST(Recognized, LeavesWhatIsNoArc) {
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

TEST(ToArcs, PassesSegmentsAndArcsUnchanged) {
  const std::vector<Curve2> segment = to_arcs(Segment{{0, 0}, {1, 2}}, 0.1);
  ASSERT_EQ(segment.size(), 1u);
  EXPECT_EQ(std::get<Segment>(segment[0]).b, Vec2(1, 2));
  const std::vector<Curve2> arc = to_arcs(Arc{{1, 2}, 3, 4, 5}, 0.1);
  ASSERT_EQ(arc.size(), 1u);
  EXPECT_EQ(std::get<Arc>(arc[0]).sweep, 5.0);
}

/// What to_arcs promises, at every tolerance.
void expect_good_arcs(const CubicSpline& spline, double tolerance) {
  SCOPED_TRACE(tolerance);
  const std::vector<Curve2> arcs = to_arcs(spline, tolerance);
  ASSERT_FALSE(arcs.empty());
  double largest_radius = 0.0;
  for (const Curve2& c : arcs) {
    EXPECT_FALSE(std::holds_alternative<CubicSpline>(c));
    if (const Arc* a = std::get_if<Arc>(&c)) largest_radius = std::max(largest_radius, a->radius);
  }
  const double noise = 1e-14 * (extent(spline) + largest_radius);
  EXPECT_LE((start_of(arcs.front()) - spline.poles.front()).norm(), noise);
  EXPECT_LE((end_of(arcs.back()) - spline.poles.back()).norm(), noise);
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    EXPECT_LE((end_of(arcs[i - 1]) - start_of(arcs[i])).norm(), noise);
    EXPECT_LE(angle_between(derivative_at(arcs[i - 1], 1), derivative_at(arcs[i], 0)), 1.1e-5);
  }
  EXPECT_LE(farthest(arcs, {spline}, 50), tolerance);
  EXPECT_LE(farthest({spline}, arcs, 500), tolerance);
}

TEST(ToArcs, KeepsToleranceEndsAndTangents) {
  const auto spiral = [](double t) {
    const Vec2 u(std::cos(t), std::sin(t));
    return CurveSample{t * u, u + t * Vec2(-u.y(), u.x())};
  };
  const auto wave = [](double t) {
    return CurveSample{{t, 3 * std::sin(t)}, {1, 3 * std::cos(t)}};
  };
  for (const double tolerance : {0.5, 0.05, 0.005, 0.0005}) {
    expect_good_arcs(fit_cubics(ellipse(50, 20), 0.2, 6.0, tolerance / 10).spline, tolerance);
    expect_good_arcs(fit_cubics(ellipse(50, 20), 0, 2 * pi, tolerance / 10).spline, tolerance);
    expect_good_arcs(fit_cubics(spiral, 1, 15, tolerance / 10).spline, tolerance);
    expect_good_arcs(fit_cubics(wave, 0, 12, tolerance / 10).spline, tolerance);
  }
}

RC_GTEST_PROP(ToArcs, KeepsToleranceAndEndsOfAnyPiece, ()) {
  CubicSpline s;
  for (int i = 0; i < 4; ++i)
    s.poles.push_back(*test::point_in(-10, 10));
  const double tolerance = *rc::gen::element(0.3, 0.03, 0.003);
  const std::vector<Curve2> arcs = to_arcs(s, tolerance);
  double largest_radius = 0.0;
  for (const Curve2& c : arcs) {
    if (const Arc* a = std::get_if<Arc>(&c)) largest_radius = std::max(largest_radius, a->radius);
  }
  const double noise = 1e-14 * (extent(s) + largest_radius);
  RC_ASSERT((start_of(arcs.front()) - s.poles.front()).norm() <= noise);
  RC_ASSERT((end_of(arcs.back()) - s.poles.back()).norm() <= noise);
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    RC_ASSERT((end_of(arcs[i - 1]) - start_of(arcs[i])).norm() <= noise);
  }
  RC_ASSERT(farthest(arcs, {s}, 30) <= tolerance);
  RC_ASSERT(farthest({s}, arcs, 300) <= tolerance);
}

TEST(ToArcs, NeedsFewArcs) {
  // A biarc over the length L of a curve whose curvature changes at the rate κ' is off by
  // κ' L³ / 324 (the even split of a clothoid), so ∫ (κ' / (324 tol))^⅓ ds biarcs are needed.
  const double a = 100;
  const double b = 50;
  const double tolerance = 0.01;
  const CubicSpline spline = fit_cubics(ellipse(a, b), 0, 2 * pi, tolerance / 100).spline;
  double needed = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * 2 * pi / n;
    const double speed2 = a * a * std::pow(std::sin(t), 2) + b * b * std::pow(std::cos(t), 2);
    const double rate = 3 * a * b * (a * a - b * b) * std::abs(std::sin(t) * std::cos(t)) /
                        std::pow(speed2, 3);
    needed += std::cbrt(rate / (324 * tolerance)) * std::sqrt(speed2) * 2 * pi / n;
  }
  const auto arcs = static_cast<double>(to_arcs(spline, tolerance).size());
  EXPECT_LE(arcs, 2 * (1.25 * needed + 1));
}

TEST(ToArcs, KeepsCornersAndStraightParts) {
  // Straight, corner, straight, then a quarter circle that leaves it smoothly.
  const double k = 4.0 / 3 * (std::sqrt(2.0) - 1);
  const CubicSpline s{
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {3, 3 + k}, {4 - k, 4}, {4, 4}}};
  const std::vector<Curve2> arcs = to_arcs(s, 1e-3);
  ASSERT_GE(arcs.size(), 2u);
  ASSERT_TRUE(std::holds_alternative<Segment>(arcs[0]));
  EXPECT_EQ(end_of(arcs[0]), Vec2(3, 0));
  EXPECT_EQ(start_of(arcs[1]), Vec2(3, 0));
  EXPECT_LE(farthest(arcs, {s}, 50), 1e-3);
  EXPECT_LE(arcs.size(), 7u);
}

TEST(ToArcs, SurvivesCuspsAndPoints) {
  const CubicSpline cusp{{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}};
  const std::vector<Curve2> arcs = to_arcs(cusp, 1e-3);
  EXPECT_LE(farthest(arcs, {cusp}, 50), 1e-3);
  EXPECT_LE(farthest({cusp}, arcs, 500), 1e-3);
  EXPECT_LE(arcs.size(), 60u);
  EXPECT_EQ(to_arcs(CubicSpline{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, 1e-3).size(), 1u);
}

TEST(Merged, JoinsPartsOfALineAndTellsWhereTheyBegan) {
  const Loop square = cut_up(polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 3);
  const MergedLoop found = merged(square, 1e-6);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 3, 6, 9}));
  EXPECT_DOUBLE_EQ(signed_area(found.loop), 100.0);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, JoinsAcrossTheStart) {
  Loop square = cut_up(polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 3);
  std::rotate(square.begin(), square.begin() + 1, square.end());  // begins within the first side
  const MergedLoop found = merged(square, 1e-6);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{11, 2, 5, 8}));
  EXPECT_DOUBLE_EQ(signed_area(found.loop), 100.0);
}

TEST(Merged, MakesOneCircleOfItsPieces) {
  for (const double sense : {1.0, -1.0}) {
    const Loop pieces = cut_up({Arc{{3, 4}, 5, 0.7, sense * 2 * pi}}, 7);
    const MergedLoop found = merged(pieces, 1e-6);
    ASSERT_EQ(found.loop.size(), 1u);
    const Arc& arc = std::get<Arc>(found.loop[0]);
    EXPECT_EQ(arc.sweep, sense * 2 * pi);
    EXPECT_EQ(arc.radius, 5.0);
    EXPECT_EQ(arc.center, Vec2(3, 4));
    EXPECT_EQ(found.first_input, std::vector<int>{0});
  }
}

TEST(Merged, MakesOneCircleOfInaccuratePieces) {
  Loop pieces = cut_up({Arc{{3, 4}, 5, 0.7, 2 * pi}}, 4);
  std::get<Arc>(pieces[1]).center += Vec2(2e-5, -1e-5);
  std::get<Arc>(pieces[2]).radius += 2e-5;
  const MergedLoop found = merged(pieces, 1e-4);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_NEAR(std::get<Arc>(found.loop[0]).radius, 5, 1e-4);
}

TEST(Merged, LeavesALoopThatIsSimpleAlready) {
  const MergedLoop found = merged(slot(), 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(std::get<Arc>(found.loop[1]).radius, 5.0);
  EXPECT_NEAR(signed_area(found.loop), 400 + 25 * pi, 1e-11);
}

RC_GTEST_PROP(Merged, FindsASlotAgainHoweverCutMovedAndStarted, ()) {
  const Isometry2 motion = *any_motion();
  Loop pieces = transformed(cut_up(slot(), *rc::gen::inRange(1, 12)), motion);
  if (*rc::gen::arbitrary<bool>()) pieces = reversed(pieces);
  const auto shift = *rc::gen::inRange<std::size_t>(0, pieces.size());
  std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(shift), pieces.end());
  const MergedLoop found = merged(pieces, 1e-6);
  RC_ASSERT(found.loop.size() == 4u);
  RC_ASSERT(std::abs(signed_area(found.loop) - signed_area(pieces)) <= 1e-9);
  RC_ASSERT(std::abs(length(found.loop) - (80 + 10 * pi)) <= 1e-9);
  RC_ASSERT(worst_gap(found.loop) <= 1e-12 * 300);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 begins = start_of(pieces[found.first_input[i]]);
    RC_ASSERT((start_of(found.loop[i]) - begins).norm() <= 1e-9);
  }
}

TEST(Merged, DoesNotJoinArcsThatTurnApart) {
  // An S of two arcs with one radius, and its way back.
  const Loop loop{Arc{{0, 0}, 1, pi, pi}, Arc{{2, 0}, 1, pi, -pi}, Segment{{3, 0}, {3, 5}},
                  Segment{{3, 5}, {-1, 5}}, Segment{{-1, 5}, {-1, 0}}};
  EXPECT_EQ(merged(loop, 1e-3).loop.size(), 5u);
}

TEST(Merged, KeepsASpike) {
  const Loop spike = polygon({{0, 0}, {10, 0}, {10, 5}, {10, -3}, {10, 10}, {0, 10}});
  EXPECT_EQ(merged(spike, 1e-3).loop.size(), 6u);
}

TEST(Merged, AbsorbsAShortChamferInTheCorner) {
  const Loop chamfered = polygon({{0, 0}, {10 - 2e-4, 0}, {10, 2e-4}, {10, 10}, {0, 10}});
  const MergedLoop found = merged(chamfered, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
  EXPECT_EQ(found.first_input, (std::vector<int>{0, 2, 3, 4}));
  EXPECT_LE((end_of(found.loop[0]) - Vec2(10, 0)).norm(), 1e-12);  // both sides keep their lines
}

TEST(Merged, AbsorbsAShortCurveAtTheStartOfTheLoop) {
  const Loop chamfered = polygon({{0, 2e-4}, {2e-4, 0}, {10, 0}, {10, 10}, {0, 10}});
  const MergedLoop found = merged(chamfered, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(found.first_input, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, AbsorbsAShortCurveBesideAnArcWithoutMovingTheArc) {
  Loop loop = slot();
  loop[0] = Segment{{-20, -5}, {20 - 3e-4, -5.0002}};
  loop.insert(loop.begin() + 1, Segment{{20 - 3e-4, -5.0002}, {20, -5}});
  const MergedLoop found = merged(loop, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_EQ(std::get<Arc>(found.loop[1]).center, Vec2(20, 0));
  EXPECT_EQ(std::get<Arc>(found.loop[1]).radius, 5.0);
  EXPECT_LE(worst_gap(found.loop), 1e-14);
}

TEST(Merged, ClosesACircleThatLacksLessThanTheTolerance) {
  const Arc almost{{0, 0}, 10, 0, 2 * pi - 5e-5};
  const MergedLoop found = merged({almost, Segment{end_of(almost), start_of(almost)}}, 1e-3);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).radius, 10.0);
}

TEST(Merged, KeepsASliver) {
  EXPECT_EQ(merged(polygon({{0, 0}, {100, 0}, {100, 5e-4}}), 1e-3).loop.size(), 3u);
}

TEST(Merged, OfNothingIsNothing) { EXPECT_TRUE(merged({}, 1e-3).loop.empty()); }

TEST(Merged, RecognisesSplinesAndJoinsThem) {
  // A circle of radius 8 as four splines.
  Loop loop;
  for (int i = 0; i < 4; ++i) {
    loop.push_back(fit_cubics(ellipse(8, 8), i * pi / 2, (i + 1) * pi / 2, 1e-6).spline);
  }
  const MergedLoop found = merged(loop, 1e-4);
  ASSERT_EQ(found.loop.size(), 1u);
  EXPECT_EQ(std::get<Arc>(found.loop[0]).sweep, 2 * pi);
  EXPECT_NEAR(std::get<Arc>(found.loop[0]).radius, 8, 1e-5);
}

TEST(Merged, ThinsAChainOfShortCurvesWithoutLosingIt) {
  // A circle of radius 1 as 10,000 chords of 0.0006 with a tolerance of 0.001.
  std::vector<Vec2> corners;
  for (int i = 0; i < 10000; ++i) {
    corners.emplace_back(std::cos(2 * pi * i / 10000), std::sin(2 * pi * i / 10000));
  }
  const MergedLoop found = merged(polygon(corners), 1e-3);
  EXPECT_GE(found.loop.size(), 30u);
  EXPECT_LE(found.loop.size(), 200u);
  EXPECT_NEAR(signed_area(found.loop), pi, 2 * pi * 1e-3);
  EXPECT_EQ(worst_gap(found.loop), 0.0);
}

TEST(Merged, TakesTenThousandCurves) {
  // Fine pieces of a big slot: everything joins.
  const MergedLoop found = merged(cut_up(scaled(slot(), 100), 2500), 1e-3);
  EXPECT_EQ(found.loop.size(), 4u);
  // A saw: nothing joins.
  std::vector<Vec2> saw;
  for (int i = 0; i < 10000; ++i)
    saw.emplace_back(i, i % 2);
  saw.emplace_back(5000, 20000);
  EXPECT_EQ(merged(polygon(saw), 1e-3).loop.size(), saw.size());
}

TEST(Merged, SnapsJointsThatMissEachOther) {
  Loop loop = slot();
  std::get<Segment>(loop[0]).b += Vec2(3e-5, -2e-5);
  std::get<Segment>(loop[2]).a += Vec2(-1e-5, 4e-5);
  const MergedLoop found = merged(loop, 1e-3);
  ASSERT_EQ(found.loop.size(), 4u);
  EXPECT_LE(worst_gap(found.loop), 1e-14 * 50);
  EXPECT_EQ(std::get<Segment>(found.loop[0]).b, start_of(found.loop[1]));
  EXPECT_EQ(std::get<Segment>(found.loop[2]).a, end_of(found.loop[1]));
}

}  // namespace
}  // namespace planish
