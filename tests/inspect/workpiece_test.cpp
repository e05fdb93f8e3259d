#include "workpiece.hpp"

#include "flat_plates.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace inspect_detail;

TEST(Workpiece, HasTwoSidesOfABendThatLookAwayFromIt) {
  const FlatPattern pattern = flat_l(30, 50);
  const Workpiece workpiece({}, pattern);
  ASSERT_EQ(workpiece.sides.size(), 2u);
  for (const BendSide& side : workpiece.sides) {
    EXPECT_NEAR(side.length(), 40.0, 1e-12);
    EXPECT_NEAR(std::abs(side.start.x()), 0.5 * zone_width(), 1e-12);
    EXPECT_NEAR((side.outward - Vec2(side.start.x() > 0 ? 1 : -1, 0)).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(workpiece.tangent_lines.size(), 2u);
}

TEST(Workpiece, TellsWindowsFromOpeningsInTheBend) {
  FlatPattern pattern = flat_l(30, 50);
  open(pattern, rectangular_opening({0, 38}, 8, 8));  // the bend ends at its edge
  open(pattern, circular_opening({0.5 * zone_width(), 20}, 3));
  open(pattern, circular_opening({20, 20}, 3));
  pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 34)}};
  pattern.bends[0].tangent_lines = {{Vec2(-0.5 * zone_width(), 0), Vec2(-0.5 * zone_width(), 34)},
                                    {Vec2(0.5 * zone_width(), 0), Vec2(0.5 * zone_width(), 17)},
                                    {Vec2(0.5 * zone_width(), 23), Vec2(0.5 * zone_width(), 34)}};
  const Workpiece workpiece({}, pattern);
  ASSERT_EQ(workpiece.openings.size(), 3u);
  EXPECT_TRUE(workpiece.openings[0].bounds.contains(0));
  EXPECT_TRUE(workpiece.openings[0].reaches_in.empty());
  EXPECT_TRUE(workpiece.openings[1].reaches_in.contains(0));
  EXPECT_TRUE(workpiece.openings[2].bounds.empty() && workpiece.openings[2].reaches_in.empty());
  EXPECT_EQ(workpiece.openings[0].size_text, "8 × 8 mm");
  EXPECT_EQ(workpiece.openings[1].size_text, "Ø 6 mm");
}

TEST(Workpiece, IsJoinedByMaterialOnlyWhereNothingIsCutOut) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, rectangular_opening({50, 30}, 2, 20));
  const Workpiece workpiece({}, pattern);
  EXPECT_FALSE(workpiece.joined_by_material({40, 30}, {60, 30}));
  EXPECT_TRUE(workpiece.joined_by_material({40, 5}, {60, 5}));
  EXPECT_FALSE(workpiece.openings[0].is_cut);
}

TEST(BendKinds, BeginAtTenThicknessesAndAt170Degrees) {
  FlatBend bend;
  bend.inside_radius = 20.0;
  EXPECT_FALSE(is_rolled(bend, 2.0));
  EXPECT_TRUE(is_rolled(bend, 1.99));
  bend.angle = Angle::degrees(169.9);
  EXPECT_FALSE(is_hem(bend));
  bend.angle = Angle::degrees(170);
  EXPECT_TRUE(is_hem(bend));
}

}  // namespace
}  // namespace planish::test
