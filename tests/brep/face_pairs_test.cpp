#include "face_pairs.hpp"

#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

FacePairs pairs_of(const SolidModel& model, double thickness, double slack) {
  return pair_faces(model, outlines_of(model), thickness, slack);
}

TEST(PairFaces, FindsTopAndBottomOfAPlateAndNoWalls) {
  const FacePairs pairs = pairs_of(plate(2, {100, 60}), 2, 0.04);
  ASSERT_EQ(pairs.rows.size(), 1u);
  EXPECT_THAT(pairs.partners[0], ElementsAre(1));
  EXPECT_THAT(pairs.partners[1], ElementsAre(0));
  EXPECT_NEAR(pairs.covered[0], 1.0, 1e-12);
  for (const int wall : {2, 3, 4, 5})
    EXPECT_THAT(pairs.partners[wall], IsEmpty());
}

TEST(PairFaces, HoldsToItsSlack) {
  EXPECT_THAT(pairs_of(plate(2.05, {100, 60}), 2, 0.04).rows, IsEmpty());
  EXPECT_EQ(pairs_of(plate(2.05, {100, 60}), 2, 0.06).rows.size(), 1u);
}

TEST(PairFaces, LeavesWedgesThatAreAsThickOnAverageOnly) {
  // 1.95 mm at one end, 2.05 mm at the other.
  const SolidModel wedge = prism({{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 2.05}},
                                   Segment{{100, 2.05}, {0, 1.95}}, Segment{{0, 1.95}, {0, 0}}}},
                                 40);
  EXPECT_THAT(pairs_of(wedge, 2, 0.04).rows, IsEmpty());
  EXPECT_EQ(pairs_of(wedge, 2, 0.11).rows.size(), 1u);
}

TEST(PairFaces, PairsFlangesAndBendsWithTheirLikes) {
  const SolidModel bent = prism({strip_profile(2, {{50, std::numbers::pi / 2, 3}, {30}})}, 40);
  const FacePairs pairs = pairs_of(bent, 2, 0.04);
  EXPECT_THAT(pairs.partners[2], ElementsAre(8));
  EXPECT_THAT(pairs.partners[3], ElementsAre(7));
  EXPECT_THAT(pairs.partners[4], ElementsAre(6));
  EXPECT_THAT(pairs.partners[0], IsEmpty());
}

TEST(PairFaces, TellsHowMuchOfAFaceIsCovered) {
  // 2 mm thick on 60 mm of 100, 5 mm on the rest.
  const SolidModel model = prism(
      {{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 5}}, Segment{{100, 5}, {60, 5}},
        Segment{{60, 5}, {60, 2}}, Segment{{60, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
      40);
  const FacePairs pairs = pairs_of(model, 2, 0.04);
  EXPECT_THAT(pairs.partners[2], UnorderedElementsAre(6));
  EXPECT_NEAR(pairs.covered[2], 0.6, 1e-9);
  EXPECT_NEAR(pairs.covered[6], 1.0, 1e-9);
  EXPECT_NEAR(pairs.covered[4], 0.0, 1e-12) << "5 mm above the bottom";
}

}  // namespace
}  // namespace planish::brep::test
