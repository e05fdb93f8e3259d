#include "rib_solid.hpp"

#include "support/closed_mesh.hpp"

#include <planish/geometry/mesh_volume.hpp>
#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace slit_detail;

/// Two facets over a base of 3 + 2 mm by 4 mm: level at a height of 6 mm, then falling to 1 mm.
MouldRib falling_rib() {
  MouldRib rib;
  rib.facets = {{Vec3(0, 0, 6), Vec3(3, 0, 6), Vec3(3, 4, 6), Vec3(0, 4, 6)},
                {Vec3(3, 0, 6), Vec3(5, 0, 1), Vec3(5, 4, 1), Vec3(3, 4, 6)}};
  return rib;
}

/// The same with left and right exchanged, as on the half that is a mirror image.
MouldRib other_way_round(MouldRib rib) {
  for (auto& facet : rib.facets) {
    std::swap(facet[0], facet[3]);
    std::swap(facet[1], facet[2]);
  }
  return rib;
}

Frame base_at(double height) {
  Frame base;
  base.origin = Vec3(0, 0, height);
  return base;
}

TEST(RibSolid, HasTheVolumeOfThePrismsBelowItsFacets) {
  for (const MouldRib& rib : {falling_rib(), other_way_round(falling_rib())}) {
    const Mesh mesh = closed_mesh(rib, base_at(-2.0));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume_of(mesh), 4.0 * (3.0 * 8.0 + 2.0 * (8.0 + 3.0) / 2.0), 1e-12);
  }
}

TEST(RibSolid, StandsOnItsFootprint) {
  for (const MouldRib& rib : {falling_rib(), other_way_round(falling_rib())})
    EXPECT_NEAR(ring_area(footprint_of(rib, base_at(-2.0))), 5.0 * 4.0, 1e-12);
}

TEST(RibSolid, GoesDownAlongTheNormalOfALeaningBase) {
  Frame base;  // turned about y: straight down from the facets is no longer along z
  base.z = Vec3(0.6, 0.0, 0.8);
  base.x = Vec3(0.8, 0.0, -0.6);
  base.origin = -10.0 * base.z;
  const Mesh mesh = closed_mesh(falling_rib(), base);
  EXPECT_TRUE(is_closed(mesh));
  const int half = static_cast<int>(mesh.points.size()) / 2;
  for (int i = 0; i < half; ++i) {
    EXPECT_NEAR((mesh.points[i] - mesh.points[i + half]).cross(base.z).norm(), 0.0, 1e-12);
    EXPECT_NEAR(base.local(mesh.points[i + half]).z(), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace planish::test
