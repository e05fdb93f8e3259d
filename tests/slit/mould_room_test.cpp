#include "mould_room.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace slit_detail;

Frame plan() { return frame_from_axes(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX()); }

/// A level strip along x, its left edge at y = 0, of three quads of 100; 100 wide at its first
/// ridge, growing by `grows` from ridge to ridge.
std::vector<std::vector<WholeStrip>> strips(double grows = 0.0) {
  WholeStrip strip;
  for (int i = 0; i < 4; ++i)
    strip.ridges.push_back({Vec3(100.0 * i, 0, 0), Vec3(100.0 * i, 100 + grows * i, 0)});
  strip.towards_mould.assign(3, -Vec3::UnitZ());
  return {{strip}};
}

/// A rib that comes up through something in a rectangle of the plan.
RibThrough at(int quad, const Vec2& low, const Vec2& high) {
  return {{0, quad}, {1, 0}, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, 1.0};
}

TEST(MakeRoom, KeepsTheSideThatIsWider) {
  auto made = strips();
  make_room(made, {at(0, {20, 0}, {60, 30}), at(2, {220, 70}, {300, 100})}, plan(), 1.0, 5.0);
  const auto& left = made[0][0].left_to_others;
  EXPECT_NEAR(left[0][0], 0.35, 1e-12);
  EXPECT_EQ(left[0][1], 0.0);
  EXPECT_EQ(left[1], (std::array{0.0, 0.0}));
  EXPECT_EQ(left[2][0], 0.0);
  EXPECT_NEAR(left[2][1], 0.35, 1e-12);
}

TEST(MakeRoom, TakesTheLargerOfBothQuadsAtARidge) {
  auto made = strips();
  make_room(made, {at(0, {20, 0}, {60, 30}), at(1, {120, 0}, {160, 10})}, plan(), 1.0, 5.0);
  const WholeStrip& strip = made[0][0];
  EXPECT_NEAR(left_at(strip, 0, 2, 0)[0], 0.35, 1e-12);
  EXPECT_NEAR(left_at(strip, 0, 2, 1)[0], 0.35, 1e-12);
  EXPECT_NEAR(left_at(strip, 0, 2, 2)[0], 0.15, 1e-12);
  EXPECT_EQ(left_at(strip, 0, 2, 3)[0], 0.0);
  EXPECT_NEAR(left_at(strip, 1, 2, 1)[0], 0.15, 1e-12) << "a rib that begins there";
}

TEST(MakeRoom, MeasuresSharesOfAStripThatWidens) {
  // At x = 50 it is 150 wide, at 100 it is 200.
  auto made = strips(100.0);
  make_room(made, {at(0, {50, 0}, {50, 30})}, plan(), 1.0, 0.0);
  EXPECT_NEAR(made[0][0].left_to_others[0][0], 30.0 / 150, 1e-12);
}

TEST(MakeRoom, LeavesAQuadOfWhichLessThanAQuarterIsLeft) {
  auto made = strips();
  make_room(made, {at(1, {120, 0}, {160, 71}), at(2, {220, 0}, {260, 69})}, plan(), 1.0, 5.0);
  EXPECT_TRUE(has_rib(made[0][0], 0));
  EXPECT_FALSE(has_rib(made[0][0], 1));
  EXPECT_TRUE(has_rib(made[0][0], 2));
}

TEST(MakeRoom, EndsARibBetweenQuadsThatLeaveRoomOnDifferentSides) {
  auto made = strips();
  make_room(made, {at(0, {20, 0}, {60, 50}), at(1, {120, 60}, {160, 100})}, plan(), 1.0, 0.0);
  EXPECT_FALSE(has_rib(made[0][0], 0)) << "the one that is narrower by itself";
  EXPECT_TRUE(has_rib(made[0][0], 1));
}

TEST(MakeRoom, KeepsTheWidestPartBetweenSeveral) {
  auto made = strips();
  const std::vector<RibThrough> three{at(0, {0, 85}, {100, 90}), at(0, {0, 10}, {50, 30}),
                                      at(0, {50, 25}, {100, 40})};
  make_room(made, three, plan(), 1.0, 5.0);
  EXPECT_NEAR(made[0][0].left_to_others[0][0], 0.45, 1e-12);
  EXPECT_NEAR(made[0][0].left_to_others[0][1], 0.20, 1e-12);
}

TEST(MakeRoom, IsOfTheHalfThatTheQuadIsIn) {
  auto made = strips();
  made[0].push_back(made[0][0]);
  made[0][1].first = 3;
  make_room(made, {at(4, {120, 0}, {160, 30})}, plan(), 1.0, 0.0);
  EXPECT_TRUE(made[0][0].left_to_others.empty());
  EXPECT_NEAR(made[0][1].left_to_others[1][0], 0.3, 1e-12);
}

}  // namespace
}  // namespace planish::test
