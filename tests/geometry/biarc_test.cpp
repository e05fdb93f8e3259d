#include "geometry/comparisons.hpp"
#include "geometry/random_curves.hpp"

#include <planish/geometry/fit.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

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

}  // namespace
}  // namespace planish::test
