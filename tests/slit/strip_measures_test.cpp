#include "sample_strips.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

// What is measured on a strip: by how much it misses its end, how tightly it is bent.

namespace planish::test {
namespace {

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

TEST(StripEnds, MissTheirConditionsByWhatTheyAreOff) {
  StripProblem problem = bare_problem(5);
  const StripFold fold = folded(problem.base, random_parameters(problem.base, 2, 0.5));
  const double unit = problem.base.unit();
  using Of = EndCondition::Of;
  const Vec3 middle = 0.5 * (fold.end(0, 5) + fold.end(1, 5));
  problem.ends = {{Of::left_end, Vec3::UnitY(), fold.end(0, 5).y() - 3.0},
                  {Of::right_end, Vec3::UnitX(), fold.end(1, 5).x() + 5.0},
                  {Of::along, Vec3::UnitX(), fold.quad(4).x.x() - 0.1},
                  {Of::across, Vec3::UnitY(), fold.quad(4).y.y() + 0.2},
                  {Of::normal, Vec3::UnitZ(), fold.quad(4).z.z()}};
  const Eigen::VectorXd missed = end_violation(problem, fold);
  const double expected[] = {3.0 / unit, -5.0 / unit, 0.1, -0.2, 0.0};
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(missed[i], expected[i], 1e-12) << i;
  EXPECT_NEAR(end_gap(problem, fold), 5.0, 1e-9) << "directions are no distance";
  problem.ends = {{Of::middle, Vec3::UnitX(), middle.x() - 3.0},
                  {Of::middle, Vec3::UnitY(), middle.y() + 4.0},
                  {Of::middle, Vec3::UnitZ(), middle.z() + 12.0}};
  EXPECT_NEAR(end_gap(problem, fold), 13.0, 1e-9);
  problem.ends.push_back({Of::left_end, Vec3::UnitY(), fold.end(0, 5).y() - 14.0});
  EXPECT_NEAR(end_gap(problem, fold), 14.0, 1e-9);
}

TEST(StripRadii, AreThoseOfArcsOnTheHalvesOfBothQuads) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    StripProblem problem = bare_problem(6);
    problem.min_radius = 100.0;
    const StripBase& base = problem.base;
    const StripParameters p = random_parameters(base, seed, 0.5);
    double least = 1e300;
    int where = -1;
    std::vector<std::array<int, 2>> near;
    for (int ridge = 0; ridge < 6; ++ridge)
      for (int side = 0; side < 2; ++side) {
        const double skew = abscissa(base, p, ridge, 1) - abscissa(base, p, ridge, 0);
        const double halves = 0.5 * (abscissa(base, p, ridge + 1, side) -
                                     abscissa(base, p, std::max(0, ridge - 1), side));
        const double radius = 0.5 * halves * base.width() / std::hypot(skew, base.width()) /
                              std::tan(0.5 * std::abs(p[ridge]));
        if (radius < least) least = radius, where = ridge;
        if (radius < 2.0 * 100.0) near.push_back({ridge, side});
      }
    EXPECT_NEAR(tightest_fold(problem, p).radius, least, 1e-9 * least) << seed;
    EXPECT_EQ(tightest_fold(problem, p).ridge, where) << seed;
    std::vector<std::array<int, 2>> found;
    for (const RadiusLimit& limit : radius_limits(problem, p))
      found.push_back({limit.ridge, limit.side});
    EXPECT_EQ(found, near) << seed;
  }
  const StripProblem problem = bare_problem(6);
  EXPECT_TRUE(std::isinf(tightest_fold(problem, flat_parameters(problem.base)).radius));
}

/// A strip that leaves its panel level and lies on a cylinder: the first ridge has half of the fold
/// and of the material of the others, so that no radius is told that is twice the cylinder's.
TEST(StripRadii, AreAllThatOfTheCylinderOnWhichAStripLies) {
  const double radius = 300.0;
  StripProblem problem = bare_problem(40);
  problem.base.start = {200.0, 200.0};
  StripParameters p = flat_parameters(problem.base);
  const double fold = 2.0 * std::atan(0.5 * 360.0 / 40 / radius);
  p.head(40).setConstant(fold);
  p[0] = 0.5 * fold;
  for (int ridge = 0; ridge < 40; ++ridge) {
    StripParameters one = flat_parameters(problem.base);
    one[ridge] = p[ridge];
    EXPECT_NEAR(tightest_fold(problem, one).radius, radius, 1e-3 * radius) << ridge;
  }
}

TEST(StripRadii, CountTheFoldIntoAPanelAtItsEnd) {
  StripProblem problem = bare_problem(6);
  const StripParameters p = random_parameters(problem.base, 4, 0.5);
  EXPECT_TRUE(std::isinf(far_fold(problem, p).radius)) << "no panel";
  const Frame last = folded(problem.base, p).quad(5);
  Frame facet = last;
  problem.far_facet = facet;
  EXPECT_TRUE(far_fold(problem, p).radius > 1e9) << "no fold";
  facet.x = Eigen::AngleAxisd(0.4, last.y) * last.x;
  facet.z = Eigen::AngleAxisd(0.4, last.y) * last.z;
  problem.far_facet = facet;
  const double rest = problem.base.end[0] -
                      std::max(abscissa(problem.base, p, 5, 0), abscissa(problem.base, p, 5, 1));
  EXPECT_NEAR(far_fold(problem, p).radius, 0.25 * rest / std::tan(0.2), 1e-9);
  EXPECT_EQ(far_fold(problem, p).ridge, 6);
}

}  // namespace
}  // namespace planish::test
