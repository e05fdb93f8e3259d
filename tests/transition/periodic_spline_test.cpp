#include "periodic_spline.hpp"

#include "sample_transitions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using transition_detail::PeriodicSpline;
using transition_detail::PlanePoint;

std::vector<Vec2> uneven() { return {{0, 0}, {70, -5}, {100, 30}, {60, 80}, {-10, 60}}; }

TEST(PeriodicSpline, RunsThroughItsPointsByTheLengthsOfTheirChords) {
  const auto points = uneven();
  const PeriodicSpline spline(points);
  ASSERT_EQ(spline.knots().size(), points.size() + 1);
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(spline.knots()[i], length, 1e-12);
    EXPECT_LT((spline(spline.knots()[i]).point - points[i]).norm(), 1e-11);
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  }
  EXPECT_NEAR(spline.knots().back(), length, 1e-12);
}

TEST(PeriodicSpline, HasTwoContinuousDerivativesEverywhereAlsoWhereItCloses) {
  const PeriodicSpline spline(uneven());
  for (const double knot : spline.knots()) {
    constexpr double kStep = 1e-9;
    const PlanePoint before = spline(knot - kStep), after = spline(knot + kStep);
    EXPECT_LT((before.point - after.point).norm(), 1e-8);
    EXPECT_LT((before.first - after.first).norm(), 1e-9);
    EXPECT_LT((before.second - after.second).norm(), 1e-9);
  }
}

TEST(PeriodicSpline, GivesTheDerivativesOfItself) {
  const PeriodicSpline spline(uneven());
  constexpr double kStep = 1e-4;
  for (const double t : {10.0, 100.0, 200.0, 300.0}) {
    const PlanePoint low = spline(t - kStep), here = spline(t), high = spline(t + kStep);
    EXPECT_LT(((high.point - low.point) / (2 * kStep) - here.first).norm(), 1e-8);
    EXPECT_LT(((high.first - low.first) / (2 * kStep) - here.second).norm(), 1e-8);
    EXPECT_LT(((high.second - low.second) / (2 * kStep) - here.third).norm(), 1e-8);
  }
}

// By symmetry the second derivatives at the points are one vector turned: the equation of one point
// gives them.
TEST(PeriodicSpline, HasTheSecondDerivativesOfARegularPolygon) {
  const int n = 7;
  const double radius = 40.0, turn = 2.0 * kPi / n;
  const auto points = regular_polygon(n, radius).corners;
  const PeriodicSpline spline(points);
  for (int i = 0; i < n; ++i) {
    const Vec2 expected = -3.0 / (radius * (2.0 + std::cos(turn))) * points[i] / radius;
    EXPECT_LT((spline(spline.knots()[i]).second - expected).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace planish::test
