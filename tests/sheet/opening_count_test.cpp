#include "opening_count.hpp"

#include "support/sheets.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

FlatPattern laid_out(const Sheet& sheet, const FlattenOptions& options = {}) {
  auto pattern = flatten(sheet, options);
  EXPECT_TRUE(pattern) << (pattern ? "" : pattern.error().message);
  return std::move(*pattern);
}

OpeningCount counted(const Sheet& sheet, const FlatPattern& pattern) {
  const auto certificate = certify(sheet, pattern, EdgeDistance());
  EXPECT_TRUE(certificate) << (certificate ? "" : certificate.error().message);
  return certificate.value_or(Certificate{}).openings;
}

BorderLoop borders(const Loop& loop) {
  BorderLoop all;
  for (const Curve2& curve : loop)
    all.push_back({curve});
  return all;
}

/// The plate with three holes, a form with a hole of radius 4 drawn out of one of radius 3, and a
/// louvre: the solid's openings are five.
Sheet formed_plate() {
  Sheet sheet = plate_with_holes();
  sheet.genus = 5;
  FormedFeature extruded{.kind = "formed", .face = FaceId{0}, .outlines = {}, .at_rim = {}};
  extruded.outlines = {borders(circular_opening({40, 15}, 6.0))};
  extruded.openings = {
      {borders(circular_opening({40, 15}, 3.0)), borders(circular_opening({40, 15}, 4.0))}};
  FormedFeature louvre{.kind = "formed", .face = FaceId{0}, .outlines = {}, .at_rim = {}};
  louvre.outlines = {borders(reversed(polygon({{36, 46}, {46, 46}, {46, 50}, {36, 50}})))};
  louvre.slits = {{Border{Segment{{36, 46}, {46, 46}}}, Border{Segment{{46, 46}, {46, 49}}}}};
  sheet.features.push_back(extruded);
  sheet.features.push_back(louvre);
  return sheet;
}

TEST(CountedOpenings, AreThoseOfThePatternAndOfItsForms) {
  const Sheet sheet = formed_plate();
  const FlatPattern pattern = laid_out(sheet);
  EXPECT_EQ(pattern.openings.size(), 4u);
  EXPECT_EQ(pattern.slits.size(), 2u);
  const OpeningCount count = counted(sheet, pattern);
  EXPECT_EQ(count.pattern, 5) << "slits that touch are one";
  EXPECT_EQ(count.slits, 1);
  EXPECT_EQ(count.lost(), 0);
  EXPECT_TRUE(count.missing.empty());
}

TEST(CountedOpenings, AreListedWhereNothingIsCutOfForms) {
  const Sheet sheet = formed_plate();
  const OpeningCount count = counted(sheet, laid_out(sheet, {.extruded = ExtrudedHoles::outline}));
  EXPECT_EQ(count.pattern, 3);
  EXPECT_EQ(count.features, 2);
  EXPECT_EQ(count.lost(), 0);
}

TEST(CountedOpenings, MissesWhatWasLostWithItsPlace) {
  const Sheet sheet = formed_plate();
  const FlatPattern whole = laid_out(sheet, {.keep_root = true, .up = UpSide::reference});
  FlatPattern pattern = whole;
  pattern.openings.pop_back();  // the pilot hole
  OpeningCount count = counted(sheet, pattern);
  EXPECT_EQ(count.lost(), 1);
  ASSERT_EQ(count.missing.size(), 1u);
  EXPECT_NEAR((count.missing[0] - Vec2(40, 15)).norm(), 0.0, 1e-9);

  pattern = whole;
  pattern.slits.clear();
  count = counted(sheet, pattern);
  EXPECT_EQ(count.lost(), 1);
  ASSERT_EQ(count.missing.size(), 1u);
  EXPECT_NEAR((count.missing[0] - Vec2(46, 47.5)).norm(), 0.0, 1e-9);

  pattern = whole;
  pattern.openings.erase(pattern.openings.begin());  // Ø10 at (20, 30)
  count = counted(sheet, pattern);
  EXPECT_EQ(count.lost(), 1);
  ASSERT_EQ(count.missing.size(), 1u);
  EXPECT_NEAR((count.missing[0] - Vec2(20, 30)).norm(), 0.0, 1e-6);
}

TEST(CountedOpenings, AreTooManyWhereOneWasAdded) {
  const Sheet sheet = formed_plate();
  FlatPattern pattern = laid_out(sheet);
  pattern.openings.push_back(pattern.openings.front());
  EXPECT_EQ(counted(sheet, pattern).lost(), -1);
}

TEST(CountedOpenings, HaveNothingToBeComparedWithWithoutASolid) {
  const OpeningCount count = counted(plate_with_holes(), laid_out(plate_with_holes()));
  EXPECT_FALSE(count.solid);
  EXPECT_FALSE(count.lost());
  EXPECT_EQ(count.pattern, 3);
}

TEST(CountedOpenings, LeaveOutSlitsThatReachAContour) {
  const Sheet sheet = plate_with_holes();
  FlatPattern pattern = laid_out(sheet, {.keep_root = true, .up = UpSide::reference});
  pattern.slits = {Segment{{0, 50}, {10, 50}}};
  EXPECT_EQ(counted(sheet, pattern).pattern, 3);
  pattern.slits.push_back(Segment{{15, 50}, {30, 50}});
  EXPECT_EQ(counted(sheet, pattern).pattern, 4);
}

TEST(CountedOpenings, CountSlitsThatMeetAsOneInWhicheverOrderTheyStand) {
  const Sheet sheet = plate_with_holes();
  FlatPattern pattern = laid_out(sheet, {.keep_root = true, .up = UpSide::reference});
  const Segment bar{{20, 50}, {40, 50}};
  const auto with = [&](const std::vector<Segment>& slits) {
    pattern.slits.assign(slits.begin(), slits.end());
    return counted(sheet, pattern).pattern - 3;
  };
  // One that ends in the middle of another, at its end, or just beside it.
  for (const Segment& other : {Segment{{30, 50}, {30, 56}}, Segment{{30, 56}, {30, 50}},
                               Segment{{40, 50}, {46, 54}}, Segment{{14, 54}, {20, 50}}}) {
    EXPECT_EQ(with({bar, other}), 1) << other.a.transpose();
    EXPECT_EQ(with({other, bar}), 1) << other.a.transpose();
  }
  const Segment beside{{30, 50.5}, {30, 56}};
  EXPECT_EQ(with({bar, beside}), 2);
  EXPECT_EQ(with({beside, bar}), 2);
  // Over a third one to the contour: none of them parts anything off.
  EXPECT_EQ(with({bar, {{30, 50}, {30, 60}}}), 0);
  EXPECT_EQ(with({{{30, 50}, {30, 60}}, bar}), 0);
}

TEST(CountedOpenings, HaveNoLoopsInSheetsThatLieFlat) {
  for (const Sheet& sheet : {plate_with_holes(), l_bracket(), box(), slot_across_bend(),
                             ring(20, 10, 2), staircase(4), lofted_corner({})})
    EXPECT_EQ(counted(sheet, laid_out(sheet)).loops, 0);
}

TEST(CountedOpenings, AreInThePatternOfEverySide) {
  const Sheet sheet = formed_plate();
  for (const UpSide up : {UpSide::reference, UpSide::other}) {
    const FlatPattern pattern = laid_out(sheet, {.up = up});
    const double area = 6000 - pi * (25 + 3.3 * 3.3 + 16 + 9) - 12 * 8;
    EXPECT_NEAR(pattern.area, area, 1e-6);
    EXPECT_EQ(counted(sheet, pattern).lost(), 0);
    ASSERT_EQ(pattern.features.at(0).pilots.size(), 1u);
    EXPECT_NEAR(
        (pattern.features[0].pilots[0] - std::get<Arc>(pattern.openings.back().loop.front()).center)
            .norm(),
        0.0, 1e-9);
    for (const Contour& opening : pattern.openings)
      EXPECT_LT(signed_area(opening.loop), 0.0);
  }
}

}  // namespace
}  // namespace planish::test
