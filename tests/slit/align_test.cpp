#include "align.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace slit_detail;

/// Two quads of 80 × 80 mm at a right angle.
FoldedStrip corner_of_a_box() {
  FoldedStrip strip;
  const auto add_ridge = [&](double along, const Vec3& left, const Vec3& right) {
    strip.ridges.push_back({{Vec2(along, 0), Vec2(along, 80)}, {left, right}, {}});
  };
  add_ridge(0, {0, 0, 0}, {0, 80, 0});
  add_ridge(80, {80, 0, 0}, {80, 80, 0});
  add_ridge(160, {80, 0, 80}, {80, 80, 80});
  strip.quads = {frame_from_axes({0, 0, 0}, Vec3::UnitZ(), Vec3::UnitX()),
                 frame_from_axes({80, 0, -80}, -Vec3::UnitX(), Vec3::UnitZ())};
  return strip;
}

/// Points where the strip's surface is sampled: midway in eighths along, at sixteenths across.
std::vector<Vec3> sampled(const FoldedStrip& strip) {
  std::vector<Vec3> points;
  for (std::size_t quad = 0; quad < strip.quads.size(); ++quad)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j <= 16; ++j)
        points.push_back(
            strip.quads[quad].point({80.0 * static_cast<double>(quad) + 10 * i + 5, 5.0 * j}));
  return points;
}

TEST(AligningMotion, UndoesASmallMotion) {
  const FoldedStrip strip = corner_of_a_box();
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.rotate(Eigen::AngleAxisd(0.01, Vec3(2, -1, 3).normalized()));
  moved.pretranslate(Vec3(0.6, -0.8, 0.5));
  std::vector<Vec3> points = sampled(strip);
  for (Vec3& p : points)
    p = moved * p;
  const Eigen::Isometry3d back = aligning_motion({{points, strip}}) * moved;
  // Every point is 5 mm from the next, so each finds the one that it came from.
  EXPECT_NEAR(back.translation().norm(), 0.0, 1e-4);
  EXPECT_NEAR((back.linear() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-6);
}

TEST(AligningMotion, LeavesWhatIsInPlace) {
  const FoldedStrip strip = corner_of_a_box();
  const std::vector<Vec3> points = sampled(strip);
  const Eigen::Isometry3d motion = aligning_motion({{points, strip}});
  EXPECT_NEAR((motion.matrix() - Eigen::Matrix4d::Identity()).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
