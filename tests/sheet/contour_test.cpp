#include "contour.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using sheet_detail::Contours;

Result<Contours> chained(const Sheet& sheet) {
  const auto layout = lay_out(sheet);
  if (!layout) return tl::unexpected(layout.error());
  return sheet_detail::chain_contours(sheet, *layout, {});
}

TEST(Contour, OfABentStripIsOneRectangleOfItsFreeBorders) {
  const auto contours = chained(l_bracket());
  ASSERT_TRUE(contours);
  EXPECT_EQ(contours->outer.loop.size(), 4u) << "collinear borders joined";
  EXPECT_TRUE(contours->openings.empty());
  ASSERT_EQ(contours->outer.origins.size(), 4u);
  std::size_t borders = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double covered = 0.0;
    for (const Origin& origin : contours->outer.origins[i]) {
      covered += length(origin.image);
      EXPECT_FALSE(origin.gap);
      ++borders;
      EXPECT_LT(nearest(contours->outer.loop[i], point_at(origin.image, 0.5)).distance, 1e-9);
    }
    EXPECT_NEAR(covered, length(contours->outer.loop[i]), 1e-9);
  }
  EXPECT_EQ(borders, 8u) << "12 borders less those of two joints";
}

TEST(Contour, CrossesAGapAtEachEndOfASharpBend) {
  const auto contours = chained(
      strip({Straight{50}, Crease{Angle::degrees(90), BendDirection::up}, Straight{30}}, 40, 2));
  ASSERT_TRUE(contours);
  int gaps = 0;
  for (const auto& origins : contours->outer.origins)
    for (const Origin& origin : origins)
      if (origin.gap) {
        ++gaps;
        EXPECT_NEAR(length(origin.image), std::numbers::pi / 2 * ConstantK{}.k * 2, 1e-9);
      }
  EXPECT_EQ(gaps, 2);
  EXPECT_EQ(contours->outer.loop.size(), 4u);
}

TEST(Contour, TakesTheLargestAsTheOuterOneAndTheOthersAsOpenings) {
  const auto contours = chained(plate_with_holes());
  ASSERT_TRUE(contours);
  EXPECT_NEAR(signed_area(contours->outer.loop), 6000, 1e-9);
  EXPECT_EQ(contours->openings.size(), 3u);
  for (const Contour& opening : contours->openings)
    EXPECT_LT(signed_area(opening.loop), 0.0);
}

TEST(Contour, OfAFormIsDrawnAndNotCutUnlessItIsTheOuterOne) {
  Sheet sheet = plate_with_holes();
  FormedFeature form;
  form.kind = "formed";
  form.at_rim = {code::overlap, "The form says so.", ""};
  sheet.features.push_back(form);
  sheet[BorderRef{FaceId{0}, 1, 0}].feature = FeatureId{0};
  const auto contours = chained(sheet);
  ASSERT_TRUE(contours);
  EXPECT_EQ(contours->openings.size(), 2u);
  ASSERT_EQ(contours->formed.size(), 1u);
  EXPECT_EQ(contours->formed[0].first, FeatureId{0});
  EXPECT_NEAR(signed_area(contours->formed[0].second), -25 * std::numbers::pi, 1e-9);
  Sheet at_rim = sheet;
  at_rim[BorderRef{FaceId{0}, 0, 2}].feature = FeatureId{0};
  EXPECT_EQ(chained(at_rim).error().code, code::overlap) << "what the form's maker says";
  at_rim.features[FeatureId{0}].at_rim = {};
  EXPECT_EQ(chained(at_rim).error().code, code::unsupported_shape);
}

TEST(JoinedContour, HasTheOriginsOfAllItsPieces) {
  // A square whose sides are in two pieces, begun in the middle of one.
  Contour contour;
  contour.loop = polygon({{5, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}, {0, 0}});
  for (int i = 0; i < 8; ++i)
    contour.origins.push_back({{BorderRef{FaceId{0}, 0, i}, false, contour.loop[i]}});
  const Contour joined = sheet_detail::joined_contour(contour, 1e-6);
  ASSERT_EQ(joined.loop.size(), 4u);
  ASSERT_EQ(joined.origins.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_EQ(joined.origins[i].size(), 2u);
    for (const Origin& origin : joined.origins[i])
      EXPECT_LT(nearest(joined.loop[i], point_at(origin.image, 0.5)).distance, 1e-9);
    EXPECT_EQ((joined.origins[i][0].border.border + 1) % 8, joined.origins[i][1].border.border);
  }
}

TEST(JoinedContour, OfQuarterCirclesIsOneCircleWithAllOrigins) {
  Contour contour;
  for (int i = 0; i < 4; ++i) {
    contour.loop.push_back(Arc{{3, 4}, 5, i * std::numbers::pi / 2, std::numbers::pi / 2});
    contour.origins.push_back({{BorderRef{FaceId{0}, 0, i}, false, contour.loop[i]}});
  }
  const Contour joined = sheet_detail::joined_contour(contour, 1e-6);
  ASSERT_EQ(joined.loop.size(), 1u);
  EXPECT_EQ(joined.origins[0].size(), 4u);
}

}  // namespace
}  // namespace planish::test
