#include "support/sheets.hpp"

#include <planish/geometry/mesh.hpp>
#include <planish/geometry/plane.hpp>
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

TEST(FoldedBlocks, AreEmptyWhereNothingIsThatWide) {
  // A strip 0.7 wide holds balls of a radius of 0.3, but none of 0.4.
  const Sheet sheet = strip(
      {Straight{50}, Turn{Angle::degrees(90), 3.0, BendDirection::up}, Straight{30}}, 0.7, 2.0);
  for (const FaceId face : sheet.faces.ids()) {
    EXPECT_FALSE(folded_blocks(sheet, face, {.inset = 0.3}).empty());
    EXPECT_TRUE(folded_blocks(sheet, face, {.inset = 0.4}).empty());
  }
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

TEST(FoldedBlocks, StayAwayFromTheRulingsAtBothEndsOfABend) {
  // By the inset, straight across the ruling, on both skins and at both rims: near the apex of a
  // cone, and where an oblique one is wide or narrow.
  const double inset = 0.05;
  for (const Sheet& sheet : {l_bracket(), cone_joined(), lofted_corner()}) {
    const Face& face = sheet[sheet.bends[BendId{0}].faces.front()];
    const auto& surface = std::get<Developable>(face.surface);
    const Box2 box = parameter_box(face);
    const auto blocks = folded_blocks(sheet, sheet.bends[BendId{0}].faces.front(),
                                      {.inset = inset});
    ASSERT_GT(blocks.size(), 2u);
    const auto across = [&](double u, const Vec3& p) {
      const Vec3 along = ruling_on(surface, u).normalized();
      return std::abs(
          along.cross(outward_normal(face, {u, 0.0})).dot(p - point_on(surface, {u, 0.0})));
    };
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(across(box.lo.x(), blocks.front()[i]), inset, 0.01 * inset) << i;
      EXPECT_NEAR(across(box.hi.x(), blocks.back()[4 + i]), inset, 0.01 * inset) << i;
    }
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

TEST(FoldedBlocks, EndAtTheMitreWhateverItsAngleAndTheDepthOfTheReference) {
  // What lies `below` the reference surface on the outside of the bend ends `below`·tan(α/2) before
  // the border: of a reference `depth` below the outer side, the rest of the thickness or `depth`.
  for (const double thickness : {2.0, 0.8})
    for (const double degrees : {50.0, 90.0, 120.0})
      for (const double share : {0.0, 0.25, 1.0})
        for (const auto direction : {BendDirection::up, BendDirection::down}) {
          Sheet sheet = strip(
              {Straight{30}, Crease{Angle::degrees(degrees), direction}, Straight{20}}, 20,
              thickness);
          sheet.reference_depth = share * thickness;
          const double below = direction == BendDirection::up ? share * thickness
                                                              : (1.0 - share) * thickness;
          const double mitre = below * std::tan(Angle::degrees(degrees).radians() / 2);
          EXPECT_NEAR(volume_of(sheet, FlangeId{0}, 0.0), (30 - mitre) * 20 * thickness, 1e-4);
          EXPECT_NEAR(volume_of(sheet, FlangeId{1}, 0.0), (20 - mitre) * 20 * thickness, 1e-4);
        }
}

TEST(FoldedBlocks, LeaveOutTheMitreOnlyAlongTheWallThatStandsThere) {
  // The middle 20 of a side of 40 carry the wall. Blocks stay away from the mitre by the inset too:
  // the corners of what is left there are round.
  SheetBuilder builder(2.0);
  const FaceId base = builder.flange(
      {}, {polygon({{0, 0}, {30, 0}, {30, 10}, {30, 30}, {30, 40}, {0, 40}})});
  const Rim rim = builder.crease(builder.rim(base, 2), {Angle::degrees(60), BendDirection::down});
  builder.flange_behind(rim, {rectangle(20, 15)});
  const Sheet sheet = builder.finish();
  const double mitre = 2 * std::tan(Angle::degrees(30).radians());
  for (const double inset : {0.0, 0.1, 0.4}) {
    const double whole = (30 - 2 * inset) * (40 - 2 * inset), thick = 2 - 2 * inset;
    const double rounded = 2 * (1 - std::numbers::pi / 4) * inset * inset;
    EXPECT_NEAR(volume_of(sheet, FlangeId{0}, inset),
                (whole - mitre * (20 + 2 * inset) + rounded) * thick, 1e-4 + 0.02 * inset * inset)
        << inset;
    EXPECT_NEAR(volume_of(sheet, FlangeId{1}, inset),
                (15 - mitre - 2 * inset) * (20 - 2 * inset) * thick, 1e-4)
        << inset;
  }
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

TEST(FoldedBlocks, OfATurnedFlangeCoverWhatLiesInABox) {
  // However the flange lies to the axes of the box, no point of its material in the box is missing.
  const Sheet plate = l_bracket();
  for (const Vec3& axis : {Vec3(1, 2, 3), Vec3(-3, 1, 1), Vec3(1, -2, 1), Vec3(2, 1, -4)}) {
    const Eigen::Isometry3d motion(Eigen::AngleAxisd(0.9, axis.normalized()));
    const Sheet sheet = moved(plate, motion);
    const FaceId flange = sheet.faces_of(FlangeId{0}).front();
    const auto& frame = std::get<Frame>(sheet[flange].surface);
    const Vec3 middle = skin_point(sheet[flange], {25, 20});
    const Box3 part(middle - Vec3::Constant(6), middle + Vec3::Constant(6));
    const auto blocks = folded_blocks(sheet, flange, {.inset = 0.0, .within = part});
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60; ++j) {
        const Vec2 at(10.123 + 0.5 * i, 5.123 + 0.5 * j);
        if (!part.contains(skin_point(sheet[flange], at))) continue;
        const bool held = std::ranges::any_of(blocks, [&](const Block& block) {
          std::vector<Vec2> triangle;
          for (const std::size_t k : {0u, 2u, 4u})
            triangle.push_back(frame.local2(block[k]));
          if (ring_area(triangle) < 0.0) std::ranges::reverse(triangle);
          return std::ranges::all_of(std::array{0, 1, 2}, [&](int k) {
            return cross(triangle[(k + 1) % 3] - triangle[k], at - triangle[k]) >= -1e-9;
          });
        });
        EXPECT_TRUE(held) << at.transpose();
      }
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
