#include "outline.hpp"

#include "sample_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using namespace io_detail;
using std::numbers::pi;

TEST(BulgeCurve, TurnsByFourTimesTheArcTangent) {
  // A bulge of 1 is a half circle to the right of its chord, of tan(π/8) a quarter.
  const Curve2 half = bulge_curve({0, 0}, {2, 0}, 1.0);
  EXPECT_NEAR((point_at(half, 0.5) - Vec2(1, -1)).norm(), 0.0, 1e-15);
  const Curve2 quarter = bulge_curve({1, 0}, {0, 1}, std::tan(pi / 8));
  EXPECT_NEAR((point_at(quarter, 0.5) - Vec2(std::sqrt(0.5), std::sqrt(0.5))).norm(), 0.0, 1e-15);
  const Curve2 back = bulge_curve({0, 0}, {2, 0}, -1.0);
  EXPECT_NEAR((point_at(back, 0.5) - Vec2(1, 1)).norm(), 0.0, 1e-15);
  EXPECT_TRUE(std::holds_alternative<Segment>(bulge_curve({0, 0}, {2, 0}, 1e-13)));
}

TEST(OutlineOf, AFullCircleIsACircleInUnitsOfTheFile) {
  const Outline outline = outline_of(sample::hole({25.4, 50.8}, 12.7), {.scale = 1 / 25.4});
  ASSERT_TRUE(std::holds_alternative<Circle>(outline));
  EXPECT_NEAR((std::get<Circle>(outline).center - Vec2(1, 2)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(std::get<Circle>(outline).radius, 0.5, 1e-15);
}

TEST(OutlineOf, AnObroundIsFourCornersWithTwoBulges) {
  const Outline outline = outline_of(sample::obround({0, 0}, 10, 5), {});
  ASSERT_TRUE(std::holds_alternative<Polyline>(outline));
  const auto& vertices = std::get<Polyline>(outline).vertices;
  ASSERT_EQ(vertices.size(), 4u);
  EXPECT_EQ(vertices[0].bulge, 0.0);
  EXPECT_NEAR(vertices[1].bulge, -1.0, 1e-15);  // clockwise half turns
  EXPECT_EQ(vertices[2].bulge, 0.0);
  EXPECT_NEAR(vertices[3].bulge, -1.0, 1e-15);
}

TEST(OutlineOf, HalvesArcsOfMoreThanHalfATurn) {
  const Loop keyhole{Arc{{0, 0}, 5, 0.25 * pi, 1.5 * pi},
                     Segment{{5 * std::sqrt(0.5), -5 * std::sqrt(0.5)}, {9, 0}},
                     Segment{{9, 0}, {5 * std::sqrt(0.5), 5 * std::sqrt(0.5)}}};
  const auto vertices = std::get<Polyline>(outline_of(keyhole, {})).vertices;
  ASSERT_EQ(vertices.size(), 4u);
  EXPECT_NEAR(vertices[0].bulge, std::tan(1.5 * pi / 8), 1e-15);
  EXPECT_NEAR(vertices[1].bulge, std::tan(1.5 * pi / 8), 1e-15);
  EXPECT_NEAR((vertices[1].point - Vec2(-5, 0)).norm(), 0.0, 1e-14);
}

TEST(OutlineOf, ASplineIsAChainWhereItIsKeptAndArcsWhereItIsNot) {
  const Loop petal = sample::petal({0, 0}, {-30, 60}, {40, 60});
  EXPECT_TRUE(std::holds_alternative<Loop>(outline_of(petal, {.splines = Splines::keep})));
  const Outline arcs = outline_of(petal, {.arc_tolerance = 0.001});
  ASSERT_TRUE(std::holds_alternative<Polyline>(arcs));
  EXPECT_GT(std::get<Polyline>(arcs).vertices.size(), 4u);
}

TEST(OutlineOf, DropsPiecesWithoutLength) {
  Loop square = sample::rectangle({0, 0}, {10, 10});
  square.insert(square.begin() + 1, Segment{{10, 0}, {10, 1e-10}});
  EXPECT_EQ(std::get<Polyline>(outline_of(square, {})).vertices.size(), 4u);
}

TEST(Bounds, OfAnOutlineReachTheTopsOfItsBulges) {
  const Box2 box = bounds(Outline(Polyline{{{{0, 0}, 1.0}, {{2, 0}, 1.0}}}));
  EXPECT_NEAR((box.lo - Vec2(0, -1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((box.hi - Vec2(2, 1)).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace planish
