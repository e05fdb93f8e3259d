#include "strip_limits.hpp"

#include "sample_strips.hpp"

#include <cmath>

// A strip of four quads with one fold of 60°: its inside is tighter than one limit and not another.

namespace planish::test {
namespace {

/// The radius at which an arc within half a quad on both sides of the fold of a straight strip
/// turns by its angle.
constexpr double kAngle = 1.0;

StripProblem problem_of_radius(double radius) {
  StripProblem problem = bare_problem(4);
  problem.base.start = {200.0, 200.0};
  problem.penalty = 2.0;
  problem.min_radius = radius * (1.0 + kRadiusMargin);
  return problem;
}

StripParameters folded_once(const StripBase& base) {
  StripParameters p = flat_parameters(base);
  p[2] = kAngle;
  return p;
}

const double kRadius = 0.5 * 90.0 / std::tan(0.5 * kAngle);  // 360 long, four quads

TEST(StripLimits, AreThoseThatAShapeBreaks) {
  for (const double share : {0.999, 1.001}) {
    const StripProblem problem = problem_of_radius(share * kRadius);
    const StripParameters p = folded_once(problem.base);
    EXPECT_EQ(is_too_tight(problem, p), share > 1.0);
    const auto limits = with_broken(problem, p, {{3, 1, Vec3::UnitX(), 5.0, true}});
    // The plane, and both sides of the tight ridge.
    EXPECT_EQ(limits.size(), share > 1.0 ? 3U : 1U);
  }
}

TEST(StripLimits, KeepTheirMultipliersAndRaiseThoseThatAreFirm) {
  StripProblem problem = problem_of_radius(1.2 * kRadius);
  const StripParameters p = folded_once(problem.base);
  const Vec3 end = folded(problem.base, p).end(1, 3);
  HalfSpace firm{3, 1, Vec3::UnitX(), end.x() + 36.0, true}, soft{2, 0, Vec3::UnitX(), 1e4, false};
  problem.inequalities = {{firm, 0.5}, {soft, 0.0}};
  EXPECT_FALSE(firm_ones_hold(problem, p));
  const auto raised = with_new_multipliers(problem, p);
  EXPECT_NEAR(raised[0].multiplier, 0.5 + 2.0 * 36.0 / problem.base.unit(), 1e-12);
  EXPECT_EQ(raised[1].multiplier, 0.0);
  problem.inequalities = raised;
  firm.offset = end.x() - 1.0;
  problem.inequalities = with_broken(problem, p, {firm});
  EXPECT_EQ(problem.inequalities[0].multiplier, raised[0].multiplier) << "a plane that moved";
  problem.inequalities.resize(1);
  EXPECT_TRUE(firm_ones_hold(problem, p));
}

}  // namespace
}  // namespace planish::test
