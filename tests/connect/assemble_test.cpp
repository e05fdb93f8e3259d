#include "assemble.hpp"

#include "sample_parts.hpp"

#include <gtest/gtest.h>

#include <set>

namespace planish::test {
namespace {

using namespace connect_detail;

Assembled made(const Parts& parts) {
  auto result = assembled(parts);
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? std::move(*result) : Assembled{};
}

TEST(Assembled, NumbersFlangesAsPlatesAndBendsAsFits) {
  const Parts parts = parts_of(tray(), 2);
  const Assembled result = made(parts);
  EXPECT_TRUE(check(result.sheet));
  ASSERT_EQ(result.sheet.flanges.size(), 5u);
  ASSERT_EQ(result.sheet.bends.size(), 4u);
  for (int p = 0; p < 5; ++p) {
    const FaceId face = result.plate_faces[p];
    EXPECT_EQ(result.sheet[face].part_of, PartId{static_cast<FlangeId>(p)});
    const Vec3 corner = parts.plates[p].corner(0) - skin_point(result.sheet[face], {0, 0});
    EXPECT_NEAR(std::abs(corner.dot(parts.plates[p].frame.z)), 1.5, 1e-9);
  }
  for (int b = 0; b < 4; ++b)
    EXPECT_EQ(result.sheet[result.bends[b]].inside_radius, parts.fits[b].report.inside_radius);
  EXPECT_EQ(result.root, result.plate_faces[2]);
}

TEST(Assembled, JoinsBordersThatAreOneEdgeRunBothWays) {
  const Assembled result = made(parts_of(tray()));
  ASSERT_EQ(result.sheet.joints.size(), 8u);
  std::set<int> edges;
  for (const Joint& joint : result.sheet.joints) {
    const Face &a = result.sheet[joint.a.face], &b = result.sheet[joint.b.face];
    for (const double t : {0.0, 0.5, 1.0})
      EXPECT_LT((skin_point(a, point_at(result.sheet[joint.a].curve, t)) -
                 skin_point(b, point_at(result.sheet[joint.b].curve, 1.0 - t)))
                    .norm(),
                1e-9);
    EXPECT_EQ(result.sheet[joint.a].edge, result.sheet[joint.b].edge);
    edges.insert(result.sheet[joint.a].edge.value());
  }
  EXPECT_EQ(edges.size(), 8u);
}

TEST(Assembled, SaysOnWhichSideABendIs) {
  // The reference skin of the floor is the one that the walls stand on, or the other.
  for (const bool turned : {false, true}) {
    PlateStructure s = tray();
    if (turned) std::ranges::reverse(s.plates[0].outline);
    for (const Bend& bend : made(parts_of(s)).sheet.bends)
      EXPECT_EQ(bend.reference_inside, !turned);
  }
}

TEST(Assembled, MakesASectionOfItsOwn) {
  const Assembled result = made(parts_of(pipe_structure()));
  EXPECT_EQ(result.sheet.faces.size(), 1u);
  EXPECT_TRUE(result.sheet.joints.empty());
  EXPECT_EQ(result.root, FaceId{0});
}

}  // namespace
}  // namespace planish::test
