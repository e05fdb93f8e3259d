#include "support/sheets.hpp"

#include <planish/geometry/mesh.hpp>
#include <planish/sheet/folded_blocks.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

/// Of a prism given by pairs of corners, below and above.
double prism_volume(const Block& block) {
  Vec3 twice_area = Vec3::Zero();
  for (std::size_t i = 4; i < block.size(); i += 2)
    twice_area += (block[i - 2] - block[0]).cross(block[i] - block[0]);
  return 0.5 * std::abs(twice_area.dot(block[1] - block[0]));
}

double volume_of(const Sheet& sheet, PartId part, double inset) {
  double sum = 0.0;
  for (const FaceId face : sheet.faces_of(part))
    for (const Block& block : folded_blocks(sheet, face, {.inset = inset}))
      sum += prism_volume(block);
  return sum;
}

TEST(FoldedBlocks, FillTheFlangesOfAnLBracket) {
  // 50 × 40 × 2 and 30 × 40 × 2.
  for (const Sheet& sheet : {l_bracket(), l_bracket_down()})
    for (const double inset : {0.0, 0.1, 0.5}) {
      const double wide = 40 - 2 * inset, thick = 2 - 2 * inset;
      EXPECT_NEAR(volume_of(sheet, FlangeId{0}, inset), (50 - 2 * inset) * wide * thick, 1e-4);
      EXPECT_NEAR(volume_of(sheet, FlangeId{1}, inset), (30 - 2 * inset) * wide * thick, 1e-4);
    }
}

TEST(FoldedBlocks, AreEmptyWhereNothingIsThatThick) {
  const Sheet sheet = l_bracket();
  for (const FaceId face : sheet.faces.ids())
    EXPECT_TRUE(folded_blocks(sheet, face, {.inset = 1.0}).empty());
}

TEST(FoldedBlocks, StayBetweenTheSkinsOfABend) {
  // 90° about the axis x = 50, z = 3 or, with the reference skin outside, elsewhere: r 3, t 2.
  for (const Sheet& sheet : {l_bracket(), l_bracket_down()}) {
    const FaceId face = sheet.bends[BendId{0}].faces.front();
    const auto& axis = std::get<Cylinder>(std::get<Developable>(sheet[face].surface)).frame;
    const double inset = 0.2;
    double turned = 0.0, radius_of_turned = 0.0, lowest = HUGE_VAL, highest = -HUGE_VAL;
    for (const Block& block : folded_blocks(sheet, face, {.inset = inset})) {
      ASSERT_EQ(block.size(), 8u);
      for (const Vec3& corner : block) {
        const Vec3 p = axis.local(corner);
        const double radius = p.head<2>().norm();
        EXPECT_GE(radius, 3 + inset - 1e-9);
        EXPECT_LE(radius, 5 - inset + 1e-9);
        lowest = std::min(lowest, p.z()), highest = std::max(highest, p.z());
      }
      const Vec2 from = axis.local2(block[0]), to = axis.local2(block[4]);
      turned += std::acos(from.dot(to) / (from.norm() * to.norm()));
      radius_of_turned = from.norm();
    }
    EXPECT_NEAR(highest - lowest, 40 - 2 * inset, 1e-9);
    // Set in by 0.2 mm from the planes at both ends, on each skin.
    EXPECT_NEAR(turned, std::numbers::pi / 2 - 2 * std::asin(inset / radius_of_turned), 1e-3);
  }
}

TEST(FoldedBlocks, EndAtTheMitreOfASharpBend) {
  // 30 | sharp 90° | 20, width 20, t 2. With the reference skin outside each flange reaches to the
  // corner, and the mitre takes t² / 2 of its section: blocks leave the whole t × t.
  const auto creased = [](BendDirection direction) {
    return strip({Straight{30}, Crease{Angle::degrees(90), direction}, Straight{20}}, 20, 2);
  };
  const Sheet outside = creased(BendDirection::down), inside = creased(BendDirection::up);
  ASSERT_FALSE(outside.bends[BendId{0}].reference_inside);
  EXPECT_NEAR(volume_of(outside, FlangeId{0}, 0.0), (30 - 2) * 20 * 2, 1e-4);
  EXPECT_NEAR(volume_of(outside, FlangeId{1}, 0.0), (20 - 2) * 20 * 2, 1e-4);
  EXPECT_NEAR(volume_of(inside, FlangeId{0}, 0.0), 30 * 20 * 2, 1e-4);
}

TEST(FoldedBlocks, LeaveOutOpeningsOfFlanges) {
  const Sheet plate = plate_with_holes();
  double with_holes = 0.0;
  for (const FaceId face : plate.faces.ids())
    for (const Block& block : folded_blocks(plate, face, {.inset = 0.0, .chord = 1e-3}))
      with_holes += prism_volume(block);
  EXPECT_NEAR(with_holes, *plate.volume, 1e-3 * *plate.volume);
}

TEST(FoldedBlocks, OfFlangesCoverWhatLiesInABox) {
  // An L bracket's 50 × 40 × 2 flange, and a box about the middle 10 mm of its width.
  const Sheet sheet = l_bracket();
  const FaceId flange = sheet.faces_of(FlangeId{0}).front();
  Box3 whole;
  for (const Block& block : folded_blocks(sheet, flange, {.inset = 0.5}))
    for (const Vec3& p : block)
      whole.extend(p);
  Eigen::Index across = 0;
  whole.sizes().minCoeff(&across);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (axis == across) continue;
    Box3 part = whole;
    part.min()[axis] = whole.center()[axis] - 5.0;
    part.max()[axis] = whole.center()[axis] + 5.0;
    double volume = 0.0;
    Box3 covered;
    for (const Block& block : folded_blocks(sheet, flange, {.inset = 0.5, .within = part})) {
      volume += prism_volume(block);
      for (const Vec3& p : block)
        covered.extend(p);
    }
    EXPECT_TRUE(covered.contains(part));
    const Vec3 sizes = covered.sizes();
    EXPECT_NEAR(volume, sizes.prod(), 1e-6 * volume);  // no gap
    EXPECT_LT(sizes[axis], 10.0 + 4 * 0.5);
  }
}

TEST(FoldedBlocks, LieWithinTheHull) {
  for (const Sheet& sheet : {l_bracket(), box(), cone_joined(), rolled(), lofted_corner()})
    for (const FaceId face : sheet.faces.ids()) {
      Box3 hull, blocks;
      for (const Vec3& p : hull_of(sheet, face, 0.01))
        hull.extend(p);
      for (const Block& block : folded_blocks(sheet, face, {.inset = 0.05}))
        for (const Vec3& p : block)
          blocks.extend(p);
      ASSERT_FALSE(blocks.isEmpty());
      EXPECT_TRUE(Box3(hull.min() - Vec3::Constant(1e-9), hull.max() + Vec3::Constant(1e-9))
                      .contains(blocks));
    }
}

}  // namespace
}  // namespace planish::test
