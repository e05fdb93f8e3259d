#include "resting_strip.hpp"

#include "sample_strips.hpp"

// Derivatives of what is fixed to a strip against differences, and what the ground bears of it.

namespace planish::test {
namespace {

StripProblem some_problem() {
  StripProblem problem = bare_problem(5);
  problem.objective = SlitObjective::energy;
  return problem;
}

TEST(RestingStrip, DirectionsTurnAsTheirQuads) {
  const StripProblem problem = some_problem();
  const StripParameters p = random_parameters(problem.base, 3, 0.4);
  const RestingStrip strip(problem, p);
  const Vec3 local(0.3, -0.5, 0.8);
  for (const int quad : {0, 2, 4}) {
    const auto direction = [&](const StripParameters& at) -> Eigen::VectorXd {
      const StripFold fold = folded(problem.base, at);
      const Frame& frame = fold.quad(quad);
      return local.x() * frame.x + local.y() * frame.y + local.z() * frame.z;
    };
    const Eigen::MatrixXd expected = differences(direction, p);
    EXPECT_LT((strip.turning(quad, direction(p)) - expected).norm(), 1e-7) << quad;
  }
}

TEST(RestingStrip, PointsMoveAsMixesOfEnds) {
  const StripProblem problem = some_problem();
  const StripParameters p = random_parameters(problem.base, 4, 0.4);
  const StripPoint point{0, {{0, 2, 0.25}, {1, 3, 0.75}}};
  const Vec3 direction(1, 2, -3);
  const auto along = [&](const StripParameters& at) {
    return Eigen::VectorXd::Constant(1, direction.dot(point.in(folded(problem.base, at))));
  };
  const Eigen::VectorXd expected = differences(along, p).transpose();
  EXPECT_LT((RestingStrip(problem, p).along(point, direction) - expected).norm(),
            1e-6 * expected.norm());
}

/// A strip that lies on the ground and weighs something: all ends of its ridges are held, and the
/// ground bears what the panel does not.
TEST(RestingStrip, LiesOnTheGround) {
  StripProblem problem = some_problem();
  problem.base.facet = {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ(), Vec3::UnitY()};
  problem.load.spread = -1e-6 * Vec3::UnitY();
  const RestingStrip strip(problem, flat_parameters(problem.base), {}, 0.0);
  EXPECT_EQ(strip.held({}).cols(), 10);
  double lifted = 0.0;
  for (const SlitReaction& one : strip.reactions(7, 1.0)) {
    EXPECT_EQ(one.strip, 7);
    lifted += one.force.y();
  }
  const double area = problem.base.width() * problem.base.unit();
  EXPECT_NEAR(lifted, energy_scale(problem.base) * 1e-6 * area, 1e-9 * lifted);
}

/// Something must hold what wishes draw: all three coordinates of a ridge's end.
TEST(RestingStrip, IsHeldWhereWishesDrawIt) {
  StripProblem problem = some_problem();
  problem.anchors = {{2, 1, Vec3(10, 20, 30)}};
  const StripParameters p = random_parameters(problem.base, 4, 0.4);
  EXPECT_EQ(RestingStrip(problem, p).held({}).cols(), 0);  // a wish without weight
  problem.weights.anchors = 0.03;
  EXPECT_EQ(RestingStrip(problem, p).held({}).cols(), 3);
}

}  // namespace
}  // namespace planish::test
