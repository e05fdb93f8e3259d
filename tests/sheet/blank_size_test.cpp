#include "support/sheets.hpp"

#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

FlatPattern blank_of(const Loop& outer) {
  FlatPattern pattern;
  pattern.outer.loop = outer;
  return pattern;
}

Isometry2 turned_by(double angle, const Vec2& shift) {
  Isometry2 motion = Isometry2::Identity();
  motion.rotate(angle).pretranslate(shift);
  return motion;
}

/// An L of 120 × 70 whose smallest rectangle is its box.
Loop l_shape() { return polygon({{0, 0}, {120, 0}, {120, 30}, {30, 30}, {30, 70}, {0, 70}}); }

TEST(BlankSize, IsTheSameAtAnyAngle) {
  for (const double angle : {0.0, 0.2, 1.0, 1.57, 2.5, -0.7, 4.0}) {
    const Vec2 size = blank_size(blank_of(transformed(l_shape(), turned_by(angle, {13, -400}))));
    EXPECT_NEAR(size.x(), 120, 1e-9) << angle;
    EXPECT_NEAR(size.y(), 70, 1e-9) << angle;
  }
  EXPECT_EQ(blank_size({}), Vec2::Zero());
}

TEST(BlankSize, OfADiscIsItsDiameterToTheStatedTolerance) {
  const Loop disc{Arc{{5, 5}, 20, 0.0, 2 * std::numbers::pi}};
  const Vec2 size = blank_size(blank_of(disc));
  EXPECT_NEAR(size.x(), 40, 2 * kImageTolerance);
  EXPECT_NEAR(size.y(), 40, 2 * kImageTolerance);
}

TEST(LaidByBlank, PutsTheLongSideOnXAndTheCornerAtTheOrigin) {
  for (const double angle : {0.0, 0.2, 1.0, 2.5, -0.7, 4.0}) {
    const Loop placed = transformed(l_shape(), turned_by(angle, {13, -400}));
    const Isometry2 laid = laid_by_blank(blank_of(placed));
    EXPECT_NEAR(laid.linear().determinant(), 1.0, 1e-12) << "turned, not mirrored";
    const Box2 box = bounds(transformed(placed, laid));
    EXPECT_LT(box.lo.norm(), 1e-9) << angle;
    EXPECT_LT((box.hi - Vec2(120, 70)).norm(), 1e-9) << angle;
  }
}

TEST(LaidByBlank, TurnsByQuartersExactlyWhatLiesAlongAnAxis) {
  const Isometry2 none = laid_by_blank(blank_of(transformed(l_shape(), turned_by(0.0, {7, 9}))));
  EXPECT_EQ(none.linear(), Eigen::Matrix2d(Eigen::Matrix2d::Identity()));
  EXPECT_EQ(none.translation(), Vec2(-7, -9));
  const Isometry2 upright = laid_by_blank(blank_of(rectangle(30, 80)));
  EXPECT_EQ(std::abs(upright.linear()(0, 1)), 1.0);
  EXPECT_EQ(upright.linear()(0, 0), 0.0);
  // 1e-7 rad is a turn, though a small one.
  const Isometry2 turned = laid_by_blank(blank_of(transformed(l_shape(), turned_by(1e-7, {0, 0}))));
  EXPECT_NEAR(turned.linear()(1, 0), -1e-7, 1e-12);
  EXPECT_TRUE(laid_by_blank({}).isApprox(Isometry2::Identity()));
}

}  // namespace
}  // namespace planish::test
