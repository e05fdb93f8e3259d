#include "fitted_curve.hpp"

#include "kernel_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::brep {
namespace {

Eigen::VectorXd numbers_in(std::initializer_list<double> values) {
  Eigen::VectorXd row(static_cast<Eigen::Index>(values.size()));
  std::ranges::copy(values, row.data());
  return row;
}

const PathFunction kCubic = [](double t) {
  return numbers_in({t, 2 * t * t - 1, t * t * t, 3 - t, t * t, -t * t * t + t});
};
const PathFunction kHelix = [](double t) {
  return numbers_in({5 * std::cos(t), 5 * std::sin(t), t, 7 * std::cos(t), 7 * std::sin(t), t});
};

TEST(FitPath, TakesOneSpanForACubicAndKeepsItsBreaks) {
  const FittedPath path = fit_path(kCubic, {0.0, 0.5, 2.0}, 1e-7);
  EXPECT_EQ(path.knots, (std::vector<double>{0.0, 0.5, 2.0}));
  for (size_t i = 0; i < path.knots.size(); ++i) {
    const double t = path.knots[i];
    EXPECT_NEAR((path.values[i] - kCubic(t)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(
        (path.slopes[i] - numbers_in({1, 4 * t, 3 * t * t, -1, 2 * t, -3 * t * t + 1})).norm(), 0.0,
        1e-6);
  }
}

TEST(FitPath, AsksForNoPointBeyondItsEnds) {
  // Also of a range about zero, of one far from it, and of a short one.
  for (const auto& [lo, hi] :
       {std::pair{-1.0, 1.0}, std::pair{1000.0, 1001.0}, std::pair{0.0, 1e-3}}) {
    const PathFunction within = [lo = lo, hi = hi](double t) {
      EXPECT_GE(t, lo);
      EXPECT_LE(t, hi);
      const double s = t - lo;
      return numbers_in({s, s * s, s * s * s});
    };
    const FittedPath path = fit_path(within, {lo, hi}, 1e-7);
    ASSERT_EQ(path.knots, (std::vector<double>{lo, hi}));
    EXPECT_NEAR((path.slopes[0] - numbers_in({1, 0, 0})).norm(), 0.0, 1e-6);
    EXPECT_NEAR((path.slopes[1] - numbers_in({1, 2 * (hi - lo), 3 * (hi - lo) * (hi - lo)})).norm(),
                0.0, 1e-6);
  }
}

TEST(FitPath, HalvesSpansUntilTheyAreNear) {
  size_t before = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const FittedPath path = fit_path(kHelix, {0.0, 3.0}, tolerance);
    EXPECT_GT(path.knots.size(), before);
    before = path.knots.size();
    const auto curve = space_curve(path, 3);
    for (int i = 0; i <= 300; ++i)
      EXPECT_NEAR((vector_of(curve->Value(i / 100.0)) - kHelix(i / 100.0).tail<3>()).norm(), 0.0,
                  2 * tolerance);
    // The error of a Hermite span is h⁴/384 of the fourth derivative: no more spans than that asks.
    const double width = std::pow(384 * tolerance / 7, 0.25);
    EXPECT_LT(static_cast<double>(path.knots.size() - 1), 4 * 3.0 / width + 1);
  }
}

TEST(FitPath, StopsAtATenthHalving) {
  const auto jump = [](double t) { return numbers_in({t < 0.3 ? 0.0 : 1.0, t, 0}); };
  const FittedPath path = fit_path(jump, {0.0, 1.0}, 1e-6);
  double narrowest = 1.0;
  for (size_t i = 0; i + 1 < path.knots.size(); ++i)
    narrowest = std::min(narrowest, path.knots[i + 1] - path.knots[i]);
  EXPECT_NEAR(narrowest, 1.0 / 1024, 1e-15);
}

TEST(SpaceCurve, IsTheHermitePathThroughItsKnots) {
  const FittedPath path = fit_path(kCubic, {0.0, 0.5, 2.0}, 1e-7);
  const auto near = space_curve(path, 0), far = space_curve(path, 3);
  const auto flat = plane_curve(path);
  for (const double t : {0.0, 0.2, 0.5, 1.1, 2.0}) {
    EXPECT_NEAR((vector_of(near->Value(t)) - kCubic(t).head<3>()).norm(), 0.0, 1e-6);
    EXPECT_NEAR((vector_of(far->Value(t)) - kCubic(t).tail<3>()).norm(), 0.0, 1e-6);
    EXPECT_NEAR(flat->Value(t).Distance(gp_Pnt2d(t, 2 * t * t - 1)), 0.0, 1e-6);
  }
}

TEST(RuledSurface, JoinsBothPathsStraight) {
  const auto surface = ruled_surface(fit_path(kCubic, {0.0, 2.0}, 1e-7), 3.0, 7.0);
  for (const double u : {0.0, 0.7, 2.0})
    for (const double share : {0.0, 0.25, 1.0}) {
      const Vec3 expected = (1 - share) * kCubic(u).head<3>() + share * kCubic(u).tail<3>();
      EXPECT_NEAR((vector_of(surface->Value(u, 3 + 4 * share)) - expected).norm(), 0.0, 1e-6);
    }
}

/// Two spans of one straight line with handles of 1 and 3 either side of the knot.
TEST(PlaneCurve, SpacesItsKnotsBySpeedWhereSpansAreTangent) {
  const CubicSpline spline{{{0, 0}, {1, 1}, {2, 0}, {3, 0}, {6, 0}, {7, 1}, {8, 2}}};
  const auto curve = plane_curve(spline, 1e-6);
  ASSERT_EQ(curve->NbKnots(), 3);
  EXPECT_NEAR(curve->Knot(1), 0.0, 1e-15);
  EXPECT_NEAR(curve->Knot(2), 1.0, 1e-12);
  EXPECT_NEAR(curve->Knot(3), 4.0, 1e-12) << "handles of 3 and 1 make spans of 3 and 1";
  EXPECT_EQ(curve->Multiplicity(2), 2);
  EXPECT_EQ(curve->NbPoles(), 6);
  const Curve2 plain = spline;
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const double s = t < 0.5 ? 2 * t : 1 + 3 * (2 * t - 1);
    const Vec2 p = point_at(plain, t);
    EXPECT_NEAR(curve->Value(s).Distance(gp_Pnt2d(p.x(), p.y())), 0.0, 1e-12);
  }
}

TEST(PlaneCurve, KeepsCorners) {
  const CubicSpline spline{{{0, 0}, {1, 1}, {2, 0}, {3, 0}, {3, 3}, {4, 4}, {5, 4}}};
  const auto curve = plane_curve(spline, 1e-6);
  EXPECT_EQ(curve->Multiplicity(2), 3);
  EXPECT_EQ(curve->NbPoles(), 7);
  EXPECT_NEAR(curve->LastParameter(), 2.0, 1e-15) << "the speed is not carried over a corner";
  EXPECT_NEAR(curve->Value(1.0).Distance(gp_Pnt2d(3, 0)), 0.0, 1e-12);
  EXPECT_EQ(plane_curve(spline, 2.0)->Multiplicity(2), 2) << "unless that much is none";
}

TEST(PlaneLine, RunsEvenly) {
  const auto line = plane_line({1, 2}, {4, 6}, 10);
  EXPECT_NEAR(line->FirstParameter(), 0.0, 1e-15);
  EXPECT_NEAR(line->LastParameter(), 10.0, 1e-15);
  EXPECT_NEAR(line->Value(2.5).Distance(gp_Pnt2d(1.75, 3)), 0.0, 1e-12);
}

}  // namespace
}  // namespace planish::brep
