#include "regions.hpp"

#include "flat_plates.hpp"
#include "support/sheets.hpp"

#include <planish/inspect/findings.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using namespace inspect_detail;
using std::numbers::pi;

constexpr double kRegionChord = 1e-4;

/// The regions of a sheet laid flat with K 0.4, as it is or seen from its other side.
inspect_detail::Regions regions_flat(const Sheet& sheet, UpSide up = UpSide::reference) {
  FlattenOptions options;
  options.allowance = ConstantK{0.4, "test"};
  options.up = up;
  return regions_of(sheet, lay_out(sheet, options).value(), kRegionChord);
}

Sheet creased_strip(double degrees, BendDirection direction) {
  return strip({Straight{50}, Crease{Angle::degrees(degrees), direction}, Straight{30}}, 40, 2);
}

TEST(ContactClearance, IsAThousandthOfTheThicknessOrWhatCurvesAndCyclesMiss) {
  FlatPattern pattern;
  pattern.thickness = 2.0;
  EXPECT_DOUBLE_EQ(contact_clearance(pattern), 0.002);
  pattern.thickness = 0.1;
  EXPECT_DOUBLE_EQ(contact_clearance(pattern), 2e-4) << "curves, to 1e-4 on either side";
  pattern.closure = 0.01;
  EXPECT_DOUBLE_EQ(contact_clearance(pattern), 2e-4 + 0.005) << "and half of what a cycle misses";
}

TEST(RegionsOf, AStripAreItsFacesWithTheirAreas) {
  const auto regions = regions_flat(l_bracket());  // 50 | 90° r 3 | 30, 40 wide, t 2
  ASSERT_EQ(regions.polygons.size(), 3u);
  EXPECT_TRUE(regions.shared.empty());
  double area = 0.0;
  for (const Polygon& polygon : regions.polygons)
    area += std::abs(ring_area(polygon.outer));
  EXPECT_NEAR(area, 40 * (80 + pi / 2 * 3.8), 1e-6);
  for (std::size_t i = 0; i < regions.faces.size(); ++i)
    EXPECT_EQ(regions.parts[i], l_bracket()[*regions.faces[i]].part_of);
}

TEST(RegionsOf, ASharpBendFoldedUpHaveABandAsWideAsItsAllowance) {
  const auto regions = regions_flat(creased_strip(90, BendDirection::up));
  ASSERT_EQ(regions.polygons.size(), 3u);
  EXPECT_TRUE(regions.shared.empty());
  EXPECT_EQ(regions.parts[2], PartId(BendId{0}));
  EXPECT_FALSE(regions.faces[2]);
  EXPECT_NEAR(std::abs(ring_area(regions.polygons[2].outer)), 40 * pi / 2 * 0.8, 1e-9);
}

TEST(RegionsOf, ASharpBendWhoseFacesReachOverEachOtherLetThemShareThatArea) {
  // Laid out without setting back, the faces overlap by two setbacks less the allowance.
  const Sheet sheet = creased_strip(90, BendDirection::up);
  Layout layout = lay_out(sheet).value();
  const double gap = layout.allowance[BendId{0}].allowance;
  // The second face starts at x = 50 + gap; over the first by 1.5 instead.
  layout.placement[FaceId{1}] = Eigen::Translation2d(-gap - 1.5, 0) * layout.placement[FaceId{1}];
  Isometry2 back = Isometry2::Identity();
  back.translation() = Vec2(-gap - 1.5, 0);
  for (Loop& loop : layout.images[FaceId{1}])
    loop = transformed(loop, back);
  for (const bool mirrored : {false, true}) {
    Isometry2 mirror = Isometry2::Identity();
    mirror.linear()(0, 0) = mirrored ? -1.0 : 1.0;
    Layout seen = layout;
    seen.move(mirror);
    const auto regions = regions_of(sheet, seen, kRegionChord);
    EXPECT_EQ(regions.polygons.size(), 2u);
    ASSERT_EQ(regions.shared.size(), 1u);
    EXPECT_NEAR(regions.shared.begin()->second, 40 * 1.5, 1e-9);
    EXPECT_TRUE(shared_areas(regions, 0.002).empty()) << "explained by the bend";
  }
}

Polygon square_region(double x, double y, double side) {
  return polygon_of({shifted(rectangle(side, side), Vec2(x, y)), {}}, kRegionChord);
}

/// Squares of 10, each a flange of its own.
inspect_detail::Regions squares(const std::vector<Vec2>& corners) {
  inspect_detail::Regions regions;
  for (int i = 0; i < std::ssize(corners); ++i) {
    regions.polygons.push_back(square_region(corners[i].x(), corners[i].y(), 10));
    regions.parts.emplace_back(FlangeId{i});
    regions.faces.emplace_back(FaceId{i});
  }
  return regions;
}

TEST(SharedAreas, AreWholeAlthoughBothRegionsAreShrunkFirst) {
  for (const double clearance : {0.001, 0.01}) {
    const auto found = shared_areas(squares({{0, 0}, {7, 4}}), clearance);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first, PartId(FlangeId{0}));
    EXPECT_EQ(found[0].second, PartId(FlangeId{1}));
    // Only the corners of the rim are missing.
    EXPECT_NEAR(found[0].area, 3 * 6, 5 * clearance * clearance);
  }
  EXPECT_TRUE(shared_areas(squares({{0, 0}, {9.9, 0}}), 0.06).empty()) << "a mere contact";
}

TEST(SharedAreas, LeaveOutWhatFacesMayShareAndNoMore) {
  auto regions = squares({{0, 0}, {8, 0}});
  regions.shared[std::minmax(regions.faces[0], regions.faces[1])] = 20.0;
  EXPECT_TRUE(shared_areas(regions, 1e-4).empty());
  regions.shared.begin()->second = 19.9;
  EXPECT_EQ(shared_areas(regions, 1e-4).size(), 1u);
  auto other = squares({{0, 0}, {8, 0}, {0, 50}});
  other.shared[std::minmax(other.faces[0], other.faces[2])] = 20.0;
  EXPECT_EQ(shared_areas(other, 1e-4).size(), 1u) << "another pair's";
}

TEST(SharedAreas, NameTheLowerPartFirst) {
  auto regions = squares({{0, 0}, {8, 0}});
  std::swap(regions.parts[0], regions.parts[1]);
  const auto found = shared_areas(regions, 1e-4);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, PartId(FlangeId{0}));
  EXPECT_EQ(found[0].second, PartId(FlangeId{1}));
}

}  // namespace
}  // namespace planish::test
