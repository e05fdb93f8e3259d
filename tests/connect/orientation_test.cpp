#include "orientation.hpp"

#include "sample_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::test {
namespace {

using namespace connect_detail;

/// Along every tangent line the outward normals of bend and plate are one.
void expect_consistent(const Parts& parts) {
  const Orientation sides = orientation_of(parts);
  ASSERT_EQ(sides.plates.size(), parts.plates.size());
  ASSERT_EQ(sides.bends.size(), parts.fits.size());
  EXPECT_EQ(sides.plates[parts.root], 1);
  for (int bend = 0; bend < static_cast<int>(parts.fits.size()); ++bend)
    for (int side = 0; side < 2; ++side) {
      const auto plate = parts.plate_of(bend, side);
      if (!plate) continue;
      const BendSurface& surface = parts.fits[bend].surface;
      const Vec3 of_bend = sides.bends[bend] * normal_on(surface.mid, surface.azimuth(side));
      const Vec3 of_plate = sides.plates[*plate] * parts.plates[*plate].frame.z;
      EXPECT_NEAR(of_bend.dot(of_plate), 1.0, 1e-9) << "bend " << bend << " side " << side;
    }
}

TEST(OrientationOf, GoesOnOverEveryBendWhicheverWayThePlatesRun) {
  for (int turned = 0; turned < 32; ++turned) {
    PlateStructure s = tray();
    for (int p = 0; p < 5; ++p)
      if (turned >> p & 1) std::ranges::reverse(s.plates[p].outline);
    expect_consistent(parts_of(s, turned % 5));
  }
}

TEST(OrientationOf, GoesOnOverConesAndHalfTurns) {
  expect_consistent(parts_of(cone_pair(), 1));
  expect_consistent(parts_of(u_pair(), 1));
}

TEST(OrientationOf, ASectionOfItsOwnIsThatOfItsSurface) {
  const Orientation sides = orientation_of(parts_of(pipe_structure()));
  EXPECT_TRUE(sides.plates.empty());
  EXPECT_EQ(sides.bends, std::vector{1});
}

}  // namespace
}  // namespace planish::test
