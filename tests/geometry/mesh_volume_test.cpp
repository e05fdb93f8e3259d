#include <planish/geometry/mesh_volume.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

/// A tetrahedron with three right angles, its corner at a point.
Mesh tetrahedron_at(const Vec3& p, double a, double b, double c) {
  return {{p, p + Vec3(a, 0, 0), p + Vec3(0, b, 0), p + Vec3(0, 0, c)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(MeshVolume, OfATetrahedronIsASixthOfItsBlock) {
  EXPECT_NEAR(volume_of(tetrahedron_at({0, 0, 0}, 3, 4, 5)), 10, 1e-12);
}

TEST(MeshVolume, IsTheSameFarFromTheOrigin) {
  EXPECT_NEAR(volume_of(tetrahedron_at({1e6, -2e6, 3e6}, 3, 4, 5)), 10, 1e-8);
}

TEST(MeshVolume, IsNegativeInsideOutAndNothingOfNothing) {
  Mesh turned = tetrahedron_at({7, 8, 9}, 3, 4, 5);
  for (auto& t : turned.triangles)
    std::swap(t[0], t[1]);
  EXPECT_NEAR(volume_of(turned), -10, 1e-12);
  EXPECT_EQ(volume_of(Mesh{}), 0.0);
}

TEST(MeshVolume, AddsUpOverPartsThatDoNotTouch) {
  Mesh both = tetrahedron_at({0, 0, 0}, 3, 4, 5);
  const Mesh other = tetrahedron_at({50, 60, 70}, 1, 2, 3);
  for (const auto& t : other.triangles)
    both.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  EXPECT_NEAR(volume_of(both), 11, 1e-12);
}

using Sides = std::vector<std::pair<int, int>>;

TEST(OpenSides, AreNoneOfAClosedMeshAndThoseRoundAHole) {
  Mesh mesh = tetrahedron_at({0, 0, 0}, 3, 4, 5);
  EXPECT_EQ(open_sides(mesh), Sides{});
  mesh.triangles.pop_back();  // 1 2 3
  EXPECT_EQ(open_sides(mesh), (Sides{{1, 3}, {2, 1}, {3, 2}}));
}

TEST(OpenSides, AreAllRoundATriangleThatIsTurnedOrThereTwice) {
  Mesh turned = tetrahedron_at({0, 0, 0}, 3, 4, 5), doubled = turned;
  turned.triangles.back() = {2, 1, 3};
  EXPECT_EQ(open_sides(turned), (Sides{{1, 3}, {2, 1}, {3, 2}}));
  doubled.triangles.push_back({1, 2, 3});
  EXPECT_EQ(open_sides(doubled), (Sides{{1, 2}, {1, 3}, {2, 1}, {2, 3}, {3, 1}, {3, 2}}));
}

}  // namespace
}  // namespace planish
