#include <planish/geometry/ruled_fit.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

constexpr double kRadius = 40.0, kHeight = 25.0;

/// Upright rulings through a circle.
Ruling cylinder_ruling(double u) {
  return {{u,
           {kRadius * std::cos(u), kRadius * std::sin(u), 0},
           {-kRadius * std::sin(u), kRadius * std::cos(u), 0},
           Vec3::UnitZ(),
           Vec3::Zero()},
          kHeight};
}

TEST(RuledThrough, KeepsItsToleranceBetweenKnots) {
  for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
    const Ruled ruled = ruled_through(cylinder_ruling, {0.0, 2.5}, tolerance);
    const double tilt = std::pow(tolerance / kHeight, 0.75);
    for (int i = 0; i <= 500; ++i) {
      const double u = 2.5 * i / 500;
      const Vec3 out(std::cos(u), std::sin(u), 0);
      for (const double v : {0.0, kHeight})
        EXPECT_LE((point_on(ruled, {u, v}) - kRadius * out - v * Vec3::UnitZ()).norm(), tolerance);
      EXPECT_LE((normal_on(ruled, u) - out).norm(), tilt);
    }
  }
}

TEST(RuledThrough, TakesKnotsAsTheFourthRootOfTheTolerance) {
  const auto knots = [](double tolerance) {
    return static_cast<double>(ruled_through(cylinder_ruling, {0.0, 2.5}, tolerance).knots.size());
  };
  // Intervals are halved, so their number is known to a factor of two.
  const double ratio = knots(1e-8) / knots(1e-4);
  EXPECT_GE(ratio, 5.0);
  EXPECT_LE(ratio, 20.0);
}

TEST(RuledThrough, HasAKnotAtEveryBreak) {
  const std::vector<double> breaks{-0.3, 0.01, 0.7, 1.9};
  const Ruled ruled = ruled_through(cylinder_ruling, breaks, 1e-3);
  EXPECT_TRUE(
      std::ranges::is_sorted(ruled.knots, [](const auto& a, const auto& b) { return a.u < b.u; }));
  for (const double u : breaks)
    EXPECT_TRUE(std::ranges::any_of(ruled.knots, [u](const Ruled::Knot& knot) {
      return knot.u == u;
    })) << u;
  EXPECT_EQ(ruled.knots.front().u, -0.3);
  EXPECT_EQ(ruled.knots.back().u, 1.9);
}

TEST(RuledThroughDeathTest, RefusesRulingsAlongTheCurve) {
  const auto along = [](double u) -> Ruling {
    return {{u, {u, 0, 0}, Vec3::UnitX(), Vec3::UnitX(), Vec3::Zero()}, 1.0};
  };
  EXPECT_DEATH(ruled_through(along, {0.0, 1.0}, 1e-3), "b_prime");
}

}  // namespace
}  // namespace planish
