#include "same_surface.hpp"

#include <gtest/gtest.h>

namespace planish::brep {
namespace {

constexpr double kSize = 100.0;

SolidFace face_with(const Developable& surface, int sense = 1) {
  SolidFace face;
  face.surface = surface;
  face.sense = sense;
  return face;
}

Frame frame_at(const Vec3& origin, const Vec3& z = Vec3::UnitZ()) {
  return frame_from_normal(origin, z);
}

TEST(SameSurface, OfCylindersIsOneAxisAndRadius) {
  const SolidFace here = face_with(Cylinder{frame_at({0, 0, 0}), 5});
  EXPECT_TRUE(same_surface(here, face_with(Cylinder{frame_at({0, 0, 30}), 5}), kSize));
  EXPECT_TRUE(
      same_surface(here, face_with(Cylinder{frame_at({0, 0, 0}, -Vec3::UnitZ()), 5}), kSize))
      << "an axis has no sense";
  EXPECT_FALSE(same_surface(here, face_with(Cylinder{frame_at({0, 0, 0}), 5.001}), kSize));
  EXPECT_FALSE(same_surface(here, face_with(Cylinder{frame_at({0.001, 0, 0}), 5}), kSize));
  EXPECT_FALSE(
      same_surface(here, face_with(Cylinder{frame_at({0, 0, 0}, {0.01, 0, 1}), 5}), kSize));
}

TEST(SameSurface, HasTheMaterialOnOneSide) {
  const Cylinder cylinder{frame_at({0, 0, 0}), 5};
  EXPECT_FALSE(same_surface(face_with(cylinder, 1), face_with(cylinder, -1), kSize));
}

TEST(SameSurface, OfConesIsOneApexAxisAndAngle) {
  const SolidFace here = face_with(Cone{frame_at({0, 0, 0}), 0.5});
  EXPECT_TRUE(same_surface(here, face_with(Cone{frame_at({0, 0, 0}), 0.5}), kSize));
  EXPECT_FALSE(same_surface(here, face_with(Cone{frame_at({0, 0, 0.01}), 0.5}), kSize));
  EXPECT_FALSE(same_surface(here, face_with(Cone{frame_at({0, 0, 0}), 0.502}), kSize));
  EXPECT_FALSE(same_surface(here, face_with(Cone{frame_at({0, 0, 0}, -Vec3::UnitZ()), 0.5}), kSize))
      << "the other nappe";
}

TEST(SameSurface, AllowsForTheDeviationOfFits) {
  SolidFace fitted = face_with(Cylinder{frame_at({0, 0, 0}), 5.02});
  const SolidFace exact = face_with(Cylinder{frame_at({0, 0, 0}), 5});
  EXPECT_FALSE(same_surface(exact, fitted, kSize));
  fitted.fitted = 0.005;
  EXPECT_TRUE(same_surface(exact, fitted, kSize));
}

TEST(SameSurface, IsOfOneKind) {
  EXPECT_FALSE(same_surface(face_with(Cylinder{frame_at({0, 0, 0}), 5}),
                            face_with(Cone{frame_at({0, 0, 0}), 0.5}), kSize));
}

}  // namespace
}  // namespace planish::brep
