#include "joined_face.hpp"
#include "sample_parts.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace connect_detail;

double area_of(const Face& face) {
  double area = 0.0;
  for (const BorderLoop& loop : face.loops) {
    Loop curves;
    for (const Border& border : loop)
      curves.push_back(border.curve);
    area += signed_area(curves);
  }
  return area;
}

TEST(PlateFace, LiesHalfAThicknessOutwards) {
  const Parts parts = parts_of(angle_pair(14.0, 200, 4.0));
  for (const int sense : {1, -1}) {
    const auto made = plate_face(parts, 0, sense);
    ASSERT_TRUE(made);
    const Vec3 p = skin_point(made->face, {3, 4});
    EXPECT_NEAR(p.z(), 2.0 * sense, 1e-12);
    EXPECT_NEAR(outward_normal(made->face, {3, 4}).z(), sense, 1e-12);
  }
}

TEST(PlateFace, KeepsItsMaterialOnTheLeftSeenFromOutside) {
  PlateStructure s = angle_pair(14.0, 200, 4.0);
  s.plates[0].holes = {{{20, 20, 0}, {50, 20, 0}, {50, 40, 0}, {20, 40, 0}}};
  const Parts parts = parts_of(s);
  for (const int sense : {1, -1}) {
    const auto made = plate_face(parts, 0, sense);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->face.loops.size(), 2u);
    EXPECT_NEAR(area_of(made->face), 200 * 100 - 30 * 20, 1e-6);
  }
}

TEST(PlateFace, SaysWhichBorderEachBendHangsOn) {
  const Parts parts = parts_of(tray());
  for (const int sense : {1, -1}) {
    const auto made = plate_face(parts, 0, sense);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->joints.size(), 4u);
    for (const auto& joint : made->joints) {
      EXPECT_EQ(joint.plate, 0);
      const Border& border = made->face.loops[0][joint.border];
      const BendSurface& surface = parts.fits[joint.bend].surface;
      for (const double t : {0.0, 0.5, 1.0}) {
        const Vec3 skin = skin_point(made->face, point_at(border.curve, t));
        const Vec3 mid = skin - 1.5 * outward_normal(made->face, {0, 0});
        EXPECT_NEAR(surface.local(0, mid).y(), 0.0, 1e-9) << "on the tangent ruling";
      }
      EXPECT_NEAR(border.edge_length.value(), length(border.curve), 1e-12);
    }
  }
}

}  // namespace
}  // namespace planish::test
