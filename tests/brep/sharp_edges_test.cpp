#include "sharp_edges.hpp"

#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using ::testing::IsEmpty;

using std::numbers::pi;

struct Found {
  std::vector<RoundedOutside> rounded;
  std::vector<SharpEdge> sharp;
};

Found found_in(const SolidModel& model, double thickness, const std::vector<int>& skin_faces) {
  const auto outlines = outlines_of(model);
  const FacePairs pairs = pair_faces(model, outlines, thickness, 0.02 * thickness);
  std::vector<bool> candidates(model.faces.size(), false);
  for (const int f : skin_faces)
    candidates[f] = true;
  Found found;
  found.rounded = rounded_outsides(model, outlines, candidates, thickness, 0.02 * thickness);
  for (const RoundedOutside& outside : found.rounded)
    candidates[outside.face] = true;
  found.sharp = find_sharp_edges(model, pairs.partners, candidates, found.rounded, thickness);
  return found;
}

/// A mitred fold of two legs, 2 mm thick: faces 2, 3 outside, 5, 6 inside, 4 and 7 the ends.
SolidModel mitred() {
  return prism({{Segment{{0, 0}, {50, 0}}, Segment{{50, 0}, {50, 30}}, Segment{{50, 30}, {48, 30}},
                 Segment{{48, 30}, {48, 2}}, Segment{{48, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
               40);
}

TEST(SharpEdges, OfAMitredFoldAreOneOnEachSkin) {
  const Found found = found_in(mitred(), 2, {2, 3, 5, 6});
  EXPECT_THAT(found.rounded, IsEmpty());
  ASSERT_EQ(found.sharp.size(), 2u);
  EXPECT_NE(found.sharp[0].concave, found.sharp[1].concave);
  EXPECT_FALSE(found.sharp[0].rounded || found.sharp[1].rounded);
}

TEST(SharpEdges, OfARoundedFoldAreTheInsideAlone) {
  const SolidModel model = prism({strip_profile(2, {{50, pi / 2, 0}, {30}})}, 40);
  const Found found = found_in(model, 2, {2, 4, 6, 7});
  ASSERT_EQ(found.rounded.size(), 1u);
  EXPECT_EQ(found.rounded.front().face, 3);
  ASSERT_EQ(found.sharp.size(), 1u);
  EXPECT_TRUE(found.sharp.front().concave);
  EXPECT_TRUE(found.sharp.front().rounded);
}

TEST(RoundedOutsides, HaveTheThicknessAsRadius) {
  const SolidModel model = prism({strip_profile(2, {{50, pi / 2, 0}, {30}})}, 40);
  const auto outlines = outlines_of(model);
  std::vector<bool> candidates(model.faces.size(), false);
  for (const int f : {2, 4, 6, 7})
    candidates[f] = true;
  EXPECT_EQ(rounded_outsides(model, outlines, candidates, 2.0, 0.04).size(), 1u);
  EXPECT_THAT(rounded_outsides(model, outlines, candidates, 2.1, 0.04), IsEmpty());
}

TEST(SharpEdges, AreNotTheEdgesOfASquareBar) {
  // All four sides have partners at the thickness, but all edges are convex.
  const SolidModel bar = prism({{Segment{{0, 0}, {2, 0}}, Segment{{2, 0}, {2, 2}},
                                 Segment{{2, 2}, {0, 2}}, Segment{{0, 2}, {0, 0}}}},
                               100);
  EXPECT_THAT(found_in(bar, 2, {2, 3, 4, 5}).sharp, IsEmpty());
}

TEST(SharpEdges, AreNotTheCutEdgesOfAPlate) {
  const Found found = found_in(plate(2, {100, 60}), 2, {0, 1, 2, 3, 4, 5});
  EXPECT_THAT(found.sharp, IsEmpty());
}

}  // namespace
}  // namespace planish::brep::test
