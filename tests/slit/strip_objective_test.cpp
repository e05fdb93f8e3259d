#include "strip_objective.hpp"

#include "descend.hpp"
#include "load_potential.hpp"
#include "sample_strips.hpp"

// The objective of a strip against differences of its value.

namespace planish::test {
namespace {

TEST(StripObjective, HasTheGradientOfItsValue) {
  StripProblem problem = problem_with_everything(5);
  problem.objective = SlitObjective::energy;
  problem.load.spread = Vec3(0.0, -1e-6, 2e-7);
  const StripParameters p = random_parameters(problem.base, 11, 0.4);
  const SecondOrder all = objective_derivatives(problem, p);
  EXPECT_NEAR(all.value, whole_objective(problem, p), 1e-12 * all.value);
  const Eigen::MatrixXd expected = differences(
      [&](const StripParameters& at) {
        return Eigen::VectorXd::Constant(1, whole_objective(problem, at));
      },
      p);
  EXPECT_LT((all.gradient.transpose() - expected).norm(), 1e-6 * expected.norm());
}

TEST(StripObjective, LoadCountsAsTheEnergyDoes) {
  StripProblem problem = bare_problem(6);
  problem.objective = SlitObjective::energy;
  const StripParameters p = random_parameters(problem.base, 2, 0.3);
  EXPECT_EQ(load_part(problem, p), 0.0);
  const double without = whole_objective(problem, p);
  problem.load.forces = {{0.5, Vec3(0, -1e-3, 0)}};
  const double part = energy_scale(problem.base) * load_potential(problem, p);
  EXPECT_DOUBLE_EQ(load_part(problem, p), part);
  EXPECT_NEAR(whole_objective(problem, p) - without, part, 1e-12 * (part + without));
}

}  // namespace
}  // namespace planish::test
