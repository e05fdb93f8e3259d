#include "slit_axis.hpp"

#include "slot_shape.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// Slits that are curves: chains become few arcs beside them, banks have the area of a band.

namespace planish::test {
namespace {

using namespace sheet_detail;
using std::numbers::pi;

/// An S of two quarter circles, as lines.
std::vector<Vec2> s_curve(int lines) {
  std::vector<Vec2> chain;
  for (int i = 0; i <= lines; ++i) {
    const double angle = 0.5 * pi * i / lines;
    chain.emplace_back(100.0 * std::sin(angle), 100.0 * (1.0 - std::cos(angle)));
  }
  for (int i = 1; i <= lines; ++i) {
    const double angle = 0.5 * pi * i / lines;
    chain.emplace_back(200.0 - 100.0 * std::cos(angle), 100.0 + 100.0 * std::sin(angle));
  }
  return chain;
}

void expect_joined(const Loop& loop) {
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
    EXPECT_LT((end_of(loop[i]) - start_of(loop[i + 1])).norm(), 1e-9) << i;
}

TEST(SlitAxis, ChainsLinesThatGoOnWhereverTheyStandInTheList) {
  const std::vector<Vec2> chain = s_curve(5);
  std::vector<Segment> lines;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    lines.push_back(i % 2 == 0 ? Segment{chain[i], chain[i + 1]} : Segment{chain[i + 1], chain[i]});
  std::ranges::rotate(lines, lines.begin() + 4);
  lines.push_back({{500, 0}, {600, 0}});
  auto chains = chains_of(lines, 1e-6);
  ASSERT_EQ(chains.size(), 2u);
  if ((chains[0].front() - chain.front()).norm() > 1e-9) std::ranges::reverse(chains[0]);
  ASSERT_EQ(chains[0].size(), chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
    EXPECT_EQ(chains[0][i], chain[i]);
  EXPECT_EQ(chains[1].size(), 2u);
}

TEST(SlitAxis, EndsChainsWhereThreeMeet) {
  const auto chains = chains_of({{{0, 0}, {10, 0}}, {{10, 0}, {20, 5}}, {{10, 0}, {20, -5}}}, 1e-6);
  EXPECT_EQ(chains.size(), 3u);
}

TEST(SlitAxis, OfACircleDrawnAsLinesIsFewArcsOfItsRadius) {
  const Loop curves = curves_through(s_curve(60), 0.01);
  expect_joined(curves);
  EXPECT_LE(curves.size(), 16u);
  EXPECT_LT(start_of(curves.front()).norm(), 1e-9);
  EXPECT_LT((end_of(curves.back()) - Vec2(200, 200)).norm(), 1e-9);
  EXPECT_NEAR(length(curves), 100.0 * pi, 0.02);
  for (const Curve2& curve : curves)
    for (const double t : {0.2, 0.5, 0.8}) {
      const Vec2 p = point_at(curve, t);
      const Vec2 center = p.y() < 100.0 ? Vec2(0, 100) : Vec2(200, 100);
      EXPECT_NEAR((p - center).norm(), 100.0, 0.01);
    }
}

TEST(SlitAxis, KeepsCornersAndStraightChains) {
  const Loop curves = curves_through({{0, 0}, {50, 0}, {50, 40}}, 0.01);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(end_of(curves[0]), Vec2(50, 0));
  EXPECT_NEAR(length(curves), 90.0, 1e-12);
}

/// What is swept by a disc along a smooth curve is its width times the curve's length and the disc.
TEST(SlitAxis, SlotAlongACurveTakesItsBand) {
  const Loop curves = curves_through(s_curve(60), 0.01);
  const Slot slot{.axis = {{0, 0}, {200, 200}}, .half_width = 2.0, .curves = curves};
  const Loop loop = closed_slot(slot);
  expect_joined(loop);
  EXPECT_LT((end_of(loop.back()) - start_of(loop.front())).norm(), 1e-9);
  EXPECT_NEAR(signed_area(loop), -(4.0 * length(curves) + 4.0 * pi), 1e-6);
}

TEST(SlitAxis, HolesEndTheBanksOfACurvedSlot) {
  const Loop curves = curves_through(s_curve(60), 0.01);
  const Slot slot{.axis = {{0, 0}, {200, 200}}, .half_width = 2.0, .hole = 5.0, .curves = curves};
  const Loop loop = closed_slot(slot);
  expect_joined(loop);
  // The band from hole to hole, nearly that of a straight one: 100 mm radius beside 5 mm.
  const double back = std::sqrt(21.0), half = std::asin(0.4);
  const double straight = 4.0 * (length(curves) - 2.0 * back) +
                          2.0 * (25.0 * (pi - half) + 2.0 * back);
  EXPECT_NEAR(-signed_area(loop), straight, 0.5);
}

TEST(SlitAxis, BanksGoRoundCornersOutsideAndMeetInside) {
  const Loop axis{Segment{{0, 0}, {50, 0}}, Segment{{50, 0}, {50, 40}}};
  const Loop inside = beside(axis, 3.0), outside = beside(axis, -3.0);
  expect_joined(inside);
  expect_joined(outside);
  EXPECT_EQ(inside.size(), 2u);
  EXPECT_LT((end_of(inside[0]) - Vec2(47, 3)).norm(), 1e-12);
  ASSERT_EQ(outside.size(), 3u);
  EXPECT_NEAR(length(outside), 90.0 + 1.5 * pi, 1e-9);
}

TEST(SlitAxis, IsShortenedToADiscAboutItsEnd) {
  const Loop axis{Segment{{0, 0}, {50, 0}}, Segment{{50, 0}, {50, 40}}};
  const Loop shorter = without_end(axis, {50, 40}, 41.0);
  ASSERT_EQ(shorter.size(), 1u);
  EXPECT_NEAR(end_of(shorter[0]).x(), 50.0 - 9.0, 1e-9);
  const Loop later = without_start(axis, {0, 0}, 5.0);
  EXPECT_NEAR(start_of(later[0]).x(), 5.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
