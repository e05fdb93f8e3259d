#include "right_surface.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

std::optional<RightSurface> found(const Ring& ring) {
  return right_surface(*ring.hull, ring.hull->patches[0]);
}

TEST(RightSurface, IsTheConeThroughTwoCoaxialCircles) {
  for (const bool opens : {false, true}) {
    const double below = opens ? 20 : 50, above = opens ? 50 : 20;
    const auto right = found(
        ring_between(EllipseProfile{below, below}, EllipseProfile{above, above}, {0, 0, 80}));
    ASSERT_TRUE(right);
    const auto* cone = std::get_if<Cone>(&right->surface);
    ASSERT_NE(cone, nullptr);
    EXPECT_NEAR(cone->half_angle, std::atan2(30, 80), 1e-14);
    // By similar triangles.
    EXPECT_NEAR(cone->frame.origin.z(), opens ? 80 - 80 * 50.0 / 30 : 80 * 50.0 / 30, 1e-11);
    EXPECT_NEAR(right->v[0], below * std::hypot(80, 30) / 30, 1e-11);
    EXPECT_NEAR(right->v[1], above * std::hypot(80, 30) / 30, 1e-11);
    EXPECT_NEAR(std::abs(right->u1 - right->u0), 2 * kPi, 1e-12);
  }
}

TEST(RightSurface, IsTheCylinderThroughEqualCircles) {
  const auto right = found(
      ring_between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, {0, 0, 80}));
  ASSERT_TRUE(right);
  const auto* cylinder = std::get_if<Cylinder>(&right->surface);
  ASSERT_NE(cylinder, nullptr);
  EXPECT_DOUBLE_EQ(cylinder->radius, 50.0);
  EXPECT_EQ(right->v[0], 0.0);
  EXPECT_NEAR(right->v[1], 80.0, 1e-12);
}

TEST(RightSurface, RunsThroughBothProfilesWithTheirParameters) {
  const Ring ring = frustum();
  const auto right = found(ring);
  ASSERT_TRUE(right);
  for (const double at : {0.0, 0.3, 0.8})
    for (int side = 0; side < 2; ++side) {
      const Vec3 p = point_on(right->surface,
                              {std::lerp(right->u0, right->u1, at), right->v[side]});
      EXPECT_LT((p - ring.patch(0).ruling(at)[side]).norm(), 1e-10);
    }
}

TEST(RightSurface, IsNotThereForCirclesOfDifferentAxes) {
  EXPECT_FALSE(found(ring_between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {1e-6, 0, 80})));
  TransitionSpec tilted = between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {0, 0, 80});
  tilted.to.frame = frame_at({0, 0, 80}, 1e-6);
  const auto ring = ring_of(tilted, {});
  ASSERT_TRUE(ring);
  EXPECT_FALSE(found(*ring));
}

TEST(RightSurface, IsNotThereForEllipsesAndObliqueCones) {
  EXPECT_FALSE(found(ring_between(EllipseProfile{50, 30}, EllipseProfile{50, 30}, {0, 0, 80})));
  const Ring ring = square_to_circle();
  for (const HullPatch& patch : ring.hull->patches)
    if (!patch.plane) {
      EXPECT_FALSE(right_surface(*ring.hull, patch));
    }
}

}  // namespace
}  // namespace planish::test
