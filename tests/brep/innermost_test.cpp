#include "innermost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace planish::brep {
namespace {

using std::numbers::pi;

PlaneCurve circle_about(const Vec2& centre, double radius) {
  return [=](double t) {
    return Vec2(centre + radius * Vec2(std::cos(2 * pi * t), std::sin(2 * pi * t)));
  };
}

PlaneCurve line(const Vec2& from, const Vec2& to) {
  return [=](double t) { return Vec2(from + t * (to - from)); };
}

TEST(InnermostCell, OfACircleIsAllOfIt) {
  const auto cell = innermost_cell({circle_about({1, 2}, 3)}, {2, 2}, 1e-6);
  ASSERT_EQ(cell.size(), 1u);
  EXPECT_TRUE(cell.front().whole());
  EXPECT_LT(cell.front().from, cell.front().to) << "counter-clockwise";
}

TEST(InnermostCell, OfTwoCirclesIsTheLensBetweenTheirCrossings) {
  // Circles of radius 2 about (−1, 0) and (1, 0) cross at (0, ±√3): 60° on either side of 0.
  const std::vector<PlaneCurve> circles{circle_about({-1, 0}, 2), circle_about({1, 0}, 2)};
  const auto cell = innermost_cell(circles, {0.2, 0.1}, 1e-6);
  double turned[2] = {0, 0};
  for (size_t i = 0; i < cell.size(); ++i) {
    turned[cell[i].curve] += cell[i].to - cell[i].from;
    const CellPiece& next = cell[(i + 1) % cell.size()];
    EXPECT_LT((circles[cell[i].curve](cell[i].to) - circles[next.curve](next.from)).norm(), 1e-9);
  }
  EXPECT_NEAR(turned[0], 1.0 / 3, 1e-9);
  EXPECT_NEAR(turned[1], 1.0 / 3, 1e-9);
}

TEST(InnermostCell, TakesOneOfCurvesThatLieOnEachOther) {
  const std::vector<PlaneCurve> sides{line({-1, -1}, {1, -1}), line({1, -1}, {1, 1}),
                                      line({-1, 1}, {1, 1}),   line({-1, -1}, {-1, 1}),
                                      line({-1, 1}, {-1, -1}), line({1, 1}, {1, -1}),
                                      line({-2, -2}, {2, -2})};
  const auto cell = innermost_cell(sides, {0.1, 0.3}, 1e-6);
  ASSERT_EQ(cell.size(), 4u);
  for (const CellPiece& piece : cell) {
    EXPECT_TRUE(piece.whole());
    EXPECT_NE(piece.curve, 6);
  }
}

TEST(InnermostCell, IsNoneWhereItIsOpenOrHidden) {
  EXPECT_TRUE(
      innermost_cell({line({-1, -1}, {1, -1}), line({1, -1}, {0, 1})}, {0, 0}, 1e-6).empty());
  // An L, from one of its ends.
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  std::vector<PlaneCurve> sides;
  for (size_t i = 0; i < corners.size(); ++i)
    sides.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  EXPECT_TRUE(innermost_cell(sides, {3.5, 0.5}, 1e-6).empty());
  EXPECT_EQ(innermost_cell(sides, {0.5, 0.5}, 1e-6).size(), 6u) << "from its corner it is whole";
}

TEST(PartOf, KeepsTheLengthOfWholeEdgesAlone) {
  Border border{Segment{{0, 0}, {4, 0}}};
  border.edge_length = 4.0;
  const Border whole = part_of(border, {0, 1.0, 0.0}), half = part_of(border, {0, 0.0, 0.5});
  EXPECT_EQ(whole.edge_length, 4.0);
  EXPECT_LT((start_of(whole.curve) - Vec2(4, 0)).norm(), 1e-12);
  EXPECT_FALSE(half.edge_length);
  EXPECT_LT((end_of(half.curve) - Vec2(2, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace planish::brep
