#include "profile_check.hpp"

#include "sample_transitions.hpp"

#include <planish/transition/codes.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planish::test {
namespace {

using namespace transition_detail;

int as_given(int i) { return i; }

TEST(TurnAt, IsTheSineOfTheTurn) {
  const auto hexagon = regular_polygon(6, 10).corners;
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(turn_at(hexagon, i).sine(), std::sin(kPi / 3), 1e-12);
  const std::vector<Vec2> clockwise(hexagon.rbegin(), hexagon.rend());
  EXPECT_NEAR(turn_at(clockwise, 2).sine(), -std::sin(kPi / 3), 1e-12);
}

TEST(CheckSizes, WantsPositiveFiniteNumbers) {
  EXPECT_TRUE(check_sizes({1.0, 1e-9}, "/p"));
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto refused = check_sizes({1.0, wrong}, "/p");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, code::invalid_input);
    EXPECT_EQ(refused.error().where, "/p");
  }
}

TEST(CheckRadius, LeavesSomethingOfTheRadius) {
  EXPECT_TRUE(check_radius(3.0, -2.9999, "/p"));
  EXPECT_TRUE(check_radius(3.0, 10.0, "/p"));
  EXPECT_EQ(check_radius(3.0, -3.0, "/p").error().code, code::radius_too_small);
}

TEST(CheckConvex, TakesCornersAtWhichAPolygonGoesStraightOn) {
  EXPECT_TRUE(check_convex(std::vector<Vec2>{{0, 0}, {5, 0}, {10, 0}, {10, 10}}, as_given, "/p"));
}

TEST(CheckConvex, NamesTheCornerByItsGivenNumberAndTheAngle) {
  // At (4, 3) it turns to the right, from (−6, 3) to (−4, 7).
  const std::vector<Vec2> notched{{0, 0}, {10, 0}, {4, 3}, {0, 10}};
  const double angle = (std::atan2(3.0, -6.0) - std::atan2(7.0, -4.0)) * 180.0 / kPi;
  const auto refused = check_convex(
      notched, [](int i) { return i + 40; }, "/p");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::profile_not_convex);
  EXPECT_EQ(refused.error().where, "/p/42");
  EXPECT_NE(refused.error().message.find(fmt::format("{:.4g}°", angle)), std::string::npos)
      << refused.error().message;
}

TEST(CheckConvex, WantsASplineThatTurnsToTheLeftEverywhere) {
  auto points = regular_polygon(8, 50).corners;
  EXPECT_TRUE(check_convex(PeriodicSpline(points), 0.0, "/p"));
  points[3] *= 0.7;
  EXPECT_EQ(check_convex(PeriodicSpline(points), 0.0, "/p").error().code, code::profile_not_convex);
}

TEST(CheckConvex, WantsASplineThatIsNowhereTighterThanTheThicknessAllows) {
  const PeriodicSpline spline(regular_polygon(16, 50).corners);
  EXPECT_TRUE(check_convex(spline, -49.0, "/p"));
  EXPECT_EQ(check_convex(spline, -51.0, "/p").error().code, code::radius_too_small);
}

}  // namespace
}  // namespace planish::test
