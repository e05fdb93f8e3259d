#include "rip_joint.hpp"
#include "support/folded_box.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/rip.hpp>

#include <gtest/gtest.h>

#include <array>

namespace planish::test {
namespace {

TEST(Ripped, BoxLosesTheCornersBetweenItsWallsAndTheirBlocks) {
  const FoldedBox box = folded_box({.length = 80, .width = 50, .height = 20, .thickness = 2});
  const auto open = ripped(box.sheet, box.upright);
  ASSERT_TRUE(open) << open.error().message;
  EXPECT_EQ(open->joints.size(), 4u);
  EXPECT_EQ(open->bends.size(), 4u);
  // Base, walls, and the prisms along the edges of the base.
  EXPECT_NEAR(*box.sheet.volume, 84.0 * 54 * 22 - 80 * 50 * 20, 1e-9);
  EXPECT_NEAR(*open->volume, 2 * (80 * 50 + 2 * (80 + 50) * 20) + 2 * (80 + 50) * 4, 1e-9);
  EXPECT_EQ(*open->genus, 0);
  ASSERT_TRUE(check(*open));
  ASSERT_TRUE(flatten(*open));
}

TEST(Ripped, OneWallAtATime) {
  const FoldedBox box = folded_box({.length = 80, .width = 50, .height = 20, .thickness = 2});
  const auto open = ripped(box.sheet, std::array{box.upright[2]});
  ASSERT_TRUE(open);
  EXPECT_NEAR(*box.sheet.volume - *open->volume, 4 * 20 + 8, 1e-9);
  EXPECT_EQ(open->joints.size(), 7u);
  EXPECT_EQ(open->bends.size(), 7u);
  EXPECT_NEAR(box.sheet.mitres_volume - open->mitres_volume, mitre_of(2, 20), 1e-9);
}

TEST(Ripped, TubeHasNoOpeningLeft) {
  const Sheet tube = folded_tube(40, 30, 100, 2);
  EXPECT_EQ(*tube.genus, 1);
  const auto open = ripped(tube, std::array{*tube[tube.joints.back().a].edge});
  ASSERT_TRUE(open);
  EXPECT_EQ(*open->genus, 0);
  // No third wall ends there: the prism alone.
  EXPECT_NEAR(*tube.volume - *open->volume, 4 * 100, 1e-9);
  EXPECT_TRUE(flatten(*open));
}

TEST(Ripped, AlongNothingIsTheSheet) {
  EXPECT_EQ(ripped(folded_tube(40, 30, 100, 2), {})->joints.size(), 4u);
}

TEST(Ripped, RefusesEdgesThatNoWallsShare) {
  const Sheet tube = folded_tube(40, 30, 100, 2);
  const auto refusal = [&](const Sheet& sheet, int edge) {
    const auto open = ripped(sheet, std::array{edge});
    return open ? code::internal : open.error().code;
  };
  EXPECT_EQ(refusal(tube, 999), code::bad_option);
  // Walls that meet by their outside.
  Sheet outside = tube;
  outside.bends[*tube.joints[1].sharp].reference_inside = false;
  EXPECT_EQ(refusal(outside, *tube[tube.joints[1].a].edge), code::bad_option);
  EXPECT_TRUE(sheet_detail::can_be_ripped(tube, tube.joints[1]));
  EXPECT_FALSE(sheet_detail::can_be_ripped(outside, tube.joints[1]));
  Sheet made = tube;
  made[made.joints[1].a].edge.reset();
  EXPECT_FALSE(sheet_detail::can_be_ripped(made, made.joints[1])) << "no edge";
  // Of an L there are two parts.
  const Sheet bracket = l_bracket();
  EXPECT_EQ(refusal(bracket, *bracket[bracket.joints[0].a].edge), code::bad_option);
  EXPECT_TRUE(sheet_detail::can_be_ripped(bracket, bracket.joints[0])) << "smooth";
}

}  // namespace
}  // namespace planish::test
