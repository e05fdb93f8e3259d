#include "geometry/comparisons.hpp"
#include "geometry/random_curves.hpp"

#include <planish/geometry/fit.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

std::size_t spans_of(const CubicSpline& s) { return s.poles.size() / 3; }

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
  // A Hermite span over the angle h is off by h⁴/384 at most, and halving overshoots by up to two.
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const FitReport fit = fit_cubics(ellipse(1, 1), 0, 2 * pi, tolerance);
    const double needed = 2 * pi / std::pow(384 * tolerance, 0.25);
    EXPECT_LE(static_cast<double>(spans_of(fit.spline)), 2 * needed + 1);
  }
}

TEST(FitCubics, MeetsTheEndsExactlyAndIsTangentContinuous) {
  const CurveFunction f = ellipse(30, 7);
  const FitReport fit = fit_cubics(f, 0.1, 2.5, 1e-5);
  EXPECT_EQ(fit.spline.poles.front(), f(0.1).point);
  EXPECT_EQ(fit.spline.poles.back(), f(2.5).point);
  ASSERT_GT(spans_of(fit.spline), 2u);
  for (std::size_t i = 3; i + 1 < fit.spline.poles.size(); i += 3) {
    const Vec2 before = fit.spline.poles[i] - fit.spline.poles[i - 1];
    const Vec2 after = fit.spline.poles[i + 1] - fit.spline.poles[i];
    EXPECT_LE(angle_between(before, after), 1e-12);
  }
}

TEST(FitCubics, ReproducesACubicInOnePiece) {
  const auto cubic = [](double t) { return CurveSample{{t, t * t * t}, {1, 3 * t * t}}; };
  const FitReport fit = fit_cubics(cubic, -1, 2, 1e-12);
  EXPECT_EQ(spans_of(fit.spline), 1u);
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
  const std::size_t usual = spans_of(fit_cubics(ellipse(3, 1), 0, 5, 1e-6).spline);
  EXPECT_EQ(spans_of(fit_cubics(scaled_by(0x1p40), 0, 5, 0x1p40 * 1e-6).spline), usual);
  EXPECT_EQ(spans_of(fit_cubics(scaled_by(0x1p-40), 0, 5, 0x1p-40 * 1e-6).spline), usual);
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
  EXPECT_LE(spans_of(fit.spline), 64u);
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
    EXPECT_LE(spans_of(fit.spline), 200u);
  }
}

TEST(FitCubics, TellsTheDeviationOfWhatCannotBeFitted) {
  const auto noise = [](double t) { return CurveSample{{t, std::sin(1e9 * t)}, {1, 0}}; };
  const FitReport rough = fit_cubics(noise, 0, 1, 1e-6);
  EXPECT_GT(rough.deviation, 1e-6);
  EXPECT_EQ(spans_of(rough.spline), 4096u);
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

}  // namespace
}  // namespace planish::test
