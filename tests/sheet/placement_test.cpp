#include "placement.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

// A base of 50 × 40 with a narrower wall folded sharply from its side x = 50: where the wall lies
// is where its border lies in space, one allowance further out.

namespace planish::test {
namespace {

using std::numbers::pi;

/// The wall is 20 wide, from y = `from` on, and 30 high. It and the base are given in either order.
Sheet trimmed_crease(double from, BendDirection direction = BendDirection::up) {
  SheetBuilder builder(2.0);
  const FaceId base = builder.flange({}, {rectangle(50, 40)});
  Rim rim = builder.crease(builder.rim(base, 1), {Angle::degrees(90), direction});
  rim.frame.origin += from * rim.frame.y;
  rim.length = 20;
  builder.flange_behind(rim, {rectangle(20, 30)});
  return builder.finish();
}

Layout laid_from(const Sheet& sheet, FaceId root, double k = 0.4) {
  FlattenOptions options;
  options.allowance = ConstantK{k, "test"};
  options.root = root;
  auto layout = lay_out(sheet, options);
  if (!layout) throw std::runtime_error(layout.error().message);
  return *layout;
}

TEST(Placement, ShiftsATrimmedBorderAlongTheFoldLineToWhereItLiesInSpace) {
  for (const double from : {0.0, 3.0, 12.0, 20.0}) {
    const Sheet sheet = trimmed_crease(from);
    const Layout layout = laid_from(sheet, FaceId{0});
    const double gap = pi / 2 * 0.4 * 2.0;
    // The wall's x runs against y of the base, from the end of its border.
    const Vec2 corner = layout.develop(sheet, FaceId{1}, {0, 0});
    const Vec2 far = layout.develop(sheet, FaceId{1}, {20, 30});
    EXPECT_LT((corner - Vec2(50 + gap, from + 20)).norm(), 1e-9) << from;
    EXPECT_LT((far - Vec2(80 + gap, from)).norm(), 1e-9) << from;
  }
}

TEST(Placement, FromTheWallLeavesBothAsTheyLieToEachOther) {
  const Sheet sheet = trimmed_crease(12.0);
  const Layout from_base = laid_from(sheet, FaceId{0}), from_wall = laid_from(sheet, FaceId{1});
  const Isometry2 motion = from_base.placement[FaceId{1}];
  for (const FaceId face : {FaceId{0}, FaceId{1}})
    for (const Vec2& p : {Vec2(0, 0), Vec2(17, 5), Vec2(3, 28)})
      EXPECT_LT(
          (motion * from_wall.develop(sheet, face, p) - from_base.develop(sheet, face, p)).norm(),
          1e-9);
}

TEST(Placement, OfASharpJointMissesNothingAndSeesAWallThatIsMovedOutOrFarAlong) {
  const Sheet sheet = trimmed_crease(12.0);
  Layout layout = laid_from(sheet, FaceId{0});
  const Joint& joint = sheet.joints.front();
  const auto off = [&](const Vec2& by) {
    Layout moved = layout;
    moved.placement[FaceId{1}] = Eigen::Translation2d(by) * layout.placement[FaceId{1}];
    return sheet_detail::mismatch(sheet, moved, joint);
  };
  EXPECT_LT(off({0, 0}), 1e-9);
  EXPECT_NEAR(off({0.7, 0}), 0.7, 1e-9);
  EXPECT_NEAR(off({-0.7, 0}), 0.7, 1e-9);
  EXPECT_LT(off({0, 5}), 1e-9) << "trimmed borders may lie anywhere along each other";
  EXPECT_LT(off({0, -57}), 1e-9);
  EXPECT_GT(off({0, 59}), 10.0) << "further than both borders are long";
  EXPECT_GT(off({0, -63}), 10.0);
  layout.placement[FaceId{1}] = layout.placement[FaceId{1}] * Eigen::Rotation2Dd(0.01);
  EXPECT_GT(sheet_detail::mismatch(sheet, layout, joint), 0.1) << "turned";
}

TEST(Placement, OfASmoothJointMissesWhatItsBordersAreApart) {
  const Sheet sheet = l_bracket();
  Layout layout = laid_from(sheet, FaceId{0});
  for (const Joint& joint : sheet.joints) {
    EXPECT_LT(sheet_detail::mismatch(sheet, layout, joint), 1e-9);
    EXPECT_LT(sheet_detail::own_mismatch(sheet, layout, joint), 1e-9);
  }
  layout = laid_from(sheet, FaceId{0});
  layout.placement[FaceId{0}] = Eigen::Translation2d(0.3, 0.4) * layout.placement[FaceId{0}];
  double worst = 0.0;
  for (const Joint& joint : sheet.joints)
    worst = std::max(worst, sheet_detail::mismatch(sheet, layout, joint));
  EXPECT_NEAR(worst, 0.5, 1e-9);
}

TEST(Placement, TakesTheLongestJointsFirst) {
  const Sheet sheet = trimmed_crease(12.0);
  EXPECT_NEAR(sheet_detail::joint_length(sheet, sheet.joints.front()), 40.0, 1e-12);
  const Sheet opened = box({.length = 80, .width = 50});
  const auto ranks = sheet_detail::longest_first(opened);
  ASSERT_EQ(ranks.size(), opened.joints.size());
  for (std::size_t j = 0; j < ranks.size(); ++j) {
    EXPECT_NEAR((*ranks[j])[0], sheet_detail::joint_length(opened, opened.joints[j]), 1e-12);
    EXPECT_EQ((*ranks[j])[1], 0.0);
  }
}

TEST(Placement, GrowsOverTheHighestRanksAndNotOverJointsWithoutOne) {
  // Two flat plates side by side that meet in two joints: at x = 20, y 0…10 and 10…40.
  SheetBuilder builder(1.0);
  const Loop left = polygon({{0, 0}, {20, 0}, {20, 10}, {20, 40}, {0, 40}});
  const Loop right = polygon({{20, 0}, {40, 0}, {40, 40}, {20, 40}, {20, 10}});
  const FaceId a = builder.flange({}, {left}), b = builder.flange({}, {right});
  builder.join({a, 0, 1}, {b, 0, 4});
  builder.join({a, 0, 2}, {b, 0, 3});
  const Sheet sheet = builder.finish();
  const Topology topology(sheet);
  const Layout layout = laid_from(sheet, a);
  using sheet_detail::JointRank;
  const auto tree = [&](const JointRank& first, const JointRank& second) {
    return sheet_detail::placed_over({first, second}, sheet, topology, layout)->tree;
  };
  EXPECT_EQ(tree({{1.0, 0.0, 0.0}}, {{2.0, 0.0, 0.0}}), std::vector<int>{1});
  EXPECT_EQ(tree({{2.0, 0.0, 0.0}}, {{1.0, 9.0, 9.0}}), std::vector<int>{0});
  EXPECT_EQ(tree({{1.0, 0.0, 3.0}}, {{1.0, 0.0, 4.0}}), std::vector<int>{1});
  EXPECT_EQ(tree({{1.0, 0.0, 0.0}}, {}), std::vector<int>{0});
  const auto none = sheet_detail::placed_over({{}, {}}, sheet, topology, layout);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::not_a_sheet);
}

}  // namespace
}  // namespace planish::test
