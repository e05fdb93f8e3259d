#include "lateral.hpp"

#include <planish/connect/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

using Sections = std::vector<Spread>;

using std::numbers::pi;

TEST(LegalSections, AreWhereNoMaterialLiesBelowTheRuling) {
  const std::vector<Vec2> tab{{10, -5}, {20, -5}, {20, 5}, {10, 5}};
  EXPECT_EQ(legal_sections({tab}, 0, 30, 1e-9), (Sections{{0, 10}, {20, 30}}));
  EXPECT_EQ(legal_sections({tab}, 12, 18, 1e-9), Sections{});
  const std::vector<Vec2> above{{10, 0}, {20, 0}, {20, 5}, {10, 5}};
  EXPECT_EQ(legal_sections({above}, 0, 30, 1e-9), (Sections{{0, 30}}));
}

TEST(LegalSections, TakeCornersOnTheRulingAsAbove) {
  const std::vector<Vec2> nearly{{10, -1e-10}, {20, 0}, {20, 5}, {10, 5}};
  EXPECT_EQ(legal_sections({nearly}, 0, 30, 1e-9), (Sections{{0, 30}}));
}

/// A quarter of a cylinder of radius 14 between plates at a right angle.
BendSurface quarter() {
  const BendFrame frame{Vec3::Zero(),
                        Vec3::UnitX(),
                        {Vec3::UnitY(), Vec3::UnitZ()},
                        Vec3::Zero(),
                        Angle::degrees(90)};
  return tangent_surface(frame, EdgeKind::facing, {0.0, -14.0});
}

LateralOptions everywhere() {
  LateralOptions options;
  options.legal = {{-1000, 1000}};
  options.extent = 200;
  return options;
}

/// Edges on the tangent rulings, from low to high by side.
RunEnds on_rulings(const std::array<double, 2>& low, const std::array<double, 2>& high) {
  return {{Vec2(low[0], 0), Vec2(low[1], 0)}, {Vec2(high[0], 0), Vec2(high[1], 0)}};
}

TEST(LateralBoundaries, OfEdgesOfOneLengthAreStraightAcross) {
  const auto made = lateral_boundaries(quarter(), on_rulings({0, 0}, {100, 100}),
                                       LateralBoundary::automatic, everywhere());
  ASSERT_TRUE(made);
  EXPECT_EQ(made->kind, LateralBoundary::straight);
  for (int side = 0; side < 2; ++side) {
    EXPECT_NEAR(made->low.v[side], 0.0, 1e-10);
    EXPECT_NEAR(made->high.v[side], 100.0, 1e-10);
  }
  EXPECT_NEAR(end_of(made->low.curve).x(), 0.5 * pi, 1e-12);
}

TEST(LateralBoundaries, AreStraightWhenFlatFromCornerToCorner) {
  // The corner of side 0 lies 7π mm off its ruling, as far as the quarter is wide: the line has
  // crossed half of its shift there.
  const BendSurface surface = quarter();
  RunEnds ends = on_rulings({0, 0}, {100, 110});
  ends.high[0].y() = 7 * pi;
  LateralOptions options = everywhere();
  const auto made = lateral_boundaries(surface, ends, LateralBoundary::straight, options);
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->high.v[0], 105.0, 1e-9);
  EXPECT_NEAR(made->high.v[1], 110.0, 1e-9);
}

TEST(LateralBoundaries, OfAnArcLieInTheMiddleOfBothEnds) {
  const auto made = lateral_boundaries(quarter(), on_rulings({0, 10}, {100, 120}),
                                       LateralBoundary::arc, everywhere());
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->low.v[0], 5.0, 1e-12);
  EXPECT_NEAR(made->high.v[1], 110.0, 1e-12);
}

TEST(LateralBoundaries, OfACornerKeepWhatBothHave) {
  const auto made = lateral_boundaries(quarter(), on_rulings({0, 10}, {100, 120}),
                                       LateralBoundary::corner, everywhere());
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->low.v[1], 10.0, 1e-12);
  EXPECT_NEAR(made->high.v[0], 100.0, 1e-12);
}

TEST(LateralBoundaries, TurnToTheCornersWhereTheLineWouldLeanTooMuch) {
  const auto made = lateral_boundaries(quarter(), on_rulings({0, 60}, {100, 160}),
                                       LateralBoundary::automatic, everywhere());
  ASSERT_TRUE(made);
  EXPECT_EQ(made->kind, LateralBoundary::corner);
}

TEST(LateralBoundaries, StayOnTheWidestSectionThatIsFree) {
  LateralOptions options = everywhere();
  options.legal = {{-50, 30}, {40, 95}};
  const auto made = lateral_boundaries(quarter(), on_rulings({0, 0}, {100, 100}),
                                       LateralBoundary::corner, options);
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->low.v[0], 40.0, 1e-12);
  EXPECT_NEAR(made->high.v[0], 95.0, 1e-12);
}

TEST(LateralBoundaries, AreStraightOnlyWhereNoPlateLiesOnTheirRulings) {
  LateralOptions options = everywhere();
  options.legal = {{-50, 30}, {40, 95}};
  const RunEnds ends = on_rulings({0, 0}, {100, 100});
  const auto straight = lateral_boundaries(quarter(), ends, LateralBoundary::straight, options);
  ASSERT_FALSE(straight);
  EXPECT_EQ(straight.error().code, code::no_common_width);
  const auto made = lateral_boundaries(quarter(), ends, LateralBoundary::automatic, options);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->kind, LateralBoundary::corner);
}

TEST(LateralBoundaries, RefuseEdgesWithoutCommonWidth) {
  const auto refused = lateral_boundaries(quarter(), on_rulings({0, 60}, {50, 100}),
                                          LateralBoundary::corner, everywhere());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::no_common_width);
  EXPECT_NE(refused.error().message.find("10 mm"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace planish::test
