#include "rim.hpp"

#include "recognised.hpp"

#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

const RimPart& part_with(const Recognised& seen, int face) {
  return seen.rim.parts.at(seen.rim.part_of.at(face));
}

TEST(FindRim, OfAPlateIsItsFourWallsAsOnePart) {
  const Recognised seen = recognised(plate(2, {100, 60}), 2, 1);
  ASSERT_EQ(seen.rim.parts.size(), 1u);
  const RimPart& walls = seen.rim.parts.front();
  EXPECT_THAT(walls.faces, UnorderedElementsAre(2, 3, 4, 5));
  EXPECT_EQ(walls.first.size() + walls.second.size(), 2u) << "one loop on each skin";
  EXPECT_TRUE(walls.within);
  EXPECT_EQ(seen.rim.part_of[0], -1);
}

TEST(FindRim, KeepsTheWallsOfAHoleApart) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  ASSERT_EQ(seen.rim.parts.size(), 2u);
  const RimPart& hole = part_with(seen, 6);
  EXPECT_THAT(hole.faces, ElementsAre(6));
  ASSERT_EQ(hole.first.size(), 1u);
  ASSERT_EQ(hole.second.size(), 1u);
  EXPECT_EQ(hole.first.front().loop, 1);
  EXPECT_TRUE(hole.within);
}

TEST(FindRim, HoldsAPocketWithinTheSheetOnOneSkin) {
  const Recognised seen = recognised(
      plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 1.2}, {0, 1.2}}}}), 2, 1);
  const RimPart& pocket = part_with(seen, 6);
  EXPECT_THAT(pocket.faces, UnorderedElementsAre(6, 7));
  EXPECT_EQ(pocket.first.size() + pocket.second.size(), 1u);
  EXPECT_TRUE(pocket.within);
}

TEST(FindRim, SeesABossLeaveTheSheet) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}}), 2,
                                     1);
  const RimPart& boss = part_with(seen, 6);
  EXPECT_FALSE(boss.within);
  EXPECT_EQ(boss.refusal.code, code::not_a_sheet);
  EXPECT_EQ(boss.refusal.where, "face 8");  // its top
}

TEST(FindRim, SeesACupLeaveTheSheetOnItsFarSide) {
  // Pressed down by 3 mm: its inside touches the top alone, its outside the bottom alone.
  const Turned inside{{30, 30}, {{8, 2}, {8, -1}, {0, -1}}};
  const Turned outside{{30, 30}, {{0, -3}, {10, -3}, {10, 0}}};
  const Recognised seen = recognised(plate(2, {100, 60}, {inside, outside}), 2, 1);
  EXPECT_FALSE(part_with(seen, 6).within);
  EXPECT_FALSE(part_with(seen, 9).within);
}

TEST(FindRim, HoldsAChamferWithinTheSheet) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inset = rectangle_at({0.5, 0.5}, {99.5, 59.5});
  const Recognised seen = recognised(plate(2, {{{outer, outer, inset}, {0, 1.5, 2}}}), 2, 1);
  ASSERT_EQ(seen.rim.parts.size(), 1u);
  EXPECT_EQ(seen.rim.parts.front().faces.size(), 8u);
  EXPECT_TRUE(seen.rim.parts.front().within);
}

TEST(FindRim, HoldsTheCutEdgesOfABendWithinTheSheet) {
  const Recognised seen = recognised(
      prism({strip_profile(2, {{50, std::numbers::pi / 2, 3}, {30}})}, 40), 2, 2);
  ASSERT_EQ(seen.rim.parts.size(), 1u);
  EXPECT_THAT(seen.rim.parts.front().faces, UnorderedElementsAre(0, 1, 5, 9));
  EXPECT_THAT(seen.rim.parts.front().first.size(), 3u) << "flange, bend, flange";
  EXPECT_TRUE(seen.rim.parts.front().within);
}

TEST(OuterLoop, IsTheLargestWhereverItStands) {
  Outline outline;
  outline.flat = {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{0, 0}, {9, 0}, {9, 9}, {0, 9}}};
  EXPECT_EQ(outer_loop(outline), 1);
}

}  // namespace
}  // namespace planish::brep::test
