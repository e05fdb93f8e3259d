#include "features.hpp"

#include "form_volume.hpp"
#include "recognised.hpp"

#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

double opening_area(const Sheet& sheet) {
  EXPECT_EQ(sheet.faces.size(), 1u);
  EXPECT_EQ(sheet.faces.front().loops.size(), 2u);
  return loop_area(sheet.faces.front().loops.back());
}

std::optional<FeatureId> mark_of_opening(const Sheet& sheet) {
  return sheet.faces.front().loops.at(1).front().feature;
}

SolidModel pocketed() { return plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 1.2}, {0, 1.2}}}}); }

TEST(AddFeatures, MarksThePocketOnItsOwnSkin) {
  const Sheet sheet = sheet_of(pocketed(), kTop);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "pocket");
  EXPECT_EQ(sheet.features.front().source_face, 7);
  EXPECT_EQ(mark_of_opening(sheet), FeatureId{0}) << "drawn, not cut";
  EXPECT_NEAR(sheet.forms_volume.value(), -pi * 64 * 0.8, 1e-8);
}

TEST(AddFeatures, DrawsThePocketSeenThroughTheSheet) {
  const Sheet sheet = sheet_of(pocketed(), kBottom);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "pocket");
  ASSERT_EQ(sheet.features.front().outlines.size(), 1u);
  EXPECT_NEAR(loop_area(sheet.features.front().outlines.front()), pi * 64, 1e-8);
  EXPECT_NEAR(sheet.features.front().outlines.front().front().edge_depth, 2.0, 1e-12);
  EXPECT_NEAR(sheet.forms_volume.value(), -pi * 64 * 0.8, 1e-8);
}

SolidModel bossed() { return plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}}); }

TEST(AddFeatures, MarksABossAsFormed) {
  const Sheet sheet = sheet_of(bossed(), kTop);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "formed");
  EXPECT_EQ(sheet.features.front().at_rim.code, code::not_a_sheet);
  EXPECT_EQ(mark_of_opening(sheet), FeatureId{0});
  EXPECT_NEAR(sheet.forms_volume.value(), pi * 64 * 4, 1e-8);
}

TEST(AddFeatures, DrawsABossOnTheOtherSkin) {
  const Sheet sheet = sheet_of(bossed(), kBottom);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "formed");
  EXPECT_NEAR(loop_area(sheet.features.front().outlines.at(0)), pi * 64, 1e-8);
}

TEST(AddFeatures, CutACountersinkToItsBoreOnBothSkins) {
  const double ring = pi / 3 * 1.5 * (16 + 10 + 6.25) - pi * 6.25 * 1.5;
  for (const int reference : {kTop, kBottom}) {
    const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}}}),
                                 reference);
    EXPECT_NEAR(opening_area(sheet), pi * 6.25, 1e-8);
    ASSERT_EQ(sheet.features.size(), 1u);
    EXPECT_EQ(sheet.features.front().kind, "countersink");
    ASSERT_EQ(sheet.features.front().outlines.size(), 1u);
    EXPECT_NEAR(loop_area(sheet.features.front().outlines.front()), pi * 16, 1e-8);
    EXPECT_NEAR(sheet.forms_volume.value(), -ring, 1e-8);
  }
}

TEST(AddFeatures, CutACounterboreToItsBoreOnBothSkins) {
  for (const int reference : {kTop, kBottom}) {
    const Sheet sheet = sheet_of(
        plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {4, 1.2}, {2.5, 1.2}, {2.5, 0}}}}), reference);
    EXPECT_NEAR(opening_area(sheet), pi * 6.25, 1e-8);
    ASSERT_EQ(sheet.features.size(), 1u);
    EXPECT_NEAR(loop_area(sheet.features.front().outlines.at(0)), pi * 16, 1e-8);
    EXPECT_NEAR(sheet.forms_volume.value(), -pi * (16 - 6.25) * 0.8, 1e-8);
  }
}

TEST(AddFeatures, AreNoneOfAStraightHole) {
  const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), kTop);
  EXPECT_TRUE(sheet.features.empty());
  EXPECT_NEAR(opening_area(sheet), pi * 25, 1e-8);
  EXPECT_FALSE(mark_of_opening(sheet));
}

TEST(AddFeatures, DrawTheFarOutlineOfASlantedCut) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto low = clockwise(rectangle_at({40, 20}, {60, 40}));
  const auto high = clockwise(rectangle_at({41, 20}, {61, 40}));
  const Sheet sheet = sheet_of(plate(2, {{{outer, outer}, {0, 2}}, {{low, high}, {0, 2}}}), kTop);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "slanted cut");
  EXPECT_NEAR(loop_area(sheet.features.front().outlines.at(0)), 400.0, 1e-8);
  EXPECT_NEAR(opening_area(sheet), 400.0, 1e-8);
  EXPECT_EQ(sheet.forms_volume, 0.0);
}

TEST(AddFeatures, SayOnWhichSideTheyAre) {
  // All at (30, 30) of a sheet of 2 mm, as paths (radius, height), seen from above.
  const std::pair<std::vector<Vec2>, FormSide> forms[] = {
      {{{8, 2}, {8, 1.2}, {0, 1.2}}, FormSide::up},                              // pocket
      {{{0, 0.8}, {8, 0.8}, {8, 0}}, FormSide::down},                            // pocket below
      {{{8, 2}, {8, 6}, {0, 6}}, FormSide::up},                                  // boss
      {{{0, -4}, {8, -4}, {8, 0}}, FormSide::down},                              // boss below
      {{{4, 2}, {2.5, 0.5}, {2.5, 0}}, FormSide::up},                            // countersink
      {{{2.5, 2}, {2.5, 1.5}, {4, 0}}, FormSide::down},                          // from below
      {{{4, 2}, {3, 1}, {4, 0}}, FormSide::both},                                // from both sides
      {{{20, 2}, {16, 5}, {5, 5}, {5, 3}, {14.5, 3}, {18.5, 0}}, FormSide::up},  // emboss, hole
      {{{18.5, 2}, {14.5, -1}, {5, -1}, {5, -3}, {16, -3}, {20, 0}}, FormSide::down},
      {{{5, 2}, {5, -3}, {6, -3}, {6, 0}}, FormSide::down}};  // extruded hole
  for (const auto& [path, side] : forms)
    for (const int reference : {kTop, kBottom}) {
      const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{30, 30}, path}}), reference);
      ASSERT_EQ(sheet.features.size(), 1u);
      EXPECT_EQ(side_name(sheet.features.front().side),
                side_name(reference == kTop ? side : other_side(side)))
          << path.size() << " points from (" << path.front().transpose() << "), reference "
          << reference;
    }
}

TEST(AddFeatures, DrawUnevenCountersinksOnBothSides) {
  for (const int reference : {kTop, kBottom}) {
    const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {3, 1}, {4, 0}}}}),
                                 reference);
    ASSERT_EQ(sheet.features.size(), 2u);
    const FormedFeature &up = sheet.features.front(), &down = sheet.features.back();
    EXPECT_EQ(side_name(up.side), "up");
    EXPECT_EQ(side_name(down.side), "down");
    EXPECT_NEAR(loop_area(up.outlines.at(0)), pi * (reference == kTop ? 25 : 16), 1e-8);
    EXPECT_NEAR(loop_area(down.outlines.at(0)), pi * (reference == kTop ? 16 : 25), 1e-8);
    EXPECT_NEAR(opening_area(sheet), pi * 9, 1e-8);
  }
}

TEST(AddFeatures, CutToTheBoreBetweenTwoCounterbores) {
  const Sheet sheet = sheet_of(
      plate(2, {100, 60},
            {{{30, 30}, {{8, 2}, {8, 1.3}, {2.5, 1.3}, {2.5, 0.7}, {8, 0.7}, {8, 0}}}}),
      kTop);
  EXPECT_NEAR(opening_area(sheet), pi * 6.25, 1e-8);
  EXPECT_NEAR(sheet.forms_volume.value(), -pi * (64 - 6.25) * 1.4, 1e-7);
  EXPECT_NEAR(sheet.faces.front().loops.back().front().edge_depth, 0.7, 1e-12);
}

TEST(AddFeatures, MeasureWhatTheSolidLacksAtAnOpening) {
  const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}}}),
                               kTop);
  ASSERT_EQ(sheet.measured_openings.size(), 1u);
  const MeasuredOpening& opening = sheet.measured_openings.front();
  const double ring = pi / 3 * 1.5 * (16 + 10 + 6.25) - pi * 6.25 * 1.5;
  EXPECT_NEAR(opening.lacking, pi * 6.25 * 2 + ring, 1e-8);
  EXPECT_NEAR(opening.beyond, ring, 1e-8);
  EXPECT_NEAR(opening.intrusion, 0.0, 1e-9);
}

TEST(AddFeatures, NoteAGrooveWithinTheSheet) {
  const Sheet sheet = sheet_of(
      plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {4, 1.5}, {6, 1.5}, {6, 0.5}, {4, 0.5}, {4, 0}}}}),
      kTop);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "pocket");
  EXPECT_EQ(sheet.features.front().along.size(), 1u) << "it has a place";
  EXPECT_NEAR(opening_area(sheet), pi * 16, 1e-8);
  EXPECT_NEAR(sheet.forms_volume.value(), -pi * (36 - 16), 1e-8);
}

/// A hole of a pattern made larger or smaller all round.
FlatPattern with_wrong_hole(FlatPattern flat, double by) {
  std::get<Arc>(flat.openings.front().loop.front()).radius += by;
  return flat;
}

TEST(Certificate, NoticesAWrongHoleInALargeSheet) {
  const SolidModel model = plate(2, {2000, 1000}, {{{300, 300}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}}});
  const Sheet sheet = sheet_of(model, kTop);
  const auto flat = flatten(sheet);
  ASSERT_TRUE(flat);
  EXPECT_NEAR(certify(sheet, *flat, {})->opening_error.value(), 0.0, 1e-9);
  for (const double by : {-0.1, 0.1}) {
    const auto certificate = certify(sheet, with_wrong_hole(*flat, by), {});
    EXPECT_NEAR(certificate->opening_error.value(), 0.1, 3e-3);
    EXPECT_NEAR(*certificate->explained_ratio, 1.0, 1e-6) << "the volume does not show it";
    EXPECT_NEAR((certificate->opening_error_at - Vec2(300, 300)).norm(), 0.0, 1e-6);
  }
}

TEST(AddFeatures, DrawBossesOnBothSkinsApart) {
  // One on the top, one on the bottom elsewhere: beside each other along x, along y, along both.
  const std::vector<Vec2> above{{5, 2}, {5, 6}, {0, 6}}, below{{0, -4}, {5, -4}, {5, 0}};
  for (const Vec2& at : {Vec2(70, 20), Vec2(20, 45), Vec2(70, 45)})
    for (const int reference : {kTop, kBottom}) {
      const Sheet sheet = sheet_of(plate(2, {100, 60}, {{{20, 20}, above}, {at, below}}),
                                   reference);
      ASSERT_EQ(sheet.features.size(), 2u);
      EXPECT_NE(side_name(sheet.features.front().side), side_name(sheet.features.back().side));
      EXPECT_NEAR(sheet.forms_volume.value(), 2 * pi * 25 * 4, 1e-7);
    }
}

TEST(AddFeatures, CutAPlateAsWideAsTheTongueAlongItsRim) {
  const auto skin = rectangle_at({2, 2}, {98, 58}), tongue = rectangle_at({0, 0}, {100, 60});
  const Sheet sheet = sheet_of(
      plate(2, {{{skin, skin, tongue, tongue, skin, skin}, {0, 0.6, 0.6, 1.4, 1.4, 2}}}), kTop);
  EXPECT_NEAR(loop_area(sheet.faces.front().loops.front()), 6000.0, 1e-8);
  EXPECT_NEAR(sheet.forms_volume.value(), -(6000.0 - 96 * 56) * 1.2, 1e-7);
  ASSERT_EQ(sheet.features.size(), 2u) << "a step on either side";
  for (const FormedFeature& feature : sheet.features)
    EXPECT_NEAR(loop_area(feature.outlines.at(0)), 96 * 56, 1e-8);
}

TEST(AddFeatures, DrawTheSkinInsideAChamferedRim) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inset = rectangle_at({0.5, 0.5}, {99.5, 59.5});
  const Sheet sheet = sheet_of(plate(2, {{{outer, outer, inset}, {0, 1.5, 2}}}), kTop);
  ASSERT_EQ(sheet.features.size(), 1u);
  EXPECT_EQ(sheet.features.front().kind, "chamfer");
  EXPECT_NEAR(loop_area(sheet.features.front().outlines.at(0)), 99 * 59, 1e-8);
  EXPECT_NEAR(loop_area(sheet.faces.front().loops.front()), 6000.0, 1e-8);
  // A pyramid's frustum stands for the upper 0.5 mm.
  const double frustum = 0.5 / 3 * (6000 + 99 * 59 + std::sqrt(6000.0 * 99 * 59));
  EXPECT_NEAR(sheet.forms_volume.value(), frustum - 6000 * 0.5, 0.01);
}

}  // namespace
}  // namespace planish::brep::test
