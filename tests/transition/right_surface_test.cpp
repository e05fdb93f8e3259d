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

TEST(RightSurface, RunsThroughBothProfilesWhereverAndHoweverTheyStart) {
  for (const double below : {0.5, 20.0, 3000.0})
    for (const double share : {0.3, 1.0, 2.5})
      for (const double twist : {0.0, 0.7, -2.0})
        for (const double far : {0.0, 500.0}) {
          TransitionSpec spec = between(EllipseProfile{below, below},
                                        EllipseProfile{share * below, share * below},
                                        {far, -2 * far, 3 * below});
          spec.thickness = 0.01;
          spec.from.frame = frame_at({far, -2 * far, 0});
          spec.to.frame = frame_at({far, -2 * far, 3 * below}, 0.0, twist);
          const auto ring = ring_of(spec, {});
          ASSERT_TRUE(ring);
          const auto right = found(*ring);
          ASSERT_TRUE(right) << below << ' ' << share << ' ' << twist << ' ' << far;
          EXPECT_EQ(std::holds_alternative<Cylinder>(right->surface), share == 1.0);
          for (const double at : {0.0, 0.3, 0.8})
            for (int side = 0; side < 2; ++side) {
              const Vec3 p = point_on(right->surface,
                                      {std::lerp(right->u0, right->u1, at), right->v[side]});
              EXPECT_LT((p - ring->patch(0).ruling(at)[side]).norm(), 1e-9 * (below + far + 1.0));
            }
        }
}

TEST(RightSurface, IsACylinderIfTheCirclesDifferByRoundingOnly) {
  const auto is_cylinder = [](double radius, double share) {
    const auto right = found(ring_between(
        EllipseProfile{radius, radius}, EllipseProfile{radius * (1 + share), radius * (1 + share)},
        {0, 0, 2 * radius}));
    return right && std::holds_alternative<Cylinder>(right->surface);
  };
  for (const double radius : {5.0, 40.0, 5000.0}) {
    EXPECT_TRUE(is_cylinder(radius, 3e-13)) << radius;
    EXPECT_TRUE(is_cylinder(radius, -3e-13)) << radius;
    EXPECT_FALSE(is_cylinder(radius, 1e-8)) << radius;
    EXPECT_FALSE(is_cylinder(radius, -1e-8)) << radius;
  }
}

TEST(RightSurface, IsTheConeFromACornerAboveTheMiddleOfACircle) {
  for (const bool corner_first : {true, false}) {
    const Profile corner = PolygonProfile{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}};
    const Profile circle = EllipseProfile{30, 30};
    const Ring ring = corner_first ? ring_between(corner, circle, {0, 0, 80})
                                   : ring_between(circle, corner, {0, 0, 80});
    int cones = 0;
    for (const HullPatch& patch : ring.hull->patches) {
      if (patch.plane) continue;
      const auto right = right_surface(*ring.hull, patch);
      if (!right) continue;
      ++cones;
      const auto* cone = std::get_if<Cone>(&right->surface);
      ASSERT_NE(cone, nullptr);
      EXPECT_NEAR(cone->half_angle, std::atan2(30, 80), 1e-12);
      EXPECT_LT((cone->frame.origin - Vec3(0, 0, corner_first ? 0 : 80)).norm(), 1e-9);
      EXPECT_NEAR(right->v[corner_first ? 0 : 1], 0.0, 1e-9);
      EXPECT_NEAR(right->v[corner_first ? 1 : 0], std::hypot(30, 80), 1e-9);
      EXPECT_NEAR(std::abs(right->u1 - right->u0), 0.5 * kPi, 1e-12);
    }
    EXPECT_EQ(cones, 1) << "the other corners lie aside";
  }
}

}  // namespace
}  // namespace planish::test
