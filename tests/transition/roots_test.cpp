#include "roots.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace planish::test {
namespace {

using transition_detail::falling_root;
using transition_detail::root_between;

TEST(RootBetween, FindsASquareRootToTheLastBit) {
  const auto f = [](double x) { return std::pair{x * x - 2.0, 2.0 * x}; };
  EXPECT_DOUBLE_EQ(root_between(f, 0.0, 2.0), std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(root_between(f, 2.0, 0.0), std::numbers::sqrt2);
}

TEST(RootBetween, BisectsWhereTheSlopeLeadsAstray) {
  // Newton's step from either end leaves the interval.
  const auto f = [](double x) {
    return std::pair{std::atan(200.0 * (x - 0.3)), 200.0 / (1.0 + 4e4 * (x - 0.3) * (x - 0.3))};
  };
  EXPECT_NEAR(root_between(f, -50.0, 70.0), 0.3, 1e-15);
}

TEST(RootBetween, GivesTheEndThatIsNearerToZeroWithoutAChangeOfSign) {
  const auto f = [](double x) { return std::pair{x + 1.0, 1.0}; };
  EXPECT_EQ(root_between(f, 0.0, 5.0), 0.0);
  EXPECT_EQ(root_between(f, 5.0, 0.0), 0.0);
  EXPECT_EQ(root_between(f, -1.0, 5.0), -1.0);
}

TEST(FallingRoot, PassesOverTheRootWhereTheFunctionRises) {
  const auto f = [](double x) { return std::pair{std::sin(x), std::cos(x)}; };
  EXPECT_DOUBLE_EQ(falling_root(f, 0.5, 9.0), std::numbers::pi);
  // Rises at 0, falls at π.
  EXPECT_DOUBLE_EQ(falling_root(f, -1.0, 4.0), std::numbers::pi);
}

}  // namespace
}  // namespace planish::test
