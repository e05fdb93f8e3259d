#include "convex_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace planish::test {
namespace {

using namespace connect_detail;

struct Line {
  double slope, offset;
};

/// The largest of lines, with the slope there.
std::pair<double, double> largest(const std::vector<Line>& lines, double x) {
  std::pair<double, double> best{-1e300, 0.0};
  for (const Line& line : lines)
    best = std::max(best, {line.slope * x + line.offset, line.slope});
  return best;
}

std::optional<Minimum> least(const std::vector<Line>& f, const std::vector<Line>& g = {{0, -1}},
                             double start = 0.0) {
  LineSearch search;
  search.start = start;
  search.value_noise = search.slope_noise = 1e-12;
  return minimum(
      [&](double x) {
        const auto [value, slope] = largest(f, x);
        const auto [excess, excess_slope] = largest(g, x);
        return Support{value, slope, excess, excess_slope};
      },
      search);
}

TEST(Minimum, IsWhereTheLinesCross) {
  // |x − 3| + (x + 1) / 2.
  for (const double start : {-100.0, 0.0, 2.9, 50.0}) {
    const auto found = least({{-0.5, 3.5}, {1.5, -2.5}}, {{0, -1}}, start);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->at, 3.0, 1e-10);
    EXPECT_NEAR(found->value, 2.0, 1e-10);
  }
}

TEST(Minimum, IsExactOverManyLines) {
  // Tangents of the parabola x²/2 at whole numbers and a half: it is least between 7.5 and 8.5.
  std::vector<Line> tangents;
  for (int i = 0; i < 40; ++i) {
    const double at = i + 0.5 - 8.0;
    tangents.push_back({at, -0.5 * at * at - 8.0 * at});
  }
  const auto found = least(tangents);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at, 8.0, 1e-10);
  EXPECT_NEAR(found->value, -0.125, 1e-10);
}

TEST(Minimum, StopsWhereTheConstraintBegins) {
  const auto found = least({{-1, 3}, {1, -3}}, {{1, -2}});  // |x − 3| for x ≤ 2
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at, 2.0, 1e-10);
  EXPECT_NEAR(found->value, 1.0, 1e-10);
}

TEST(Minimum, IsFoundFromOutsideTheConstraint) {
  const auto found = least({{-1, 3}, {1, -3}}, {{1, -2}, {-1, 1}}, 40.0);  // 1 ≤ x ≤ 2
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at, 2.0, 1e-10);
}

TEST(Minimum, IsNotThereWhereTheConstraintHoldsNowhere) {
  EXPECT_FALSE(least({{-1, 3}, {1, -3}}, {{1, 1}, {-1, 1}}));  // |x| + 1 ≤ 0
}

TEST(Minimum, OfSeveralIsTheOneNearestToZero) {
  // Flat from 2 to 6.
  const auto found = least({{-1, 2}, {0, 0}, {1, -6}}, {{0, -1}}, 30.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->at, 2.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
