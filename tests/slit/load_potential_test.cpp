#include "load_potential.hpp"

#include "sample_strips.hpp"

#include <planish/geometry/mesh.hpp>

// The potential of loads against integrals over the quads, its derivatives against differences.

namespace planish::test {
namespace {

StripLoad some_load() {
  return {Vec3(0.3, -2.0, 0.5), {{0.37, Vec3(1.0, -4.0, 2.0)}, {1.0, Vec3(0.0, -3.0, 0.0)}}};
}

StripProblem loaded_problem(int quads) {
  StripProblem problem = bare_problem(quads);
  problem.load = some_load();
  return problem;
}

/// Minus the work from one shape to another, by the triangles of each quad's plane polygon.
double spread_work(const StripBase& base, const StripParameters& p, const Vec3& force) {
  const StripFold fold = folded(base, p);
  double work = 0.0;
  for (int quad = 0; quad < base.quads; ++quad) {
    const std::array<Vec3, 4> corners{fold.end(0, quad), fold.end(0, quad + 1),
                                      fold.end(1, quad + 1), fold.end(1, quad)};
    const Vec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    for (int i = 0; i < 4; ++i) {
      const Vec3 &a = corners[i], &b = corners[(i + 1) % 4];
      const double area = 0.5 * (a - middle).cross(b - middle).norm();
      work += area * force.dot((a + b + middle) / 3.0);
    }
  }
  return work;
}

TEST(LoadPotential, OfWeightIsThatOfTheQuads) {
  StripProblem problem = loaded_problem(6);
  problem.load.forces.clear();
  const StripParameters one = random_parameters(problem.base, 3, 0.4),
                        other = random_parameters(problem.base, 4, 0.4);
  const double work = spread_work(problem.base, other, problem.load.spread) -
                      spread_work(problem.base, one, problem.load.spread);
  EXPECT_NEAR(load_potential(problem, one) - load_potential(problem, other), work,
              1e-10 * std::abs(work));
}

TEST(LoadPotential, IsAboveZeroWhateverTheShape) {
  const StripProblem problem = loaded_problem(6);
  for (unsigned seed = 1; seed < 20; ++seed)
    EXPECT_GT(load_potential(problem, random_parameters(problem.base, seed, 1.5)), 0.0);
}

TEST(LoadPotential, HasTheDerivativesOfItsDifferences) {
  for (const StripBase& base : both_bases(5)) {
    StripProblem problem = loaded_problem(5);
    problem.base = base;
    const StripParameters p = random_parameters(problem.base, 7, 0.5);
    const SecondOrder all = load_potential_derivatives(problem, p);
    EXPECT_EQ(all.value, load_potential(problem, p));
    const Eigen::MatrixXd first = differences(
        [&](const StripParameters& at) {
          return Eigen::VectorXd::Constant(1, load_potential(problem, at));
        },
        p);
    EXPECT_LT((all.gradient.transpose() - first).norm(), 1e-7 * first.norm());
    const Eigen::MatrixXd second = differences(
        [&](const StripParameters& at) { return load_potential_derivatives(problem, at).gradient; },
        p);
    EXPECT_LT((all.hessian - second).norm(), 1e-7 * second.norm());
    EXPECT_LT((all.hessian - all.hessian.transpose()).norm(), 1e-14 * second.norm());
  }
}

TEST(LoadPotential, ForcesAtEndsAddUpToTheLoad) {
  const StripProblem problem = loaded_problem(7);
  const StripParameters p = random_parameters(problem.base, 5, 0.3);
  const EndForces forces = end_forces(problem.base, folded(problem.base, p), problem.load);
  Vec3 sum = Vec3::Zero();
  for (const auto& side : forces)
    for (const Vec3& force : side)
      sum += force;
  const Vec3 whole = problem.base.unit() * problem.base.width() * problem.load.spread +
                     Vec3(1.0, -7.0, 2.0);
  EXPECT_LT((sum - whole).norm(), 1e-9 * whole.norm());
}

TEST(LoadPotential, OfNoLoadIsZero) {
  const StripProblem problem = bare_problem(5);
  EXPECT_EQ(load_potential(problem, flat_parameters(problem.base)), 0.0);
  EXPECT_TRUE(problem.load.empty());
  EXPECT_FALSE(some_load().times(0.5).empty());
}

}  // namespace
}  // namespace planish::test
