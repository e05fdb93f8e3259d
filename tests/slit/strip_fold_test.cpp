#include "reach.hpp"
#include "strip_problem.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

// Folding keeps lengths whatever the parameters; derivatives are those of what is computed.

namespace planish::test {
namespace {

using namespace slit_detail;

StripBase some_base(int quads) {
  StripBase base;
  base.facet = frame_from_axes({120, -30, 55}, Vec3(0.3, -0.2, 0.9).normalized(), {1, 0.4, 0});
  base.sides = {35.0, 80.0};
  base.start = {200.0, 214.0};
  base.end = 560.0;
  base.quads = quads;
  return base;
}

StripParameters random_parameters(const StripBase& base, unsigned seed, double largest_fold) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  StripParameters p = flat_parameters(base);
  for (int ridge = 0; ridge < base.quads; ++ridge)
    p[ridge] = largest_fold * unit(random);
  for (int ridge = 1; ridge < base.quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      p[abscissa_index(base.quads, ridge, side)] += 0.45 * unit(random) / base.quads;
  return p;
}

StripProblem problem_with_everything(int quads) {
  StripProblem problem;
  problem.base = some_base(quads);
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
  problem.inequalities = {{RadiusLimit{1, 0, 0}, 0.5},
                          {RadiusLimit{1, 1, 1}, 3.0},
                          {RadiusLimit{0, 0, 0}, 3.0},
                          {HalfSpace{2, 1, Vec3(0.6, 0, 0.8), 1e4}, 0.0},
                          {HalfSpace{2, 0, Vec3::UnitX(), -1e5}, 0.0}};
  return problem;
}

RC_GTEST_PROP(StripFold, KeepsSidesAndDiagonalsOfEveryQuad, ()) {
  const int quads = *rc::gen::inRange(3, 60);
  const StripBase base = some_base(quads);
  const FoldedStrip strip = folded_strip(
      base, random_parameters(base, *rc::gen::arbitrary<unsigned>(), 3.0));
  for (std::size_t i = 0; i + 1 < strip.ridges.size(); ++i) {
    const SlitRidge &near = strip.ridges[i], &far = strip.ridges[i + 1];
    const std::array<Vec2, 4> flat{near.flat[0], far.flat[0], far.flat[1], near.flat[1]};
    const std::array<Vec3, 4> folded{near.folded[0], far.folded[0], far.folded[1], near.folded[1]};
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b)
        RC_ASSERT(std::abs((folded[a] - folded[b]).norm() - (flat[a] - flat[b]).norm()) <=
                  1e-12 * 560.0);
    for (std::size_t a = 0; a < 4; ++a)
      RC_ASSERT((strip.quads[i].point(flat[a]) - folded[a]).norm() <= 1e-11 * 560.0);
  }
}

TEST(StripFold, TurnsEachQuadByItsAngleAboutItsRidge) {
  const StripBase base = some_base(8);
  const StripParameters p = random_parameters(base, 3, 1.2);
  const StripFold fold = folded(base, p);
  for (int i = 0; i < base.quads; ++i) {
    const Vec3 axis = (fold.end(1, i) - fold.end(0, i)).normalized();
    const Frame& before = fold.frames[i];
    EXPECT_NEAR((Eigen::AngleAxisd(p[i], axis) * before.z - fold.quad(i).z).norm(), 0.0, 1e-13);
  }
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

TEST(StripDerivatives, OfRidgeEndsAreDifferences) {
  const StripBase base = some_base(7);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const StripParameters p = random_parameters(base, seed, 1.0);
    const StripFold fold = folded(base, p);
    const auto all = twists(base, fold);
    for (int ridge = 0; ridge <= base.quads; ++ridge)
      for (int side = 0; side < 2; ++side) {
        const auto expected = differences(
            [&](const StripParameters& x) -> Eigen::VectorXd {
              return folded(base, x).end(side, ridge);
            },
            p);
        EXPECT_LE((end_derivative(base, fold, all, side, ridge) - expected).cwiseAbs().maxCoeff(),
                  1e-6 * base.unit())
            << ridge;
      }
  }
}

TEST(StripDerivatives, OfTheObjectiveAreDifferences) {
  const StripProblem problem = problem_with_everything(7);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    Eigen::VectorXd residuals(problem.residuals());
    RowMatrix full(problem.residuals(), problem.parameters());
    Eigen::Ref<RowMatrix> jacobian(full);
    ASSERT_TRUE(evaluate(problem, p, residuals, &jacobian));
    const auto expected = differences(
        [&](const StripParameters& x) {
          Eigen::VectorXd r(problem.residuals());
          EXPECT_TRUE(evaluate(problem, x, r, nullptr));
          return r;
        },
        p);
    EXPECT_LE((full - expected).cwiseAbs().maxCoeff(), 1e-6 * full.cwiseAbs().maxCoeff()) << seed;
    EXPECT_TRUE(residuals.allFinite());
  }
}

TEST(StripDerivatives, OfEndConditionsAreDifferences) {
  const StripProblem problem = problem_with_everything(6);
  for (unsigned seed = 0; seed < 10; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 1.0);
    const auto expected = differences(
        [&](const StripParameters& x) { return end_violation(problem, folded(problem.base, x)); },
        p);
    EXPECT_LE((end_derivative(problem, folded(problem.base, p)) - expected).cwiseAbs().maxCoeff(),
              1e-7);
  }
}

TEST(StripDerivatives, InCoordinatesOfShapesThatMeetTheirEndsAreDifferences) {
  StripProblem problem = problem_with_everything(9);
  problem.ends = {{EndCondition::Of::left_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::right_end, Vec3::UnitX(), 60},
                  {EndCondition::Of::normal, Vec3::UnitX(), 0}};
  const Reach reach = meet_ends(problem, random_parameters(problem.base, 5, 0.3));
  ASSERT_TRUE(reach.met()) << reach.violation;
  const EndChart chart(problem, reach.p);
  const Eigen::VectorXd at = Eigen::VectorXd::Constant(chart.dimensions(), 0.01);
  const auto shape = chart.shape(at);
  ASSERT_TRUE(shape);
  EXPECT_LE(end_violation(problem, folded(problem.base, *shape)).cwiseAbs().maxCoeff(), kEndsMet);
  const auto residuals_at = [&](const Eigen::VectorXd& xi) {
    Eigen::VectorXd r(problem.residuals());
    EXPECT_TRUE(evaluate(problem, *chart.shape(xi), r, nullptr));
    return r;
  };
  Eigen::VectorXd residuals(problem.residuals());
  RowMatrix full(problem.residuals(), problem.parameters());
  Eigen::Ref<RowMatrix> jacobian(full);
  ASSERT_TRUE(evaluate(problem, *shape, residuals, &jacobian));
  const auto expected = differences(residuals_at, at);
  EXPECT_LE((chart.derivative(*shape, full) - expected).cwiseAbs().maxCoeff(),
            1e-6 * expected.cwiseAbs().maxCoeff());
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
        barrier += (problem.base.end - problem.base.start[side]) / 6 /
                   (abscissa(problem.base, p, i + 1, side) - abscissa(problem.base, p, i, side));
    return residuals.squaredNorm() - barrier / 6;
  };
  EXPECT_NEAR(difference(1), difference(2), 1e-12);
  EXPECT_NEAR(difference(1), -2.0, 1e-12);
}

}  // namespace
}  // namespace planish::test
