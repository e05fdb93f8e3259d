#include "fit_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep {
namespace {

using std::numbers::pi;

Frame placed_frame() { return frame_from_axes({50, -30, 20}, {2, -1, 2}, {1, 2, 0}); }

std::vector<SurfaceSample> samples_on(const Developable& surface, const Box2& box, double sense) {
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 5; ++j) {
      const Vec2 uv = box.lo + box.size().cwiseProduct(Vec2(i / 6.0, j / 4.0));
      samples.push_back({point_on(surface, uv), sense * normal_on(surface, uv.x())});
    }
  return samples;
}

std::vector<SurfaceSample> samples_of_plane() {
  const Frame frame = placed_frame();
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      samples.push_back({frame.point({10.0 * i, 7.0 * j}), frame.z});
  return samples;
}

TEST(FitSurface, FindsAPlaneWithItsNormalAndItsDeviation) {
  auto samples = samples_of_plane();
  auto fit = fit_surface(samples, 0.01);
  ASSERT_TRUE(fit);
  const Frame& plane = std::get<Frame>(fit->surface);
  EXPECT_NEAR((plane.z - placed_frame().z).norm(), 0.0, 1e-12);
  EXPECT_NEAR((plane.origin - placed_frame().origin).dot(plane.z), 0.0, 1e-12);
  EXPECT_NEAR(fit->deviation, 0.0, 1e-12);
  // One of twelve points 0.012 above: the mean rises by 0.001, so it stands out by 0.011.
  samples[5].point += 0.012 * plane.z;
  EXPECT_FALSE(fit_surface(samples, 0.0105));
  fit = fit_surface(samples, 0.0115);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->deviation, 0.011, 1e-12);
}

TEST(FitSurface, FindsACylinderSeenFromInsideAndFromOutside) {
  const Cylinder cylinder{placed_frame(), 12};
  for (const double sense : {1.0, -1.0}) {
    const auto fit = fit_surface(samples_on(cylinder, {{0.2, 5}, {1.4, 30}}, sense), 1e-6);
    ASSERT_TRUE(fit);
    const Cylinder& found = std::get<Cylinder>(std::get<Developable>(fit->surface));
    EXPECT_NEAR(found.radius, 12, 1e-9);
    EXPECT_NEAR(std::abs(found.frame.z.dot(cylinder.frame.z)), 1, 1e-12);
    EXPECT_NEAR((found.frame.origin - cylinder.frame.origin).cross(cylinder.frame.z).norm(), 0.0,
                1e-9);
    EXPECT_NEAR(fit->deviation, 0.0, 1e-9);
  }
}

TEST(FitSurface, FindsAConeThatOpensTowardsItsSamples) {
  for (const double angle : {0.1, 0.6, 1.3})
    for (const double sense : {1.0, -1.0}) {
      const Cone cone{placed_frame(), angle};
      const auto fit = fit_surface(samples_on(cone, {{0.2, 20}, {1.9, 45}}, sense), 1e-6);
      ASSERT_TRUE(fit);
      const Cone& found = std::get<Cone>(std::get<Developable>(fit->surface));
      EXPECT_NEAR(found.half_angle, angle, 1e-9);
      EXPECT_NEAR((found.frame.z - cone.frame.z).norm(), 0.0, 1e-9);
      EXPECT_NEAR((found.frame.origin - cone.frame.origin).norm(), 0.0, 1e-7);
    }
}

TEST(FitSurface, FindsNothingOnASphereAndWithFewSamples) {
  std::vector<SurfaceSample> sphere;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const double a = 0.2 * i, b = 0.2 * j;
      const Vec3 n(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
      sphere.push_back({40 * n, n});
    }
  EXPECT_FALSE(fit_surface(sphere, 0.1));
  auto three = samples_of_plane();
  three.resize(3);
  EXPECT_FALSE(fit_surface(three, 0.1));
  three = samples_of_plane();
  three.resize(4);
  EXPECT_TRUE(fit_surface(three, 0.1));
}

TEST(FitSurface, WantsNormalsThatAgreeAndNotPointsAlone) {
  auto leaning = samples_of_plane();
  const Frame frame = placed_frame();
  leaning[3].normal = (frame.z + 0.1 * frame.x).normalized();
  leaning[7].normal = (frame.z - 0.1 * frame.x + 0.08 * frame.y).normalized();
  EXPECT_FALSE(fit_surface(leaning, 0.01));
  auto bent = samples_on(Cylinder{frame, 12}, {{0.2, 5}, {1.4, 30}}, 1.0);
  bent[9].normal = (bent[9].normal + 0.05 * frame.z).normalized();
  EXPECT_FALSE(fit_surface(bent, 1e-3));
}

TEST(FitSurface, FitsSmallBendsMoreCloselyThanTheTolerance) {
  // A twentieth of the radius: a point 0.02 off a radius of 0.2 is too far, whatever is allowed.
  auto samples = samples_on(Cylinder{placed_frame(), 0.2}, {{0.2, 0}, {1.4, 5}}, 1.0);
  samples[17].point += 0.02 * samples[17].normal;
  EXPECT_FALSE(fit_surface(samples, 0.05));
  EXPECT_TRUE(
      fit_surface(samples_on(Cylinder{placed_frame(), 0.2}, {{0.2, 0}, {1.4, 5}}, 1.0), 0.05));
}

}  // namespace
}  // namespace planish::brep
