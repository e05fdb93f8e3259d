#include "sample_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

namespace planish::test {
namespace {

TEST(StripDerivatives, OfTheObjectiveAreDifferences) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const StripProblem problem = problem_with_everything(both_bases(7)[seed % 2]);
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    const auto [full, expected] = derivatives_of(problem, p);
    EXPECT_LE((full - expected).cwiseAbs().maxCoeff(), 1e-6 * full.cwiseAbs().maxCoeff()) << seed;
  }
}

TEST(StripObjective, KeepsItsSmoothnessUnderSubdivision) {
  // Of κ(s) = a s² the sum of squared second differences tends to ∫ κ″² ds.
  StripProblem problem;
  double values[2];
  for (const int level : {0, 1}) {
    const int quads = 200 << level;
    problem.base = some_base(quads);
    problem.weights = {.smooth = 1.0, .spacing = 0.0};
    StripParameters p = flat_parameters(problem.base);
    for (int i = 0; i < quads; ++i)
      p[i] = (i + 0.5) * (i + 0.5) / std::pow(quads, 3.0);
    Eigen::VectorXd residuals(problem.residuals());
    ASSERT_TRUE(evaluate(problem, p, residuals, nullptr));
    values[level] = residuals.squaredNorm();
  }
  EXPECT_NEAR(values[1] / values[0], 1.0, 0.02);
}

TEST(StripObjective, TakesTheBarrierOfSpacingsUpToAConstant) {
  StripProblem problem;
  problem.base = some_base(6);
  problem.weights = {.smooth = 0.0, .spacing = 1.0};
  const auto difference = [&](unsigned seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.0);
    Eigen::VectorXd residuals(problem.residuals());
    EXPECT_TRUE(evaluate(problem, p, residuals, nullptr));
    double barrier = 0.0;
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < 6; ++i)
        barrier += (problem.base.end[side] - problem.base.start[side]) / 6 /
                   (abscissa(problem.base, p, i + 1, side) - abscissa(problem.base, p, i, side));
    return residuals.squaredNorm() - barrier / 6;
  };
  EXPECT_NEAR(difference(1), difference(2), 1e-12);
  EXPECT_NEAR(difference(1), -2.0, 1e-12);
}

// ---- the sum itself, as math.md#strip-conditions has it

double objective_of(const StripProblem& problem, const StripParameters& p) {
  Eigen::VectorXd residuals(problem.residuals());
  EXPECT_TRUE(evaluate(problem, p, residuals, nullptr));
  return residuals.squaredNorm();
}

/// Lengths count in thirtieths of the strip's length.
double squared_length(const StripProblem& problem, const Vec3& v) {
  return 900.0 * v.squaredNorm() / (problem.base.unit() * problem.base.unit());
}

TEST(StripObjective, IsSmoothByTheSecondDifferencesOfItsFolds) {
  for (const int quads : {4, 10, 15}) {
    StripProblem problem = bare_problem(quads);
    problem.weights.smooth = 0.3;
    const StripParameters p = random_parameters(problem.base, 3, 0.4);
    double sum = 0.0;
    for (int i = 1; i + 1 < quads; ++i)
      sum += std::pow(p[i - 1] - 2 * p[i] + p[i + 1], 2);
    const double weight = 0.3 * std::pow(quads / 10.0, 5);
    EXPECT_NEAR(objective_of(problem, p), weight * sum, 1e-12 * weight);
    problem.mirrored = true;
    const double mirrored = std::pow(p[quads - 1] - p[quads - 2], 2);
    EXPECT_NEAR(objective_of(problem, p), weight * (sum + mirrored), 1e-12 * weight);
    problem.mirrored = false;
    // The fold into a panel beyond it: the last quad, turned about its last ridge.
    const double beyond = 0.37;
    const Frame last = folded(problem.base, p).quad(quads - 1);
    Frame facet = last;
    const Eigen::AngleAxisd turn(beyond, last.y);
    facet.x = turn * last.x;
    facet.z = turn * last.z;
    problem.far_facet = facet;
    const double into = fold_into(last, facet).radians();
    EXPECT_NEAR(std::abs(into), beyond, 1e-12);
    EXPECT_NEAR(objective_of(problem, p),
                weight * (sum + std::pow(p[quads - 2] - 2 * p[quads - 1] + into, 2)),
                1e-12 * weight);
  }
}

TEST(StripObjective, HasDerivativesOfTheFoldIntoAPanelThatAreDifferences) {
  StripProblem problem = bare_problem(6);
  problem.weights.smooth = 1.0;
  problem.far_facet = frame_from_axes({0, 0, 0}, Vec3(0.2, 0.9, -0.3).normalized(), {1, 0.4, 2});
  for (unsigned seed = 0; seed < 4; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.5);
    const auto [full, expected] = derivatives_of(problem, p);
    EXPECT_LE((full - expected).cwiseAbs().maxCoeff(), 1e-6) << seed;
  }
}

TEST(StripObjective, CountsDistancesInThirtiethsOfTheStripsLength) {
  StripProblem problem = bare_problem(7);
  const StripParameters p = random_parameters(problem.base, 6, 0.6);
  const StripFold fold = folded(problem.base, p);
  problem.weights.anchors = 0.5;
  problem.anchors = {{3, 1, {10, 20, 30}}, {7, 0, {-40, 10, 0}}};
  const double anchored = 0.5 * (squared_length(problem, fold.end(1, 3) - Vec3(10, 20, 30)) +
                                 squared_length(problem, fold.end(0, 7) - Vec3(-40, 10, 0)));
  EXPECT_NEAR(objective_of(problem, p), anchored, 1e-9 * anchored);

  problem = bare_problem(7);
  problem.weights.scan = 0.5;
  problem.scan = std::make_shared<const ScannedSurface>(std::vector<Vec3>{Vec3(50, 60, 70)});
  double scanned = 0.0;
  for (int ridge = 1; ridge <= 7; ++ridge)
    for (int side = 0; side < 2; ++side)
      scanned += squared_length(problem, fold.end(side, ridge) - Vec3(50, 60, 70));
  scanned *= 0.5 * 10 / 7;  // of ten quads, so that subdivision keeps it
  EXPECT_NEAR(objective_of(problem, p), scanned, 1e-9 * scanned);

  problem = bare_problem(7);
  problem.weights.seat = 0.5;
  problem.weights.spread = 0.2;
  // Straight, so that the foot is known.
  problem.seat = std::make_shared<const BezierSearch>(BezierCurve{{{-5000, 40}, {5000, 40}}});
  problem.seat_places = {Vec2(1, 2), Vec2(30, -4)};
  double seated = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec3 end = fold.end(static_cast<int>(side), 7);
    const Vec2 apart = end.tail<2>() - problem.seat_places[side];
    seated += 0.5 * squared_length(problem, Vec3(0, 0, end.z() - 40)) +
              0.2 * squared_length(problem, Vec3(0, apart.x(), apart.y()));
  }
  EXPECT_NEAR(objective_of(problem, p), seated, 1e-9 * seated);
}

TEST(StripObjective, PaysForInequalitiesThatAreBroken) {
  StripProblem problem = bare_problem(5);
  problem.min_radius = 150.0;
  problem.penalty = 4.0;
  const StripParameters p = random_parameters(problem.base, 2, 0.5);
  const StripFold fold = folded(problem.base, p);
  const Vec3 normal(0.6, 0, 0.8);
  const double at = normal.dot(fold.end(1, 2));
  for (const double beyond : {-30.0, 30.0})
    for (const double multiplier : {0.0, 0.9}) {
      problem.inequalities = {{HalfSpace{2, 1, normal, at + beyond}, multiplier}};
      const double value = beyond / problem.base.unit();
      EXPECT_NEAR(inequality_values(problem, p)[0], value, 1e-12);
      EXPECT_NEAR(objective_of(problem, p),
                  4.0 * std::pow(std::max(0.0, value + multiplier / 4.0), 2), 1e-12);
    }
  for (const RadiusLimit& limit : {RadiusLimit{2, 0}, RadiusLimit{2, 1}}) {
    problem.inequalities = {{limit, 0.7}};
    const double skew = abscissa(problem.base, p, 2, 1) - abscissa(problem.base, p, 2, 0);
    const double needed = 2 * 150.0 * std::tan(0.5 * std::abs(p[2])) *
                          std::hypot(skew, problem.base.width()) / problem.base.width();
    const double spacing = 0.5 * (abscissa(problem.base, p, 3, limit.side) -
                                  abscissa(problem.base, p, 1, limit.side));
    const double value = (needed - spacing) / (problem.base.unit() / 5);
    EXPECT_NEAR(inequality_values(problem, p)[0], value, 1e-12);
    EXPECT_NEAR(objective_of(problem, p), 4.0 * std::pow(std::max(0.0, value + 0.7 / 4.0), 2),
                1e-12);
  }
}

TEST(StripShape, HasItsRidgesInOrderAndNoFoldOfHalfATurn) {
  const StripBase base = some_base(4);
  const StripParameters flat = flat_parameters(base);
  EXPECT_TRUE(is_shape(base, flat));
  for (const double fold : {3.2, -3.2}) {
    StripParameters p = flat;
    p[3] = fold;
    EXPECT_FALSE(is_shape(base, p));
    p[3] = 0.98 * fold;
    EXPECT_TRUE(is_shape(base, p));
  }
  for (int side = 0; side < 2; ++side)
    for (const double by : {-0.3, 0.3}) {
      StripParameters p = flat;
      p[abscissa_index(4, 2, side)] += by;
      EXPECT_FALSE(is_shape(base, p)) << "beyond its neighbour";
      p = flat;
      p[abscissa_index(4, 2, side)] += 0.5 * by;
      EXPECT_TRUE(is_shape(base, p));
    }
}

/// Of radius limits alone, whose slope is known.
TEST(StripProblem, LimitsHaveTheCurvatureOfDifferences) {
  for (std::size_t i = 0; i < 6; ++i) {
    StripProblem problem = problem_with_everything(both_bases(5)[i % 2]);
    std::erase_if(problem.inequalities, [](const Inequality& one) {
      return !std::holds_alternative<RadiusLimit>(one.what);
    });
    const StripParameters p = random_parameters(problem.base, 5, 0.6);
    StripProblem one = problem;
    one.penalty = 1e-12;  // its slope is the multiplier's alone
    one.inequalities = {problem.inequalities[i / 2]};
    one.inequalities[0].multiplier = 2.0;
    const auto slope = [&](const StripParameters& at) -> Eigen::VectorXd {
      constexpr double kStep = 1e-5;
      Eigen::VectorXd slopes(at.size());
      for (Eigen::Index q = 0; q < at.size(); ++q) {
        StripParameters up = at, down = at;
        up[q] += kStep;
        down[q] -= kStep;
        slopes[q] = (inequality_values(one, up)[0] - inequality_values(one, down)[0]) /
                    (2.0 * kStep);
      }
      return slopes;
    };
    const Eigen::MatrixXd expected = 2.0 * differences(slope, p);
    EXPECT_LT((limit_curvature(one, p) - expected).norm(), 1e-3 * expected.norm()) << i;
    one.inequalities[0].multiplier = -1.0;
    EXPECT_TRUE(limit_curvature(one, p).isZero(0.0));
  }
}

}  // namespace
}  // namespace planish::test
