#include "bend_energy.hpp"

#include "sample_strips.hpp"

#include <cmath>
#include <numbers>

// The energy against closed forms, its derivatives against differences.

namespace planish::test {
namespace {

using std::numbers::pi;

/// A strip whose facet begins square, in units of some_base.
StripProblem square_problem(int quads) {
  StripProblem problem;
  problem.base = some_base(quads);
  problem.base.start = {200.0, 200.0};
  problem.objective = SlitObjective::energy;
  return problem;
}

/// Equal folds on equal spacings are an arc: ½ Φ² w / L for the material that the folds have.
TEST(BendEnergy, OfAnArcIsThatOfItsCurvature) {
  StripProblem problem = square_problem(12);
  const double length = 360.0, width = 45.0, h = length / 12;
  const auto bent = [&](double first, double fold, double last) {
    StripParameters p = flat_parameters(problem.base);
    p.head(12).setConstant(fold);
    p[0] = first;
    p[11] = last;
    return bend_energy(problem, p);
  };
  // The end is free: half of the first quad, and all but half of the last, are bent by 0.1 per h.
  EXPECT_NEAR(bent(0.05, 0.1, 0.1), 0.5 * 0.01 / (h * h) * (length - 0.5 * h) * width, 1e-9);
  problem.ends = {{EndCondition::Of::normal, Vec3::UnitX(), 0.0}};
  EXPECT_NEAR(bent(0.05, 0.1, 0.15), 0.5 * 0.01 / (h * h) * length * width, 1e-9);
}

/// Folds on generators of a cone: κ = θ/h grows towards the apex, ½ ∫ κ² dA in closed form.
TEST(BendEnergy, OfAConeIsThatOfItsCurvature) {
  StripProblem problem = square_problem(400);
  const StripBase& base = problem.base;
  // Lines through an apex below the middle of the strip, from angle −a to a.
  const double apex = 60.0, w = base.width(), middle = 380.0;
  StripParameters p = flat_parameters(base);
  const double a = std::atan(180.0 / (apex + w));
  const double da = 2.0 * a / 400, turn = 0.6;  // by which a cone turns per angle of its net
  for (int ridge = 1; ridge < 400; ++ridge) {
    const double angle = -a + ridge * da;
    p[abscissa_index(400, ridge, 0)] = (middle + apex * std::tan(angle)) / base.unit();
    p[abscissa_index(400, ridge, 1)] = (middle + (apex + w) * std::tan(angle)) / base.unit();
    p[ridge] = turn * da;
  }
  p[0] = p[1] = p[399] = 0.0;  // beside them quads are no part of the cone
  // κ = turn/r along r da: ∫ turn²/r dr over the strip.
  const double expected = 0.5 * turn * turn * (2.0 * a - 3.0 * da) * std::log((apex + w) / apex);
  EXPECT_NEAR(bend_energy(problem, p), expected, 1e-4 * expected);
}

TEST(BendEnergy, HasTheDerivativesOfItsDifferences) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    StripProblem problem = problem_with_everything(both_bases(6)[seed % 2]);
    problem.objective = SlitObjective::energy;
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    const SecondOrder energy = bend_energy_derivatives(problem, p);
    EXPECT_NEAR(energy.value, bend_energy(problem, p), 1e-12 * energy.value);
    const auto gradient = differences(
        [&](const StripParameters& x) {
          return Eigen::VectorXd::Constant(1, bend_energy(problem, x));
        },
        p);
    EXPECT_LE((energy.gradient.transpose() - gradient).cwiseAbs().maxCoeff(),
              1e-6 * energy.gradient.cwiseAbs().maxCoeff());
    const auto hessian = differences(
        [&](const StripParameters& x) { return bend_energy_derivatives(problem, x).gradient; }, p);
    EXPECT_LE((energy.hessian - hessian).cwiseAbs().maxCoeff(),
              1e-6 * hessian.cwiseAbs().maxCoeff());
  }
}

/// The panel at the end lies where the last ridge is, so that the fold into it turns about that.
TEST(BendEnergy, HasTheDerivativesOfItsDifferencesAtASecondPanel) {
  StripProblem problem = square_problem(6);
  for (unsigned seed = 0; seed < 6; ++seed) {
    const StripParameters p = random_parameters(problem.base, seed, 0.8);
    const StripFold fold = folded(problem.base, p);
    const Frame& last = fold.quad(5);
    problem.far_facet = frame_from_axes(fold.end(0, 6), Eigen::AngleAxisd(0.3, last.y) * last.z,
                                        Eigen::AngleAxisd(0.3, last.y) * last.x);
    const SecondOrder energy = bend_energy_derivatives(problem, p);
    const auto hessian = differences(
        [&](const StripParameters& x) { return bend_energy_derivatives(problem, x).gradient; }, p);
    // Off the facet's line the angle has more derivatives; along it there are none.
    const Eigen::VectorXd turn = energy.gradient;
    EXPECT_LE((energy.hessian - hessian).cwiseAbs().maxCoeff(),
              1e-5 * hessian.cwiseAbs().maxCoeff())
        << seed;
  }
}

}  // namespace
}  // namespace planish::test
