#include "flat_plates.hpp"
#include "support/sheets.hpp"

#include <planish/inspect/double_cover.hpp>
#include <planish/inspect/findings.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish {
namespace {

using test::polygon;
using test::rectangle;
using test::shifted;
using testing::HasSubstr;

/// A sheet of faces without bends between them, as overlaps see it.
struct Regions {
  Sheet sheet;
  Layout layout;
  FlatPattern pattern;
  Regions() { pattern.thickness = sheet.thickness = 2.0; }

  FaceId add(const Loop& outline, std::variant<FlangeId, BendId> part,
             std::vector<Loop> openings = {}) {
    Face face;
    face.surface = Frame{};
    face.part_of = part;
    sheet.faces.push_back(face);
    openings.insert(openings.begin(), outline);
    layout.images.push_back(std::move(openings));
    return FaceId{static_cast<int>(sheet.faces.size()) - 1};
  }
  std::vector<Finding> overlaps() const { return find_overlaps(sheet, layout, pattern); }
};

Loop square(double x, double y, double side) { return shifted(rectangle(side, side), Vec2(x, y)); }

/// The area that parts of the sheet share, mm².
double area_of(const Finding& finding) {
  EXPECT_FALSE(finding.numbers.empty()) << finding.message;
  if (finding.numbers.empty()) return 0.0;
  EXPECT_EQ(finding.numbers.front().name, "area");
  EXPECT_EQ(finding.numbers.front().quantity.unit, unit::mm2);
  return finding.numbers.front().quantity.value;
}

/// The parts that a finding is about, without where they lie.
std::vector<Place> parts_of(const Finding& finding) {
  std::vector<Place> parts = finding.about;
  for (Place& part : parts) {
    EXPECT_EQ(part.at.size(), 2u) << finding.message;
    part.at.clear();
  }
  return parts;
}

TEST(FindOverlaps, NamesTheFlangesTheAreaAndThePlace) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{2});
  regions.add(square(5, 5, 10), FlangeId{6});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_EQ(found[0].code, "overlap");
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_EQ(found[0].message, "flanges 3 and 7 overlap by 25 mm² in the flat pattern");
  EXPECT_EQ(parts_of(found[0]), (std::vector{place::flange(3), place::flange(7)}));
  ASSERT_EQ(found[0].remedies.size(), 1u);
  EXPECT_EQ(found[0].remedies[0].option, "write_overlapping");
  EXPECT_EQ(found[0].remedies[0].value, "true");
  Box2 place;
  for (const Vec2& p : found[0].at)
    place.add(p);
  EXPECT_LT((place.lo - Vec2(5, 5)).norm(), 0.01);
  EXPECT_LT((place.hi - Vec2(10, 10)).norm(), 0.01);
}

TEST(FindOverlaps, MeasuresNarrowOverlapsAsTheyAre) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(9.9, 0, 10), FlangeId{1});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(area_of(found[0]), 1.0, 0.001);
}

TEST(FindOverlaps, LetsPiecesTouchWithinTheContactDepth) {
  for (const double depth : {0.0, 1e-9, 0.003}) {
    Regions regions;
    regions.add(square(0, 0, 10), FlangeId{0});
    regions.add(square(10 - depth, 0, 10), FlangeId{1});
    regions.add(square(10 - depth, 10 - depth, 10), FlangeId{2});
    EXPECT_TRUE(regions.overlaps().empty()) << depth;
  }
}

TEST(FindOverlaps, LetsClosedRingsMissByWhatTheyMiss) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(9.99, 0, 10), FlangeId{1});
  EXPECT_EQ(regions.overlaps().size(), 1u);
  regions.pattern.closure = 0.01;
  EXPECT_TRUE(regions.overlaps().empty());
}

TEST(FindOverlaps, LetsCurvedNeighboursTouchAlongOneArc) {
  // A disc in the hole of a plate: both sides of the arc are sampled on their own.
  for (const double radius : {3.0, 500.0}) {
    Regions regions;
    const Arc rim{Vec2(1, 2), radius, 0.3, 2 * std::numbers::pi};
    const Arc hole{Vec2(1, 2), radius, 1.7, -2 * std::numbers::pi};
    regions.add(Loop{rim}, FlangeId{0});
    regions.add(square(-2 * radius, -2 * radius, 5 * radius), FlangeId{1}, {Loop{hole}});
    EXPECT_TRUE(regions.overlaps().empty()) << radius;
  }
}

TEST(FindOverlaps, LetsATabLieInItsWindow) {
  Regions regions;
  regions.add(square(0, 0, 30), FlangeId{0}, {reversed(square(10, 10, 10))});
  regions.add(shifted(rectangle(10, 8), Vec2(10, 12)), FlangeId{1});
  regions.add(shifted(rectangle(10, 2), Vec2(10, 10)), BendId{0});
  EXPECT_TRUE(regions.overlaps().empty());
}

TEST(FindOverlaps, SeesATabTooLongForItsWindow) {
  Regions regions;
  regions.add(square(0, 0, 30), FlangeId{0}, {reversed(square(10, 10, 10))});
  regions.add(shifted(rectangle(10, 9), Vec2(10, 12)), FlangeId{1});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(area_of(found[0]), 10.0, 0.01);
}

TEST(FindOverlaps, TellsAllPlacesOfAPairOnce) {
  Regions regions;  // a bar over a U: two places
  regions.add(polygon({{0, 0}, {30, 0}, {30, 20}, {20, 20}, {20, 5}, {10, 5}, {10, 20}, {0, 20}}),
              FlangeId{0});
  regions.add(shifted(rectangle(40, 2), Vec2(-5, 15)), FlangeId{1});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_NEAR(area_of(found[0]), 40.0, 0.01);
  EXPECT_THAT(found[0].message, HasSubstr("in 2 places"));
  EXPECT_EQ(found[0].at.size(), 8u);
}

TEST(FindOverlaps, TellsTheFacesOfOneFlangeTogether) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(10, 0, 10), FlangeId{0});
  regions.add(shifted(rectangle(10, 4), Vec2(5, 8)), FlangeId{1});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_NEAR(area_of(found[0]), 20.0, 0.01);
}

TEST(FindOverlaps, TellsLargestFirst) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(9, 0, 10), FlangeId{1});
  regions.add(square(17, 0, 10), FlangeId{2});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(parts_of(found[0]), (std::vector{place::flange(2), place::flange(3)}));
  EXPECT_EQ(parts_of(found[1]), (std::vector{place::flange(1), place::flange(2)}));
}

TEST(FindOverlaps, NamesBendsAsThePatternDoes) {
  Regions regions;
  FlatBend bend;
  bend.id = "B7";
  bend.bend = BendId{0};
  regions.pattern.bends = {bend};
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(9, 0, 10), BendId{0});
  regions.add(square(9, 20, 10), BendId{0});
  regions.add(square(9, 25, 10), BendId{0});
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 2u) << test::text_of(found);
  EXPECT_EQ(found[0].message, "bend B7 overlaps itself by 50 mm² in the flat pattern");
  EXPECT_EQ(found[1].message, "flange 1 and bend B7 overlap by 10 mm² in the flat pattern");
  EXPECT_EQ(parts_of(found[0]), std::vector{place::bend("B7")});
}

// ---- sharp bends

/// Two flanges joined by a sharp bend along x, the second one starting `gap` above the first; a
/// third one reaches from the side into the strip between them.
Regions creased(double gap, double third_at) {
  Regions regions;
  const FaceId first = regions.add(shifted(rectangle(40, 20), Vec2(0, -20)), FlangeId{0});
  const FaceId second = regions.add(shifted(rectangle(40, 20), Vec2(0, gap)), FlangeId{1});
  regions.add(shifted(rectangle(10, 1), Vec2(third_at, 0.5)), FlangeId{2});
  regions.sheet.joints.push_back({{first, 0, 2}, {second, 0, 0}, BendId{0}});
  return regions;
}

TEST(FindOverlaps, SeesWhatCoversTheStripOfASharpBend) {
  EXPECT_TRUE(creased(2.0, 40.0).overlaps().empty());
  const auto found = creased(2.0, 35.0).overlaps();
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_NEAR(area_of(found[0]), 5.0, 0.01);
  EXPECT_THAT(found[0].message, HasSubstr("bend B1"));
}

TEST(FindOverlaps, LetsFacesReachOverEachOtherAtASharpBendSeenFromOutside) {
  EXPECT_TRUE(creased(-1.3, 60.0).overlaps().empty());
  Regions mirrored = creased(-1.3, 60.0);
  Isometry2 mirror = Isometry2::Identity();
  mirror.linear()(0, 0) = -1.0;
  for (std::vector<Loop>& loops : mirrored.layout.images)
    loops.front() = transformed(loops.front(), mirror);
  EXPECT_TRUE(mirrored.overlaps().empty());
}

TEST(FindOverlaps, SeesMoreThanASharpBendExplains) {
  Regions regions = creased(-1.3, 60.0);
  // The second flange has an ear that comes back over the first one.
  regions.layout.images[FaceId{1}].front() = polygon({{0, -1.3},
                                                      {40, -1.3},
                                                      {40, -6},
                                                      {45, -6},
                                                      {45, 20},
                                                      {35, 20},
                                                      {35, -10},
                                                      {30, -10},
                                                      {30, 20},
                                                      {0, 20}});
  EXPECT_FALSE(regions.overlaps().empty());
}

// ---- contours

FlatPattern outline(const std::vector<Vec2>& points) { return test::flat_plate(polygon(points)); }

TEST(FindOverlaps, SeesAContourCrossingItselfWhereNoFaceTells) {
  // A strip 0.1 wide that turns round and runs over its own beginning.
  const auto found = find_overlaps({}, {},
                                   outline({{0, 0},
                                            {100, 0},
                                            {100, 50},
                                            {50, 50},
                                            {50, -20},
                                            {50.1, -20},
                                            {50.1, 49.9},
                                            {99.9, 49.9},
                                            {99.9, 0.1},
                                            {0, 0.1}}));
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_EQ(found[0].code, "overlap");
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_THAT(found[0].message, HasSubstr("the outer contour crosses itself at"));
  EXPECT_THAT(found[0].message, HasSubstr("3 more places"));
  EXPECT_EQ(found[0].at.size(), 4u);
}

TEST(FindOverlaps, CountsTheSecondOfTwoCrossings) {
  // A strip that turns round and crosses itself with both its sides.
  const auto found = find_overlaps(
      {}, {}, outline({{0, 0}, {100, 0}, {100, 50}, {50, -20}, {100, 60}, {0, 60}}));
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("and 1 more place in"));
  EXPECT_EQ(found[0].at.size(), 2u);
}

TEST(FindOverlaps, SeesACrossingAtASmallAngle) {
  // The lower side rises through the upper one, 0.02 over 20 mm: 1 mrad.
  EXPECT_EQ(
      find_overlaps(
          {}, {},
          outline(
              {{0, 0}, {20, 5.02}, {40, 5.06}, {60, 0}, {60, 10}, {40, 5}, {20, 5.04}, {0, 10}}))
          .size(),
      1u);
}

TEST(FindOverlaps, TellsACrossingOnceWhenFacesOverlapThereToo) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(5, 5, 10), FlangeId{1});
  regions.pattern.outer = test::contour(polygon(
      {{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 5}, {15, 5}, {15, 15}, {4, 15}, {4, 10}, {0, 10}}));
  EXPECT_EQ(regions.overlaps().size(), 1u) << test::text_of(regions.overlaps());
}

TEST(FindOverlaps, LetsALanceTouchItself) {
  // A slit of no width into the plate, straight and slanting, with the rounding of a real pattern.
  for (const double noise : {0.0, 1e-12, -1e-12, 1e-9, -1e-9}) {
    const auto found = find_overlaps({}, {},
                                     outline({{0, 0},
                                              {60, 0},
                                              {60, 30.0},
                                              {40, 30},
                                              {30 + noise, 12},
                                              {22.3, 3.1},
                                              {30 - noise, 12},
                                              {40, 30},
                                              {20, 30},
                                              {20 - noise, 10},
                                              {20, 5},
                                              {20 + noise, 10},
                                              {20, 30},
                                              {0, 30}}));
    EXPECT_TRUE(found.empty()) << noise << "\n" << test::text_of(found);
  }
}

/// A slit of no width into a plate, straight and slanting, with the rounding of a real pattern.
std::vector<Vec2> lanced_plate(double noise) {
  return {{0, 0},      {60, 0},          {60, 30.0}, {40, 30}, {30 + noise, 12},
          {22.3, 3.1}, {30 - noise, 12}, {40, 30},   {20, 30}, {20 - noise, 10},
          {20, 5},     {20 + noise, 10}, {20, 30},   {0, 30}};
}

TEST(FindOverlaps, LetsASlitTouchItselfInAnOpeningToo) {
  // Openings run clockwise: what they enclose once, they enclose the other way round.
  for (const double noise : {0.0, 1e-12, -1e-12, 1e-9, -1e-9}) {
    FlatPattern pattern = test::flat_plate(shifted(rectangle(100, 80), Vec2(-20, -20)));
    test::open(pattern, reversed(polygon(lanced_plate(noise))));
    const auto found = find_overlaps({}, {}, pattern);
    EXPECT_TRUE(found.empty()) << noise << "\n" << test::text_of(found);
  }
}

TEST(FindOverlaps, SeesAnOpeningThatCoversItselfWhicheverWayItRuns) {
  // A strip that turns round and runs over its own beginning, cut out of a plate.
  const std::vector<Vec2> over{{0, 0},    {50, 0},  {50, 30}, {20, 30}, {20, -20},
                               {24, -20}, {24, 26}, {46, 26}, {46, 4},  {0, 4}};
  for (const bool back : {false, true}) {
    FlatPattern pattern = test::flat_plate(shifted(rectangle(200, 200), Vec2(-100, -100)));
    const Loop loop = polygon(over);
    test::open(pattern, back ? reversed(loop) : loop);
    const auto found = find_overlaps({}, {}, pattern);
    ASSERT_EQ(found.size(), 1u) << back;
    EXPECT_EQ(found[0].at.size(), 4u) << "the corners of what is covered twice";
    EXPECT_EQ(contour_crossings(pattern).size(), 1u);
  }
}

TEST(FindOverlaps, TellsACrossingBesideAnOverlapThatLiesElsewhere) {
  Regions regions;
  regions.add(square(0, 0, 10), FlangeId{0});
  regions.add(square(5, 5, 10), FlangeId{1});
  regions.pattern.outer = test::contour(
      polygon({{40, 0}, {50, 10}, {50, 0}, {40, 10}}));  // crosses itself at (45, 5)
  const auto found = regions.overlaps();
  ASSERT_EQ(found.size(), 2u) << test::text_of(found);
  EXPECT_THAT(found[1].message, HasSubstr("crosses itself at (45, 5)"));
}

TEST(FindOverlaps, LetsAWindowTouchItsOwnTab) {
  FlatPattern pattern = test::flat_plate(rectangle(60, 40));
  // U-shaped slit of no width around a tab.
  test::open(pattern, polygon({{20, 10}, {20, 30}, {40, 30}, {40, 10}, {40, 30}, {20, 30}}));
  EXPECT_TRUE(find_overlaps({}, {}, pattern).empty());
}

TEST(FindOverlaps, SeesAnOpeningCrossingItself) {
  FlatPattern pattern = test::flat_plate(rectangle(60, 40));
  test::open(pattern, polygon({{20, 10}, {30, 20}, {30, 10}, {20, 20}}));
  const auto found = find_overlaps({}, {}, pattern);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].message, HasSubstr("the opening at (25, 15) crosses itself at (25, 15)"));
}

TEST(FindOverlaps, FindsNothingInNothing) { EXPECT_TRUE(find_overlaps({}, {}, {}).empty()); }

// ---- whole sheets

std::vector<Finding> overlaps_of(const Sheet& sheet, UpSide up = UpSide::automatic) {
  FlattenOptions options;
  options.up = up;
  const auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat.has_value()) << (flat ? "" : flat.error().message);
  return flat ? find_overlaps(sheet, flat->layout, flat->pattern) : std::vector<Finding>{};
}

TEST(FindOverlaps, FindsNothingInSheetsThatDoNotOverlap) {
  for (const Sheet& sheet :
       {test::l_bracket_down(), test::u_channel(), test::staircase(5), test::hem(), test::box(),
        test::box({}, BendDirection::down), test::cone_joined(), test::plate_with_holes(),
        test::slot_across_bend(), test::hole_across_bend(8.0, 0.44), test::rolled(),
        test::truncated_cone(30, 60, 50, Angle::degrees(350), 1.5)}) {
    for (const UpSide up : {UpSide::reference, UpSide::other}) {
      const auto found = overlaps_of(sheet, up);
      EXPECT_TRUE(found.empty()) << test::text_of(found);
    }
  }
}

TEST(FindOverlaps, FindsNothingInCreasedStrips) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
    const test::Crease crease{Angle::degrees(90), direction};
    const auto found = overlaps_of(test::strip(
        {test::Straight{30}, crease, test::Straight{20}, crease, test::Straight{25}}, 40, 2));
    EXPECT_TRUE(found.empty()) << test::text_of(found);
  }
}

TEST(FindOverlaps, FindsNothingInRandomSheetsThatDoNotOverlap) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const auto found = overlaps_of(test::random_sheet(random, 12));
    EXPECT_TRUE(found.empty()) << i << "\n" << test::text_of(found);
  }
}

TEST(FindOverlaps, SeesTwoTabsThatUnfoldIntoOneAnother) {
  // Two tabs bent up from opposite sides of one window 20 wide: each is 12 long when flat.
  test::SheetBuilder builder(1.0);
  const Loop window = reversed(shifted(rectangle(20, 30), Vec2(20, 10)));
  const FaceId base = builder.flange(Frame{}, {rectangle(60, 50), window});
  const test::Turn turn{Angle::degrees(90), 1.0, BendDirection::up};
  int upright = 0;
  for (int border = 0; border < 4; ++border) {
    const test::Rim rim = builder.rim(base, border, 1);
    if (std::abs(rim.frame.y.y()) < 0.5) continue;
    const test::Rim far = builder.bend(rim, turn);
    builder.flange_behind(far, {rectangle(far.length, 12 - std::numbers::pi / 2 * 1.44)});
    ++upright;
  }
  ASSERT_EQ(upright, 2);
  const auto found = overlaps_of(builder.finish());
  ASSERT_EQ(found.size(), 1u) << test::text_of(found);
  EXPECT_NEAR(area_of(found[0]), (2 * 12 - 20) * 30.0, 0.1);
}

}  // namespace
}  // namespace planish
