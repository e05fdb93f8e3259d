#include <planish/geometry/frame.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

TEST(Frames, AreOrthonormalAndRightHanded) {
  for (const Vec3& z : {Vec3(0, 0, 2), Vec3(1e-9, 0, 0), Vec3(-3, 4, 12), Vec3(1e200, 1e200, 0)}) {
    const Frame f = frame_from_normal({1, 2, 3}, z);
    EXPECT_NEAR(f.z.dot(z.stableNormalized()), 1.0, 1e-15);
    EXPECT_NEAR((f.x.cross(f.y) - f.z).norm(), 0.0, 1e-15);
    EXPECT_NEAR(f.x.norm(), 1.0, 1e-15);
    EXPECT_NEAR(f.x.dot(f.z), 0.0, 1e-15);
  }
}

TEST(Frames, FollowTheHintForX) {
  const Frame f = frame_from_axes(Vec3::Zero(), {0, 0, 1}, {3, 0, 100});
  EXPECT_NEAR((f.x - Vec3::UnitX()).norm(), 0.0, 1e-14);
  // A hint only 1e-9 off the axis still gives a right angle.
  const Frame g = frame_from_axes(Vec3::Zero(), {1, 2, 3}, Vec3(1, 2, 3) + 1e-9 * Vec3(0, 0, 1));
  EXPECT_NEAR(g.x.dot(g.z), 0.0, 1e-15);
}

}  // namespace
}  // namespace planish::test
