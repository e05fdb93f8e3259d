#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <planish/inspect/missing_relief.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The same tab without reliefs, the base's edge at the tangent line.
FlatPattern tab_without_relief() {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(polygon(
      {{-30, -40}, {30, -40}, {30, 0}, {10, 0}, {10, w + 20}, {-10, w + 20}, {-10, 0}, {-30, 0}}));
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
  return pattern;
}

TEST(BendRelief, IsMissedAtBothEndsOfATabOnAnEdge) {
  const auto found = findings_of(tab_without_relief());
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(
      messages(found),
      ElementsAre("bend B1 ends flush with an edge at (-10, 0), where the corner bulges a little",
                  HasSubstr("at (10, 0), where")));
  EXPECT_EQ(found[0].code, "flush_bend");
  EXPECT_NEAR((found[0].at.at(0) - Vec2(-10, 0)).norm(), 0.0, 1e-9);
}

TEST(BendRelief, IsMissedInALance) {
  // Slits of no width, down to the tangent line, the base going on beside the tab.
  EXPECT_EQ(of_code(findings_of(tab(15.0, 0.0, 0.0)), "bend_relief").size(), 2u);
}

TEST(BendRelief, HasNoWidthInADeepLance) {
  const auto found = findings_of(tab(15.0, 0.0, 6.0));
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("at (-10, 0) is 0 mm wide"));
}

TEST(BendRelief, IsMissedWhereBothFlangesGoOn) {
  // A bend 20 wide between two plates 60 wide: reliefs on one side only, then on both.
  const double w = test::zone_width();
  for (const double upper : {0.0, 1.0}) {
    std::vector<Vec2> points{{0, -40}, {30, -40}, {30, 0},        {12, 0},
                             {12, -1}, {10, -1},  {10, w + upper}};
    for (const Vec2& p : {Vec2(12, w + upper), Vec2(12, w), Vec2(30, w), Vec2(30, w + 40)})
      points.push_back(p);
    points.erase(points.begin());
    for (size_t i = points.size(); i-- > 0;)
      points.emplace_back(-points[i].x(), points[i].y());
    FlatPattern pattern = flat_plate(polygon(points));
    test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
    const auto found = findings_of(pattern);
    if (upper > 0.0) {
      EXPECT_TRUE(found.empty()) << text_of(found);
    } else {
      ASSERT_EQ(found.size(), 2u) << text_of(found);
      EXPECT_THAT(found[0].message, HasSubstr("flush with an edge"));
      EXPECT_NEAR(found[0].at.at(0).y(), w, 1e-9);
    }
  }
}

TEST(BendRelief, IsEnoughWhenAsWideAsTheSheetIsThick) {
  EXPECT_TRUE(findings_of(tab(15.0, 2.0, 1.0)).empty())
      << text_of(findings_of(tab(15.0, 2.0, 1.0)));
  EXPECT_TRUE(findings_of(tab(0.0, 2.0, 1.0)).empty());
}

TEST(BendRelief, IsTooNarrowBelowTheThickness) {
  const auto found = findings_of(tab(15.0, 2.0 - kJustShort, 1.0));
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_EQ(found[0].message,
            "the relief of bend B1 at (-10, 0) is 1.99 mm wide; at least 2 mm (T) is needed");
  EXPECT_EQ(findings_of(tab(0.0, 2.0 - kJustShort, 1.0)).size(), 2u);
}

TEST(BendRelief, MustReachTheTangentLine) {
  // R + T from the outside of the bend is the tangent line.
  const auto found = findings_of(tab(15.0, 3.0, -0.5));
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("without relief; it needs one"));
  ASSERT_EQ(found[0].remedies.size(), 2u);
  EXPECT_EQ(found[0].remedies[0].option, "bend_relief");
  EXPECT_EQ(found[0].remedies[0].value, "square");
  EXPECT_EQ(found[0].remedies[1].value, "round");
}

TEST(BendRelief, HasItsDepthMeasuredFromTheOutside) {
  Rules rules = strict_rules();
  rules.relief_depth_t = 1.5;  // 5 mm from the outside: 1 mm beyond the tangent line
  EXPECT_TRUE(findings_of(tab(15.0, 2.0, 1.0), rules).empty())
      << text_of(findings_of(tab(15.0, 2.0, 1.0), rules));
  const auto found = findings_of(tab(15.0, 2.0, 1.0 - kJustShort), rules);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_EQ(found[0].message,
            "the relief of bend B1 at (-10, 0) is 4.99 mm deep from the outside of the bend; at "
            "least 5 mm (1.5 T + R) is "
            "needed");
}

TEST(BendRelief, IsNotAskedForWhereTheEdgeIsSteppedBack) {
  EXPECT_TRUE(findings_of(tab(-0.5, 2.0, 0.5)).empty());
}

TEST(BendRelief, IsNotAskedForAtFreeEnds) {
  // Edges square to the bend, slanting outwards or inwards by up to 60°.
  for (const double slope : {0.0, 0.5, -0.5, 1.7, -1.7}) {
    FlatPattern pattern = flat_plate(
        polygon({{-20, 0}, {20, 0}, {20, 40 + 20 * slope}, {-20, 40 - 20 * slope}}));
    const double half = 0.5 * test::zone_width();
    FlatBend& bend = test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
    bend.tangent_lines = {{Vec2(-half, 0), Vec2(-half, 40 - half * slope)},
                          {Vec2(half, 0), Vec2(half, 40 + half * slope)}};
    EXPECT_TRUE(findings_of(pattern).empty()) << slope << text_of(findings_of(pattern));
  }
}

TEST(BendRelief, IsMissedOnceWhereTwoBendsMeetInACorner) {
  const double w = test::zone_width();
  // Base 0…40 square, walls at its left and lower side, bends meeting at the origin.
  FlatPattern pattern = flat_plate(
      polygon({{0, -w - 20}, {40, -w - 20}, {40, 40}, {-w - 20, 40}, {-w - 20, 0}, {0, 0}}));
  test::add_bend(pattern, {Vec2(0, -0.5 * w), Vec2(40, -0.5 * w)});
  test::add_bend(pattern, {Vec2(-0.5 * w, 0), Vec2(-0.5 * w, 40)});
  const Finding found = only(findings_of(pattern), "flush_bend");
  EXPECT_NEAR(found.at.at(0).norm(), 0.0, 1e-9);
}

TEST(BendRelief, IsEnoughInARelievedCorner) {
  for (const UpSide up : {UpSide::reference, UpSide::other}) {
    const Sheet sheet = test::box();
    FlattenOptions options;
    options.up = up;
    const auto pattern = flatten(sheet, options);
    ASSERT_TRUE(pattern.has_value());
    const auto found = check_rules(sheet, *pattern, strict_rules());
    EXPECT_TRUE(found.empty()) << text_of(found);
  }
}

TEST(BendRelief, MayBeAHole) {
  // A tab with slits of no width that end in holes of 2.4 at the corners of the bend.
  const double w = test::zone_width();
  Loop loop = polygon({{-30, -40}, {30, -40}, {30, 15}, {10, 15}, {10, 1.2}});
  loop.pop_back();
  loop.push_back(Arc{Vec2(10, 0), 1.2, 0.5 * std::numbers::pi, -1.5 * std::numbers::pi});
  loop.push_back(Segment{Vec2(8.8, 0), Vec2(8.8, w + 20)});
  for (const Segment& curve :
       {Segment{Vec2(8.8, w + 20), Vec2(-10, w + 20)}, Segment{Vec2(-10, w + 20), Vec2(-10, -3)},
        Segment{Vec2(-10, -3), Vec2(-30, -3)}, Segment{Vec2(-30, -3), Vec2(-30, -40)}})
    loop.push_back(curve);
  FlatPattern pattern = flat_plate(loop);
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(8.8, 0.5 * w)});
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
}

Severity worst_of(const FlatPattern& pattern, Rules rules = {}, const char* code = "bend_relief") {
  return of_code(check_rules({}, pattern, rules), code).at(0).severity;
}

TEST(BendRelief, IsAWarningWhereTheSheetGoesOnBesideTheBend) {
  EXPECT_EQ(worst_of(tab(15.0, 0.0, 0.0)), Severity::warning);
  // An edge flush with the bend's tangent line bulges a little.
  EXPECT_EQ(worst_of(tab_without_relief(), {}, "flush_bend"), Severity::info);
  EXPECT_EQ(worst_of(tab_without_relief(), strict_rules(), "flush_bend"), Severity::warning);
}

TEST(BendRelief, OfAKerfIsInformationAndAShallowOneAWarning) {
  // Laser: half the thickness wide.
  EXPECT_EQ(worst_of(tab(15.0, 0.2, 1.0)), Severity::info);
  EXPECT_TRUE(check_rules({}, tab(15.0, 1.0, 1.0), {}).empty());
  Rules deep;
  deep.relief_depth_t = 7.0;  // R + 7 T: 12 mm beyond the tangent line, of 16 in all
  EXPECT_EQ(worst_of(tab(15.0, 2.0, 4.1), deep), Severity::info) << "8.1 of 16 mm";
  EXPECT_EQ(worst_of(tab(15.0, 2.0, 3.9), deep), Severity::warning) << "7.9 of 16 mm";
}

TEST(BendRelief, NamesOneBesideAFlushEdgeIfTheRulesWantItDeeper) {
  Rules rules = strict_rules();
  rules.relief_depth_t = 1.5;
  const auto found = findings_of(tab_without_relief(), rules);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_EQ(found[0].message,
            "bend B1 ends flush with an edge at (-10, 0) without relief; it needs one 2 mm (T) "
            "wide and, from the outside of the bend, 5 mm (1.5 T + R) deep");
}

TEST(BendRelief, ToBeCutIsAStripOverTheBendZoneAndIntoTheFlange) {
  Rules rules = strict_rules();
  rules.relief_depth_t = 1.5;  // 1 mm beyond the tangent line
  const auto missing = missing_reliefs({}, tab(15.0, 0.0, 0.0), rules);
  ASSERT_EQ(missing.size(), 2u);
  for (const MissingRelief& place : missing) {
    const double side = place.corner.x() < 0.0 ? -1.0 : 1.0;
    EXPECT_EQ(place.bend, "B1");
    EXPECT_NEAR((place.corner - Vec2(side * 10, 0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((place.beyond - Vec2(side, 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((place.into_flange - Vec2(0, -1)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(place.width, 2.0, 1e-12);
    EXPECT_NEAR(place.depth, 1.0, 1e-12);
    EXPECT_NEAR(place.zone, test::zone_width(), 1e-9);
    EXPECT_EQ(place.web, 0.0);
    EXPECT_FALSE(place.on_both_sides);
  }
}

TEST(BendRelief, ToBeCutLeavesNoThinWebBehindIt) {
  // 3 mm of sheet beside the tab behind the bend zone, where webs of 4 mm are asked for, then 5 mm.
  const double w = test::zone_width();
  EXPECT_NEAR(missing_reliefs({}, tab(w + 3.0, 0.0, 0.0), strict_rules()).at(0).web, 3.0, 1e-9);
  EXPECT_NEAR(missing_reliefs({}, tab(w + 5.0, 0.0, 0.0), strict_rules()).at(0).web, 0.0, 1e-9);
}

TEST(BendRelief, NeedsNoCutWhereTheEdgeIsFlush) {
  EXPECT_TRUE(missing_reliefs({}, tab_without_relief(), strict_rules()).empty());
}

TEST(BendRelief, CanBeSwitchedOff) {
  Rules rules = strict_rules();
  rules.relief_width_t = 0.0;
  EXPECT_TRUE(findings_of(tab_without_relief(), rules).empty());
}

std::vector<Finding> relief_findings(const FlatPattern& pattern,
                                     const Rules& rules = strict_rules()) {
  return of_code(findings_of(pattern, rules), "bend_relief");
}

TEST(BendRelief, IsACutOutIfDeeperThanFiveTimesTheOutsideRadius) {
  // R + T is 4: beyond 20 mm there is nothing to relieve.
  for (const double width : {0.0, 1.0}) {
    EXPECT_EQ(relief_findings(tab(15.0, width, 9.0)).size(), 2u) << width;
    EXPECT_TRUE(relief_findings(tab(15.0, width, 25.0)).empty()) << width;
  }
}

/// A tab of 20 whose relief on the right has these corners, from its far side back to the tab; that
/// on the left is large.
FlatPattern tab_beside(const std::vector<Vec2>& relief) {
  const double w = test::zone_width();
  std::vector<Vec2> corners{{-30, -40}, {30, -40}, {30, 15}};
  corners.insert(corners.end(), relief.begin(), relief.end());
  for (const Vec2& corner : {Vec2(10, w + 20), Vec2(-10, w + 20), Vec2(-10, -5), Vec2(-16, -5),
                             Vec2(-16, 15), Vec2(-30, 15)})
    corners.push_back(corner);
  FlatPattern pattern = flat_plate(polygon(corners));
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
  return pattern;
}

TEST(BendRelief, HasItsDepthInTheMiddleOfTheWidthThatItNeeds) {
  Rules rules = strict_rules();
  rules.relief_depth_t = 2.5;  // 7 mm from the outside: 3 mm beyond the tangent line
  // 4 mm wide where 2 are needed, its bottom slanting: 1 mm from the bend it is 2 mm deep.
  const auto slanting = relief_findings(tab_beside({{14, 15}, {14, -5}, {10, -1}}), rules);
  ASSERT_EQ(slanting.size(), 1u) << text_of(slanting);
  EXPECT_NEAR(number_of(slanting[0], "measured"), 4.0 + 2.0, 1e-6);
  EXPECT_TRUE(
      relief_findings(tab_beside({{14, 15}, {14, -4}, {10, -2.1}, {10, -2.9}}), rules).size() ==
      1u);
  EXPECT_TRUE(relief_findings(tab_beside({{14, 15}, {14, -3.1}, {10, -3.1}}), rules).empty());
}

TEST(BendRelief, IsMissedWhereTheSheetGoesOnBehindASlotAlongTheTangentLine) {
  // A slot of half a millimetre beside the bend zone, closed on the flange's side and behind it.
  const auto found = findings_of(tab_beside({{10, 15}, {10, 0.5}, {14, 0.5}, {14, 0}, {10, 0}}));
  ASSERT_EQ(found.size(), 1u) << text_of(found);
  EXPECT_EQ(found[0].code, "bend_relief");
  EXPECT_THAT(found[0].message, HasSubstr("without relief"));
}

TEST(BendRelief, IsSeenBesideAnEdgeThatSlantsAway) {
  // Sheet beside the tab falls off from the tangent line, by 10 and by 60 degrees: it goes on; at
  // more than four to one it does not.
  const double w = test::zone_width();
  for (const auto& [drop, count] : {std::pair{0.02, 2u}, std::pair{5.0, 0u}}) {
    FlatPattern pattern = flat_plate(polygon({{-30, -40},
                                              {30, -40},
                                              {30, -20 * drop},
                                              {10, 0},
                                              {10, w + 20},
                                              {-10, w + 20},
                                              {-10, 0},
                                              {-30, -20 * drop}}));
    if (drop > 1.0)
      pattern = flat_plate(polygon({{-16, -40},
                                    {16, -40},
                                    {16, -30},
                                    {10, 0},
                                    {10, w + 20},
                                    {-10, w + 20},
                                    {-10, 0},
                                    {-16, -30}}));
    test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
    EXPECT_EQ(of_code(findings_of(pattern), "flush_bend").size(), count) << drop;
    EXPECT_TRUE(relief_findings(pattern).empty()) << drop;
  }
}

TEST(BendRelief, NamesTheSideOnWhichTheSheetGoesOnBeforeANarrowOne) {
  // A bend that ends within a plate, at a slot 1 mm wide below; above, the sheet goes on.
  const double w = test::zone_width();
  for (const bool turned : {false, true}) {
    FlatPattern pattern = flat_plate(shifted(rectangle(40, w + 80), Vec2(-10, -40)));
    open(pattern, rectangular_opening({10.5, -0.5}, 1, 3));
    test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
    Isometry2 motion = Isometry2::Identity();
    if (turned) motion.rotate(3.14159265358979323846);
    pattern = test::moved(pattern, motion);
    const auto found = relief_findings(pattern);
    ASSERT_EQ(found.size(), 1u) << text_of(found);
    EXPECT_NEAR((found[0].at.at(0) - motion * Vec2(10, w)).norm(), 0.0, 1e-9) << found[0].message;
  }
}

TEST(BendRelief, NamesTheNarrowerOfTwoAtABendsEnd) {
  // A bend that ends within a plate at two slots, the one below and the one above it.
  const double w = test::zone_width();
  for (const auto& [below, above] : {std::pair{1.0, 1.4}, std::pair{1.4, 1.0}}) {
    FlatPattern pattern = flat_plate(shifted(rectangle(40, w + 80), Vec2(-10, -40)));
    open(pattern, rectangular_opening({10 + 0.5 * below, -0.5}, below, 3));
    open(pattern, rectangular_opening({10 + 0.5 * above, w + 0.5}, above, 3));
    test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
    const auto found = relief_findings(pattern);
    ASSERT_EQ(found.size(), 1u) << text_of(found);
    EXPECT_NEAR(number_of(found[0], "measured"), 1.0, 1e-6);
    EXPECT_NEAR(found[0].at.at(0).y(), below < above ? 0.0 : w, 1e-9);
  }
}

TEST(BendRelief, IsMissedTwiceWhereBendsEndFartherApartThanTheSheetIsThick) {
  const double w = test::zone_width();
  for (const auto& [apart, count] : {std::pair{1.5, 3u}, std::pair{2.5, 4u}}) {
    // Two tabs of 20 on one edge with a gap between them.
    FlatPattern pattern = flat_plate(polygon({{-50, -40},
                                              {50, -40},
                                              {50, 0},
                                              {apart + 20, 0},
                                              {apart + 20, w + 20},
                                              {apart, w + 20},
                                              {apart, 0},
                                              {0, 0},
                                              {0, w + 20},
                                              {-20, w + 20},
                                              {-20, 0},
                                              {-50, 0}}));
    test::add_bend(pattern, {Vec2(-20, 0.5 * w), Vec2(0, 0.5 * w)});
    test::add_bend(pattern, {Vec2(apart, 0.5 * w), Vec2(apart + 20, 0.5 * w)});
    EXPECT_EQ(of_code(findings_of(pattern), "flush_bend").size(), count) << apart;
  }
}

TEST(BendRelief, ToBeCutOnBothSidesWhereABendEndsWithinAPlate) {
  FlatPattern pattern = flat_plate(shifted(rectangle(80, 100), Vec2(-40, -50)));
  test::add_bend(pattern, {Vec2(-10, 0), Vec2(12, 0)});
  Rules rules = strict_rules();
  rules.relief_depth_t = 1.5;
  const auto missing = missing_reliefs({}, pattern, rules);
  ASSERT_EQ(missing.size(), 2u);
  for (const MissingRelief& place : missing) {
    EXPECT_TRUE(place.on_both_sides);
    EXPECT_NEAR(place.zone, test::zone_width(), 1e-9);
    EXPECT_NEAR(std::abs(place.corner.y()), 0.5 * test::zone_width(), 1e-9);
    EXPECT_NEAR(place.beyond.x(), place.corner.x() < 0.0 ? -1.0 : 1.0, 1e-12);
    EXPECT_NEAR(place.into_flange.y(), place.corner.y() < 0.0 ? -1.0 : 1.0, 1e-12);
    EXPECT_EQ(place.web, 0.0);
  }
  EXPECT_NEAR(missing[0].corner.x() + missing[1].corner.x(), 2.0, 1e-9) << "at both ends";
}

TEST(BendRelief, SeesASlitAsACut) {
  // A bend within a plate between two slits drawn once: narrow reliefs, not missing ones.
  FlatPattern pattern = flat_plate(shifted(rectangle(80, 100), Vec2(-40, -50)));
  const double half = 0.5 * test::zone_width();
  test::add_bend(pattern, {Vec2(-10, 0), Vec2(10, 0)});
  for (const double x : {-10.0, 10.0})
    pattern.slits.emplace_back(Segment{{x, -half - 6}, {x, half + 6}});
  const auto found = relief_findings(pattern);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  for (const Finding& one : found)
    EXPECT_THAT(one.message, HasSubstr("is 0 mm wide"));
}

}  // namespace
}  // namespace planish::test
