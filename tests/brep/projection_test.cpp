#include "projection.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

TEST(ProjectedArea, TakesOffWhatLooksTheOtherWay) {
  const SolidModel model = plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {4, 0}}}});
  const Frame up;
  EXPECT_NEAR(projected_area(model, 0, up), -(6000 - 16 * pi), 1e-7) << "the bottom";
  EXPECT_NEAR(projected_area(model, 1, up), 6000 - 25 * pi, 1e-7) << "the top";
  for (int wall = 2; wall < 6; ++wall)
    EXPECT_NEAR(projected_area(model, wall, up), 0.0, 1e-9);
  EXPECT_NEAR(projected_area(model, 6, up), 9 * pi, 1e-7) << "a cone that narrows downwards";
  // Seen along a direction at 60° to the normal a plane shows half its area.
  const Frame tilted = frame_from_normal({7, -3, 2}, {std::sqrt(0.75), 0, 0.5});
  EXPECT_NEAR(projected_area(model, 1, tilted), (6000 - 25 * pi) / 2, 1e-7);
}

TEST(ProjectedArea, OfAClosedBodyAddsUpToNothing) {
  const SolidModel model = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  const Frame any = frame_from_normal({1, 2, 3}, Vec3(1, -2, 3).normalized());
  double sum = 0.0;
  for (int f = 0; f < std::ssize(model.faces); ++f)
    sum += projected_area(model, f, any);
  EXPECT_NEAR(sum, 0.0, 1e-7);
}

TEST(VolumeOver, OfAConeIsThatOfItsRingAndOfTheFrustum) {
  const SolidModel model = plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {4, 0}}}});
  const double frustum = 2 * pi / 3 * (25 + 20 + 16);
  const Frame bottom;
  EXPECT_NEAR(volume_over(model, 6, bottom), 2 * 25 * pi - frustum, 1e-7)
      << "the cone narrows downwards: what lies below it is solid";
  Frame top;
  top.origin = {5, 6, 2};
  EXPECT_NEAR(volume_over(model, 6, top), 16 * 2 * pi - frustum, 1e-7) << "below the plane";
  EXPECT_NEAR(volume_over(model, 1, bottom), 2 * (6000 - 25 * pi), 1e-7);
}

TEST(VolumeOver, OfAClosedBodyIsItsVolumeAlongAnyDirection) {
  const SolidModel model = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  const Frame any = frame_from_normal({1, 2, 3}, Vec3(1, -2, 3).normalized());
  double sum = 0.0, volume = 0.0;
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    sum += volume_over(model, f, any);
    volume += model.faces[f].volume;
  }
  EXPECT_NEAR(sum, volume, 1e-6);
}

}  // namespace
}  // namespace planish::brep::test
