#include "bend_frame.hpp"

#include "sample_fits.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

std::vector<BendFrame> frames(const Plate& a, const Plate& b) {
  const PlacedPlate first = laid(a), second = laid(b);
  return bend_frames(first, second, plane_pair(first, second, kPlanarity));
}

TEST(PlanePair, IsCrossingParallelOrCoplanar) {
  const auto kind = [](const Vec3& o, const Vec3& b) {
    return plane_pair(laid(rectangle_plate("A", {0, 0, 0}, {100, 0, 0}, {0, 100, 0})),
                      laid(rectangle_plate("B", o, {100, 0, 0}, b)), kPlanarity);
  };
  EXPECT_EQ(kind({0, 150, 0}, {0, 100, 0}), PlanePair::coplanar);
  EXPECT_EQ(kind({0, 150, 0.5e-3}, {0, 100, 0}), PlanePair::coplanar);
  EXPECT_EQ(kind({0, 150, 3e-3}, {0, 100, 0}), PlanePair::parallel);
  EXPECT_EQ(kind({0, 150, 0}, {0, 100, 4e-3}), PlanePair::crossing);
  EXPECT_EQ(kind({0, 150, 30}, {0, 100, 1e-5}), PlanePair::parallel) << "turned by 1e-7";
}

TEST(BendFrames, OfARightAngleLieOnTheLineOfThePlanes) {
  const PlateStructure s = angle_pair(14.0);
  const auto all = frames(s.plates[0], s.plates[1]);
  ASSERT_EQ(all.size(), 1u);
  const BendFrame& f = all[0];
  EXPECT_LT((f.origin - Vec3(100, 114, 0)).norm(), 1e-9) << "beside the middle of both";
  EXPECT_NEAR(std::abs(f.d.x()), 1.0, 1e-12);
  EXPECT_LT((f.e[0] - Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((f.e[1] - Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_NEAR(f.beta.degrees(), 90.0, 1e-12);
}

TEST(BendFrames, KeepTheAngleBetweenThePlates) {
  // The second plate leaves the line at 30° over the first, and at 150°.
  for (const double beta : {30.0, 150.0}) {
    const Angle angle = Angle::degrees(beta);
    const Vec3 e(0, std::cos(angle.radians()), std::sin(angle.radians()));
    const auto all = frames(rectangle_plate("A", {0, 20, 0}, {100, 0, 0}, {0, 100, 0}),
                            rectangle_plate("B", 20 * e, {100, 0, 0}, 100 * e));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(all[0].beta.degrees(), beta, 1e-10);
    EXPECT_LT((all[0].e[1] - e).norm(), 1e-12);
  }
}

TEST(BendFrames, OfAPlateAcrossTheLineAreTwoTheLargerSideFirst) {
  const auto all = frames(rectangle_plate("A", {0, -30, 0}, {100, 0, 0}, {0, 100, 0}),
                          rectangle_plate("B", {0, 0, 20}, {100, 0, 0}, {0, 0, 100}));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_GT(all[0].e[0].y(), 0.0);
  EXPECT_LT(all[1].e[0].y(), 0.0);
}

TEST(BendFrames, OfParallelPlanesLookFromEachEdge) {
  const PlateStructure s = u_pair(40.0);
  const auto all = frames(s.plates[0], s.plates[1]);
  ASSERT_EQ(all.size(), 4u) << "the edges of both run the same four ways";
  for (const BendFrame& f : all) {
    EXPECT_TRUE(f.parallel());
    EXPECT_NEAR(f.rise.norm(), 40.0, 1e-12);
    EXPECT_EQ(f.e[0], f.e[1]);
    for (int side = 0; side < 2; ++side)
      for (const Vec2& p : side_outline(laid(s.plates[side]), f, side))
        EXPECT_GE(p.y(), -1e-9);
  }
}

TEST(SideOutline, IsMeasuredAlongAndAwayFromTheLine) {
  const PlateStructure s = angle_pair(14.0);
  const BendFrame f = frames(s.plates[0], s.plates[1])[0];
  for (int side = 0; side < 2; ++side) {
    double low = 1e300, high = -1e300;
    for (const Vec2& p : side_outline(laid(s.plates[side]), f, side)) {
      EXPECT_NEAR(std::abs(p.x()), 100.0, 1e-9);
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    EXPECT_NEAR(low, 14.0, 1e-9);
    EXPECT_NEAR(high, 114.0, 1e-9);
  }
}

}  // namespace
}  // namespace planish::test
