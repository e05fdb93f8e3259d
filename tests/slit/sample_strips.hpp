#pragma once

#include "reach.hpp"
#include "strip_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace planish::test {

using namespace slit_detail;

inline StripBase some_base(int quads) {
  StripBase base;
  base.facet = frame_from_axes({120, -30, 55}, Vec3(0.3, -0.2, 0.9).normalized(), {1, 0.4, 0});
  base.sides = {35.0, 80.0};
  base.start = {200.0, 214.0};
  base.end = {560.0, 560.0};
  base.quads = quads;
  return base;
}

/// A strip between edges that are curves and converge: the left one an S, the right one an arc.
inline StripBase curved_base(int quads) {
  StripBase base = some_base(quads);
  std::vector<Vec2> left, right;
  for (int i = 0; i <= 30; ++i) {
    const double s = i / 30.0;
    left.emplace_back(200.0 + 340.0 * s, 35.0 + 12.0 * std::sin(6.0 * s));
    right.emplace_back(214.0 + 300.0 * s, 80.0 - 60.0 * s * s + 20.0 * s);
  }
  base.sides = {EdgeCurve(std::move(left), 200.0, 560.0),
                EdgeCurve(std::move(right), 214.0, 560.0)};
  return base;
}

/// One between lines along the sheet, one between curves.
inline std::vector<StripBase> both_bases(int quads) {
  return {some_base(quads), curved_base(quads)};
}

inline bool is_line(const StripBase& base) {
  return base.sides[0].is_line() && base.sides[1].is_line();
}

inline StripParameters random_parameters(const StripBase& base, unsigned seed,
                                         double largest_fold) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  StripParameters p = flat_parameters(base);
  for (int ridge = 0; ridge < base.quads; ++ridge)
    p[ridge] = largest_fold * unit(random);
  for (int ridge = 1; ridge < base.quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      p[abscissa_index(base.quads, ridge, side)] += (is_line(base) ? 0.45 : 0.2) * unit(random) /
                                                    base.quads;
  return p;
}

/// A problem of nothing, to which a test adds what it measures.
inline StripProblem bare_problem(int quads) {
  StripProblem problem;
  problem.base = some_base(quads);
  problem.weights = {.smooth = 0, .spacing = 0, .anchors = 0, .seat = 0, .spread = 0, .scan = 0};
  return problem;
}

inline StripProblem problem_with_everything(const StripBase& base) {
  const int quads = base.quads;
  StripProblem problem;
  problem.base = base;
  problem.mirrored = true;
  using Of = EndCondition::Of;
  problem.ends = {{Of::left_end, Vec3(1, 2, -1), 3}, {Of::right_end, Vec3::UnitX(), 0},
                  {Of::middle, Vec3::UnitY(), 5},    {Of::along, Vec3::UnitY(), 0},
                  {Of::across, Vec3(1, 1, 0), 0},    {Of::normal, Vec3::UnitX(), 0}};
  problem.anchors = {{quads / 2, 0, {10, 20, 30}}, {quads, 1, {-40, 10, 0}}};
  problem.seat = std::make_shared<const BezierSearch>(
      BezierCurve{{{-600, -600}, {300, -200}, {-100, 500}, {700, 900}}});
  problem.seat_places = {Vec2(1, 2), Vec2(30, -4)};
  std::vector<Vec3> points;
  for (int i = 0; i < 5; ++i)
    points.emplace_back(300.0 * i, -200.0 * i, 100.0);
  problem.scan = std::make_shared<const ScannedSurface>(points);
  problem.min_radius = 150.0;
  problem.penalty = 10.0;
  problem.inequalities = {{RadiusLimit{1, 0}, 0.5},
                          {RadiusLimit{1, 1}, 3.0},
                          {RadiusLimit{0, 0}, 3.0},
                          {HalfSpace{2, 1, Vec3(0.6, 0, 0.8), 1e4}, 0.0},
                          {HalfSpace{2, 0, Vec3::UnitX(), -1e5}, 0.0}};
  return problem;
}

inline StripProblem problem_with_everything(int quads) {
  return problem_with_everything(some_base(quads));
}

/// Central differences with a step at which truncation and rounding are alike.
template <typename F>
Eigen::MatrixXd differences(const F& f, const StripParameters& p) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd jacobian(f(p).size(), p.size());
  for (Eigen::Index q = 0; q < p.size(); ++q) {
    StripParameters up = p, down = p;
    up[q] += kStep;
    down[q] -= kStep;
    jacobian.col(q) = (f(up) - f(down)) / (2.0 * kStep);
  }
  return jacobian;
}

/// Derivatives of a problem's residuals, and their differences.
struct Derivatives {
  RowMatrix full;
  Eigen::MatrixXd expected;
};
inline Derivatives derivatives_of(const StripProblem& problem, const StripParameters& p) {
  Eigen::VectorXd residuals(problem.residuals());
  RowMatrix full(problem.residuals(), problem.parameters());
  Eigen::Ref<RowMatrix> jacobian(full);
  EXPECT_TRUE(evaluate(problem, p, residuals, &jacobian));
  EXPECT_TRUE(residuals.allFinite());
  const auto at = [&](const StripParameters& x) {
    EXPECT_TRUE(evaluate(problem, x, residuals, nullptr));
    return residuals;
  };
  return {full, differences(at, p)};
}

}  // namespace planish::test
