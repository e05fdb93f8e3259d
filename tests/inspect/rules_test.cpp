#include "flat_plates.hpp"
#include "support/sheets.hpp"

#include <planish/inspect/findings.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace planish {
namespace {

using test::BendShape;
using test::circular_opening;
using test::flat_l;
using test::flat_plate;
using test::of_code;
using test::open;
using test::polygon;
using test::rectangle;
using test::rectangular_opening;
using test::shifted;
using test::text_of;
using testing::ElementsAre;
using testing::HasSubstr;

// Everything here is of 2 mm sheet, so the limits are: flange height 1.5 T + R, opening to bend 4,
// to edge 4, to opening 10, smallest opening 2, inside radius 2, relief 2 wide.
constexpr double kT = 2.0;
constexpr double kJustShort = 0.01;

std::vector<Finding> check(const FlatPattern& pattern, const Rules& rules = {}) {
  return check_rules({}, pattern, rules);
}

std::vector<std::string> messages(const std::vector<Finding>& findings) {
  std::vector<std::string> result;
  for (const Finding& f : findings)
    result.push_back(f.message);
  return result;
}

/// The only finding, which must have this code.
Finding only(const std::vector<Finding>& findings, const std::string& code) {
  EXPECT_EQ(findings.size(), 1u) << text_of(findings);
  if (findings.size() != 1) return {};
  EXPECT_EQ(findings[0].code, code) << findings[0].message;
  EXPECT_EQ(findings[0].severity, Severity::warning);
  return findings[0];
}

// ---- the list of rules

TEST(RuleFields, NameEveryThresholdOnce) {
  std::vector<std::string> names;
  std::vector<double> values;
  const Rules defaults;
  for (const RuleField& field : rule_fields()) {
    names.emplace_back(field.name);
    values.push_back(defaults.*field.value);
    EXPECT_FALSE(field.description.empty());
    EXPECT_FALSE(field.origin.empty());
  }
  EXPECT_THAT(names,
              ElementsAre("flange_height_t", "flange_height_r", "opening_to_bend_t",
                          "opening_to_edge_t", "opening_to_opening_t", "smallest_opening_t",
                          "inside_radius_t", "relief_width_t", "relief_depth_r", "relief_depth_t",
                          "hem_diameter_t", "hem_return_t", "k_low", "k_high"));
  EXPECT_THAT(values, ElementsAre(1.5, 1, 2, 2, 5, 1, 1, 1, 1, 1, 1, 6, 0.2, 0.5))
      << "defaults of SHOPFLOOR";
  // Every threshold is a double, `enabled` the only other member: none can be missing.
  EXPECT_EQ(sizeof(Rules), rule_fields().size() * sizeof(double) + sizeof(double));
}

TEST(CheckRules, FindsNothingInGoodParts) {
  FlatPattern pattern = flat_l(50, 30);
  open(pattern, circular_opening({-30, 20}, 4));
  open(pattern, rectangular_opening({20, 20}, 10, 12));
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
  EXPECT_TRUE(check(flat_plate(rectangle(10, 10))).empty());
}

TEST(CheckRules, FindsNothingInNothing) { EXPECT_TRUE(check({}).empty()); }

TEST(CheckRules, FindsNothingWhenSwitchedOff) {
  FlatPattern pattern = flat_l(50, 0.1, {90, 0.5, 0.9});
  open(pattern, circular_opening({-49, 20}, 0.5));
  EXPECT_GE(check(pattern).size(), 4u);
  Rules rules;
  rules.enabled = false;
  EXPECT_TRUE(check(pattern, rules).empty());
}

// ---- flange height: 5 mm from the outside leaves 1 mm flat

TEST(FlangeHeight, IsMeasuredFromTheOutsideOfTheBend) {
  const Finding found = only(check(flat_l(50, 1 - kJustShort)), "flange_height");
  EXPECT_EQ(found.message,
            "the flange at bend B1 is 4.99 mm high from the outside of the bend, at least 5 mm "
            "(1.5 T + R) is needed");
  ASSERT_EQ(found.at.size(), 1u);
  EXPECT_NEAR(found.at[0].x(), 0.5 * test::zone_width(), 1e-9);
}

TEST(FlangeHeight, IsEnoughAtTheLimit) {
  EXPECT_TRUE(check(flat_l(1, 1)).empty()) << text_of(check(flat_l(1, 1)));
}

TEST(FlangeHeight, NeedsTheSameFlatLengthAtEveryAngle) {
  for (const double degrees : {20.0, 45.0, 120.0, 160.0}) {
    EXPECT_TRUE(check(flat_l(50, 1, {degrees})).empty()) << degrees;
    only(check(flat_l(50, 1 - kJustShort, {degrees})), "flange_height");
  }
}

TEST(FlangeHeight, FollowsTheThresholds) {
  Rules rules;
  rules.flange_height_t = 4.0;
  rules.flange_height_r = 0.0;
  EXPECT_TRUE(check(flat_l(50, 4), rules).empty());  // 8 mm from the outside
  EXPECT_THAT(only(check(flat_l(50, 4 - kJustShort), rules), "flange_height").message,
              HasSubstr("8 mm (4 T)"));
  rules.flange_height_t = 0.0;
  EXPECT_TRUE(check(flat_l(50, 0.01), rules).empty());
}

TEST(FlangeHeight, LetsChamferedAndRoundedEndsPass) {
  const double x = 0.5 * test::zone_width();
  // 6 mm flat with chamfers down to 0.5 mm at both ends.
  FlatPattern pattern = flat_plate(
      polygon({{-50, 0}, {x + 0.5, 0}, {x + 5, 4.5}, {x + 5, 35.5}, {x + 0.5, 40}, {-50, 40}}));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
}

TEST(FlangeHeight, SeesANotchInTheMiddle) {
  const double x = 0.5 * test::zone_width();
  FlatPattern pattern = flat_plate(polygon({{-50, 0},
                                            {x + 9, 0},
                                            {x + 9, 15},
                                            {x + 0.7, 15},
                                            {x + 0.7, 25},
                                            {x + 9, 25},
                                            {x + 9, 40},
                                            {-50, 40}}));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  EXPECT_THAT(only(check(pattern), "flange_height").message, HasSubstr("4.7 mm high"));
}

TEST(FlangeHeight, IsToldOnceForTheWebBetweenTwoBends) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(shifted(rectangle(60 + 2 * w, 40), Vec2(-30 - 0.5 * w, 0)));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  test::add_bend(pattern, {Vec2(w + 0.6, 0), Vec2(w + 0.6, 40)});
  EXPECT_EQ(only(check(pattern), "flange_height").message,
            "the flange between bends B1 and B2 is 4.6 mm high from the outside of the bend, at "
            "least 5 mm (1.5 T + R) is "
            "needed");
}

TEST(FlangeHeight, LetsBendsGoOnInOneAnother) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(shifted(rectangle(60 + 2 * w, 40), Vec2(-30 - 0.5 * w, 0)));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  test::add_bend(pattern, {Vec2(w, 0), Vec2(w, 40)});
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
}

TEST(FlangeHeight, LetsRolledBendsEndAtTheEdge) {
  EXPECT_TRUE(check(flat_l(50, 0, {90, 40})).empty()) << text_of(check(flat_l(50, 0, {90, 40})));
  EXPECT_THAT(only(check(flat_l(50, 0, {90, 4})), "flange_height").message,
              HasSubstr("is 6 mm high"));
}

TEST(FlangeHeight, IsMeasuredToTheWindowATabIsCutFrom) {
  const double w = test::zone_width();
  for (const double flat : {1.0, 0.9}) {
    FlatPattern pattern = flat_plate(shifted(rectangle(100, 80), Vec2(-50, -40)));
    // A tab 20 wide, bend line at x = 0, free edge at x = w/2 + flat, window 4 mm wide around it
    // with reliefs 3 mm deep.
    const double edge = 0.5 * w + flat;
    const double deep = -0.5 * w - 3;
    open(pattern, reversed(polygon({{deep, -14},
                                    {edge + 4, -14},
                                    {edge + 4, 14},
                                    {deep, 14},
                                    {deep, 10},
                                    {edge, 10},
                                    {edge, -10},
                                    {deep, -10}})));
    test::add_bend(pattern, {Vec2(0, -10), Vec2(0, 10)});
    const auto found = check(pattern);
    if (flat < 1.0) {
      EXPECT_THAT(only(found, "flange_height").message, HasSubstr("4.9 mm high"));
    } else {
      EXPECT_TRUE(found.empty()) << text_of(found);
    }
  }
}

// ---- relief

/// A tab 20 wide on top of a base 60 wide and 40 high, bend along x. The base's edges beside the
/// tab are at `shoulder` above the tangent line; reliefs `width` wide reach `depth` below it.
FlatPattern tab(double shoulder, double width, double depth) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(polygon({{-30, -40},
                                            {30, -40},
                                            {30, shoulder},
                                            {10 + width, shoulder},
                                            {10 + width, -depth},
                                            {10, -depth},
                                            {10, w + 20},
                                            {-10, w + 20},
                                            {-10, -depth},
                                            {-10 - width, -depth},
                                            {-10 - width, shoulder},
                                            {-30, shoulder}}));
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
  return pattern;
}

/// The same tab without reliefs, the base's edge at the tangent line.
FlatPattern tab_without_relief() {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(polygon(
      {{-30, -40}, {30, -40}, {30, 0}, {10, 0}, {10, w + 20}, {-10, w + 20}, {-10, 0}, {-30, 0}}));
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
  return pattern;
}

TEST(BendRelief, IsMissedAtBothEndsOfATabOnAnEdge) {
  const auto found = check(tab_without_relief());
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(messages(found), ElementsAre("bend B1 ends inside an edge at (-10, 0) without "
                                           "relief; it needs one 2 mm (T) wide and, from "
                                           "the outside of the bend, 4 mm (T + R) deep",
                                           HasSubstr("at (10, 0) without relief")));
  EXPECT_EQ(found[0].code, "bend_relief");
  EXPECT_NEAR((found[0].at.at(0) - Vec2(-10, 0)).norm(), 0.0, 1e-9);
}

TEST(BendRelief, IsMissedInALance) {
  // Slits of no width, down to the tangent line, the base going on beside the tab.
  EXPECT_EQ(of_code(check(tab(15.0, 0.0, 0.0)), "bend_relief").size(), 2u);
}

TEST(BendRelief, HasNoWidthInADeepLance) {
  const auto found = check(tab(15.0, 0.0, 6.0));
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
    const auto found = check(pattern);
    if (upper > 0.0) {
      EXPECT_TRUE(found.empty()) << text_of(found);
    } else {
      ASSERT_EQ(found.size(), 2u) << text_of(found);
      EXPECT_THAT(found[0].message, HasSubstr("without relief"));
      EXPECT_NEAR(found[0].at.at(0).y(), w, 1e-9);
    }
  }
}

TEST(BendRelief, IsEnoughWhenAsWideAsTheSheetIsThick) {
  EXPECT_TRUE(check(tab(15.0, 2.0, 1.0)).empty()) << text_of(check(tab(15.0, 2.0, 1.0)));
  EXPECT_TRUE(check(tab(0.0, 2.0, 1.0)).empty());
}

TEST(BendRelief, IsTooNarrowBelowTheThickness) {
  const auto found = check(tab(15.0, 2.0 - kJustShort, 1.0));
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_EQ(found[0].message,
            "the relief of bend B1 at (-10, 0) is 1.99 mm wide, at least 2 mm (T) is needed");
  EXPECT_EQ(check(tab(0.0, 2.0 - kJustShort, 1.0)).size(), 2u);
}

TEST(BendRelief, MustReachTheTangentLine) {
  // R + T from the outside of the bend is the tangent line.
  const auto found = check(tab(15.0, 3.0, -0.5));
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("without relief"));
}

TEST(BendRelief, HasItsDepthMeasuredFromTheOutside) {
  Rules rules;
  rules.relief_depth_t = 1.5;  // 5 mm from the outside: 1 mm beyond the tangent line
  EXPECT_TRUE(check(tab(15.0, 2.0, 1.0), rules).empty())
      << text_of(check(tab(15.0, 2.0, 1.0), rules));
  const auto found = check(tab(15.0, 2.0, 1.0 - kJustShort), rules);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_EQ(found[0].message,
            "the relief of bend B1 at (-10, 0) is 4.99 mm deep from the outside of the bend, at "
            "least 5 mm (1.5 T + R) is "
            "needed");
}

TEST(BendRelief, IsNotAskedForWhereTheEdgeIsSteppedBack) {
  EXPECT_TRUE(check(tab(-0.5, 2.0, 0.5)).empty());
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
    EXPECT_TRUE(check(pattern).empty()) << slope << text_of(check(pattern));
  }
}

TEST(BendRelief, IsMissedOnceWhereTwoBendsMeetInACorner) {
  const double w = test::zone_width();
  // Base 0…40 square, walls at its left and lower side, bends meeting at the origin.
  FlatPattern pattern = flat_plate(
      polygon({{0, -w - 20}, {40, -w - 20}, {40, 40}, {-w - 20, 40}, {-w - 20, 0}, {0, 0}}));
  test::add_bend(pattern, {Vec2(0, -0.5 * w), Vec2(40, -0.5 * w)});
  test::add_bend(pattern, {Vec2(-0.5 * w, 0), Vec2(-0.5 * w, 40)});
  const Finding found = only(check(pattern), "bend_relief");
  EXPECT_NEAR(found.at.at(0).norm(), 0.0, 1e-9);
}

TEST(BendRelief, IsEnoughInARelievedCorner) {
  for (const UpSide up : {UpSide::reference, UpSide::other}) {
    const Sheet sheet = test::box();
    FlattenOptions options;
    options.up = up;
    const auto pattern = flatten(sheet, options);
    ASSERT_TRUE(pattern.has_value());
    const auto found = check_rules(sheet, *pattern, {});
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
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
}

TEST(BendRelief, CanBeSwitchedOff) {
  Rules rules;
  rules.relief_width_t = 0.0;
  EXPECT_TRUE(check(tab_without_relief(), rules).empty());
}

// ---- inside radius, hems, K

TEST(InsideRadius, IsAtLeastTheThickness) {
  EXPECT_TRUE(check(flat_l(50, 30, {90, kT})).empty());
  EXPECT_EQ(only(check(flat_l(50, 30, {90, 1.9})), "inside_radius").message,
            "the inside radius of bend B1 is 1.9 mm, at least 2 mm (T) is needed");
  Rules steel;
  steel.inside_radius_t = 0.5;
  EXPECT_TRUE(check(flat_l(50, 30, {90, 1.0}), steel).empty());
}

TEST(InsideRadius, OfASharpBendIsZero) {
  FlatPattern pattern = flat_plate(shifted(rectangle(60, 40), Vec2(-30, 0)));
  FlatBend& bend = test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)}, {90, 0.0, 0.3});
  bend.kind = BendKind::sharp;
  EXPECT_THAT(only(check(pattern), "inside_radius").message, HasSubstr("is 0 mm"));
  // No allowance at all: both tangent lines are the bend line.
  bend.tangent_lines = {bend.lines.front(), bend.lines.front()};
  EXPECT_THAT(only(check(pattern), "inside_radius").message, HasSubstr("is 0 mm"));
}

TEST(Hem, NeedsAnInsideDiameterOfTheThickness) {
  EXPECT_TRUE(check(flat_l(50, 20, {180, 1.0})).empty())
      << text_of(check(flat_l(50, 20, {180, 1.0})));
  EXPECT_EQ(only(check(flat_l(50, 20, {180, 0.9})), "hem").message,
            "the hem at bend B1 is 1.8 mm wide inside, at least 2 mm (T) is needed");
}

TEST(Hem, NeedsAReturnOfSixTimesTheThickness) {
  // 12 mm from the outside of a bend of R 1: 9 mm flat.
  EXPECT_TRUE(check(flat_l(50, 9, {180, 1.0})).empty())
      << text_of(check(flat_l(50, 9, {180, 1.0})));
  EXPECT_EQ(only(check(flat_l(50, 9 - kJustShort, {180, 1.0})), "hem").message,
            "the return of the hem at bend B1 is 11.99 mm long from the outside of the bend, at "
            "least 12 mm (6 T) is "
            "needed");
}

TEST(Hem, BeginsAt170Degrees) {
  EXPECT_TRUE(check(flat_l(50, 3, {169.9})).empty());
  only(check(flat_l(50, 3, {170.0})), "hem");
}

TEST(KFactor, IsDoubtedOutsideItsRange) {
  EXPECT_TRUE(check(flat_l(50, 30, {90, 2, 0.2})).empty());
  EXPECT_TRUE(check(flat_l(50, 30, {90, 2, 0.5})).empty());
  EXPECT_THAT(only(check(flat_l(50, 30, {90, 2, 0.19})), "k_factor").message,
              HasSubstr("K-factor 0.19 (test)"));
  EXPECT_EQ(only(check(flat_l(50, 30, {90, 2, 0.6})), "k_factor").message,
            "bend B1 has the K-factor 0.6 (test), outside [0.2, 0.5] where measured ones lie");
}

TEST(KFactor, IsDoubtedOnceForAllBendsThatHaveIt) {
  FlatPattern pattern = flat_l(50, 30, {90, 2, 0.6});
  test::add_bend(pattern, {Vec2(-20, 0), Vec2(-20, 40)}, {90, 2, 0.6});
  test::add_bend(pattern, {Vec2(-40, 0), Vec2(-40, 40)}, {90, 2, 0.7});
  const auto found = check(pattern);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("2 bends, B1 the first of them, have the K-factor 0.6"));
  EXPECT_EQ(found[0].at.size(), 2u);
  EXPECT_THAT(found[1].message, HasSubstr("bend B3 has the K-factor 0.7"));
}

// ---- openings and bends

TEST(OpeningToBend, IsMeasuredFromTheTangentLine) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, circular_opening({tangent + 4 + 3, 20}, 3));
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
  pattern.openings.clear();
  open(pattern, circular_opening({tangent + 4 + 3 - kJustShort, 20}, 3));
  const Finding found = only(check(pattern), "opening_to_bend");
  EXPECT_THAT(
      found.message,
      HasSubstr("is 3.99 mm from the tangent line of bend B1, at least 4 mm (2 T) is needed"));
  EXPECT_THAT(found.message, HasSubstr("the opening Ø 6 mm at ("));
  EXPECT_NEAR((found.at.at(0) - Vec2(tangent + 3.99, 20)).norm(), 0.0, 1e-6);
}

TEST(OpeningToBend, HoldsForEveryShape) {
  const double tangent = 0.5 * test::zone_width();
  const double s = std::sqrt(0.5);
  const std::vector<std::pair<Loop, double>> shapes = {
      {rectangular_opening({0, 0}, 8, 6), 4.0},
      {reversed(polygon({{-5, 0}, {0, -5}, {5, 0}, {0, 5}})), 5.0},
      {test::obround_opening({0, 0}, 10, 3, Angle::degrees(45)), 5 * s + 3}};
  for (const auto& [shape, reach] : shapes) {
    for (const double distance : {4.0, 3.5}) {
      FlatPattern pattern = flat_l(50, 50);
      open(pattern, shifted(shape, Vec2(tangent + distance + reach, 20)));
      const auto found = check(pattern);
      if (distance < 4.0) {
        EXPECT_THAT(only(found, "opening_to_bend").message, HasSubstr("is 3.5 mm from"));
      } else {
        EXPECT_TRUE(found.empty()) << text_of(found);
      }
    }
  }
}

TEST(OpeningToBend, DoesNotCountAcrossASlit) {
  // The opening is 2 mm from the tangent line, but a slit 0.5 wide runs between them.
  const double tangent = 0.5 * test::zone_width();
  const double x = tangent + 0.7;
  FlatPattern pattern = flat_plate(polygon(
      {{-50, 0}, {x, 0}, {x, 30}, {x + 0.5, 30}, {x + 0.5, 0}, {60, 0}, {60, 40}, {-50, 40}}));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  open(pattern, rectangular_opening({tangent + 5.5 + 5, 12}, 10, 4));
  Rules rules;
  rules.opening_to_bend_t = 3.0;
  rules.flange_height_t = 0.0;
  EXPECT_TRUE(of_code(check(pattern, rules), "opening_to_bend").empty())
      << text_of(check(pattern, rules));
  pattern.outer = flat_plate(shifted(rectangle(110, 40), Vec2(-50, 0))).outer;
  EXPECT_EQ(of_code(check(pattern, rules), "opening_to_bend").size(), 1u);
}

/// A sheet of one bend face, so that openings can say what they were cut from.
Sheet sheet_with_bend_face() {
  Sheet sheet;
  sheet.faces.resize(1);
  sheet.faces.front().part_of = BendId{0};
  sheet.bends.resize(1);
  return sheet;
}

TEST(OpeningInBend, IsToldOnceForAHoleWithinTheZone) {
  FlatPattern pattern = flat_l(50, 40, {90, 8.0});
  open(pattern, circular_opening({0.5, 20}, 3));
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  const double gap = std::sqrt(9 - 0.25);
  pattern.bends[0].lines = {{Vec2(0, 0), Vec2(0, 20 - gap)}, {Vec2(0, 20 + gap), Vec2(0, 40)}};
  const auto found = check_rules(sheet_with_bend_face(), pattern, {});
  EXPECT_EQ(only(found, "opening_in_bend").message,
            "the opening Ø 6 mm at (0.5, 20) reaches into bend B1, where it is pulled out of "
            "shape; move it away or cut "
            "it through the whole bend");
}

TEST(OpeningInBend, IsToldForAHoleBesideTheBendLine) {
  // Within the zone, but without touching any line: only its origin tells.
  FlatPattern pattern = flat_l(50, 40, {90, 12.0});
  open(pattern, circular_opening({5, 20}, 2));
  EXPECT_TRUE(of_code(check(pattern), "opening_in_bend").empty());
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  only(check_rules(sheet_with_bend_face(), pattern, {}), "opening_in_bend");
}

TEST(OpeningInBend, IsToldForAHoleOverOneTangentLine) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, rectangular_opening({tangent + 2, 20}, 6, 8));
  pattern.bends[0].tangent_lines = {{Vec2(-tangent, 0), Vec2(-tangent, 40)},
                                    {Vec2(tangent, 0), Vec2(tangent, 16)},
                                    {Vec2(tangent, 24), Vec2(tangent, 40)}};
  const Finding found = only(check(pattern), "opening_in_bend");
  EXPECT_THAT(found.message, HasSubstr("the opening 8 × 6 mm at"));
}

TEST(OpeningInBend, IsAnInformationWhenCutThroughTheWholeBend) {
  const double tangent = 0.5 * test::zone_width();
  FlatPattern pattern = flat_l(50, 40);
  open(pattern, rectangular_opening({0, 20}, 2 * tangent + 6, 8));
  FlatBend& bend = pattern.bends[0];
  bend.lines.clear();
  bend.tangent_lines.clear();
  for (const auto& [from, to] : {std::pair{0.0, 16.0}, std::pair{24.0, 40.0}}) {
    bend.lines.push_back({Vec2(0, from), Vec2(0, to)});
    bend.tangent_lines.push_back({Vec2(-tangent, from), Vec2(-tangent, to)});
    bend.tangent_lines.push_back({Vec2(tangent, from), Vec2(tangent, to)});
  }
  const auto found = check(pattern);
  ASSERT_EQ(found.size(), 1u) << text_of(found);
  EXPECT_EQ(found[0].code, "opening_in_bend");
  EXPECT_EQ(found[0].severity, Severity::info);
  EXPECT_THAT(found[0].message, HasSubstr("is cut through bend B1"));
}

TEST(OpeningInBend, IsNoMatterInRolledSheet) {
  FlatPattern pattern = flat_l(50, 40, {90, 60.0});
  open(pattern, circular_opening({0, 20}, 5));
  pattern.openings[0].origins[0] = {Origin{{FaceId{0}, 1, 0}, false, pattern.openings[0].loop[0]}};
  EXPECT_TRUE(check_rules(sheet_with_bend_face(), pattern, {}).empty());
}

TEST(OpeningInBend, AgreesWithFlattenedSheets) {
  for (const auto& [sheet, severity] : {std::pair{test::hole_in_bend(3.0, 0.44), Severity::warning},
                                        std::pair{test::slot_across_bend(), Severity::info},
                                        std::pair{test::slot_into_bend(), Severity::warning}}) {
    const auto pattern = flatten(sheet);
    ASSERT_TRUE(pattern.has_value());
    const auto found = check_rules(sheet, *pattern, {});
    ASSERT_EQ(found.size(), 1u) << text_of(found);
    EXPECT_EQ(found[0].code, "opening_in_bend") << found[0].message;
    EXPECT_EQ(found[0].severity, severity) << found[0].message;
  }
}

// ---- openings and the edge, and each other

TEST(OpeningToEdge, IsAtLeastTwiceTheThickness) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({7, 30}, 3));
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
  pattern.openings.clear();
  open(pattern, circular_opening({7 - kJustShort, 30}, 3));
  const Finding found = only(check(pattern), "opening_to_edge");
  EXPECT_EQ(found.message,
            "the opening Ø 6 mm at (6.99, 30) is 3.99 mm from the outer edge, at least 4 mm (2 T) "
            "is needed");
  EXPECT_NEAR((found.at.at(0) - Vec2(3.99, 30)).norm(), 0.0, 1e-6);
}

TEST(OpeningToEdge, HoldsTowardsCurvedEdges) {
  const Loop disc{Arc{Vec2(0, 0), 40, 0, 2 * std::numbers::pi}};
  const Loop half{Arc{Vec2(0, 0), 40, 0, std::numbers::pi}, Segment{Vec2(-40, 0), Vec2(40, 0)}};
  for (const Loop& outline : {disc, half}) {
    FlatPattern pattern = flat_plate(outline);
    // A corner of the square is nearest to the arc.
    const double corner = 40 - 3.5;
    const Vec2 out = Vec2(1, 1).normalized();
    open(pattern, rectangular_opening(corner * out - Vec2(4, 4), 8, 8));
    EXPECT_THAT(only(check(pattern), "opening_to_edge").message,
                HasSubstr("is 3.5 mm from the outer edge"));
  }
}

TEST(OpeningToOpening, IsAtLeastFiveTimesTheThickness) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({30, 30}, 5));
  open(pattern, rectangular_opening({50, 30}, 10, 12));
  EXPECT_TRUE(check(pattern).empty()) << text_of(check(pattern));
  pattern.openings.pop_back();
  open(pattern, rectangular_opening({50 - kJustShort, 30}, 10, 12));
  const Finding found = only(check(pattern), "opening_to_opening");
  EXPECT_EQ(found.message,
            "the opening Ø 10 mm at (30, 30) is 9.99 mm from the opening 12 × 10 mm at (49.99, "
            "30), at least 10 mm (5 T) "
            "is needed");
  ASSERT_EQ(found.at.size(), 2u);
  EXPECT_NEAR((found.at[0] - Vec2(35, 30)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((found.at[1] - Vec2(44.99, 30)).norm(), 0.0, 1e-6);
}

TEST(OpeningToOpening, IsToldForEachNearestNeighbourOnce) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  for (const double x : {20.0, 35.0, 48.0, 80.0})
    open(pattern, circular_opening({x, 30}, 4));
  // 35–48 are each other's nearest, 20 is nearest to 35, 80 is alone.
  EXPECT_THAT(messages(check(pattern)), ElementsAre(HasSubstr("is 7 mm"), HasSubstr("is 5 mm")));
}

// ---- size of openings

TEST(SmallestOpening, IsTheDiameterOfACircle) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({30, 30}, 1.0));
  EXPECT_TRUE(check(pattern).empty());
  open(pattern, circular_opening({60, 30}, 0.95));
  EXPECT_EQ(only(check(pattern), "smallest_opening").message,
            "the opening Ø 1.9 mm at (60, 30) is 1.9 mm wide, at least 2 mm (T) is needed");
}

/// The width that the rule sees, from its message; 0 when it is satisfied.
double width_seen(const Loop& opening) {
  FlatPattern pattern = flat_plate(shifted(rectangle(400, 400), Vec2(-200, -200)));
  open(pattern, opening);
  Rules rules;
  rules.smallest_opening_t = 10.0;
  const auto found = of_code(check(pattern, rules), "smallest_opening");
  if (found.empty()) return 0.0;
  const std::string& message = found[0].message;
  return std::stod(message.substr(message.find(") is ") + 5));
}

TEST(SmallestOpening, IsTheLargestCircleThatFits) {
  const Isometry2 turn(Eigen::Rotation2Dd(0.4));
  EXPECT_NEAR(width_seen(transformed(rectangular_opening({3, 4}, 60, 7.5), turn)), 7.5, 6e-4);
  EXPECT_NEAR(width_seen(test::obround_opening({0, 0}, 30, 4, Angle::degrees(20))), 8.0, 6e-4);
  // A triangle 3-4-5 times 5 has an inscribed radius of 5.
  EXPECT_NEAR(width_seen(reversed(polygon({{0, 0}, {15, 0}, {0, 20}}))), 10.0, 6e-4);
  // A keyhole: the disc, not the slot.
  Loop keyhole{Arc{Vec2(0, 0), 9, 0.2, 2 * std::numbers::pi - 0.4}};
  const Vec2 upper = 9 * Vec2(std::cos(0.2), std::sin(0.2));
  const Vec2 lower(upper.x(), -upper.y());
  keyhole.push_back(Segment{lower, Vec2(40, lower.y())});
  keyhole.push_back(Segment{Vec2(40, lower.y()), Vec2(40, upper.y())});
  keyhole.push_back(Segment{Vec2(40, upper.y()), upper});
  EXPECT_NEAR(width_seen(reversed(keyhole)), 18.0, 6e-4);
  // An angle with arms 5 wide: the circle in its corner touches the outer sides and the inner
  // corner.
  const double corner = 2 * 5 * (2 - std::numbers::sqrt2);
  EXPECT_NEAR(width_seen(reversed(polygon({{0, 0}, {30, 0}, {30, 5}, {5, 5}, {5, 30}, {0, 30}}))),
              corner, 6e-4);
  EXPECT_EQ(width_seen(rectangular_opening({0, 0}, 20.0, 80)), 0.0);
}

TEST(SmallestOpening, DoesNotMindLinesCut) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, polygon({{20, 20}, {20, 40}}));
  open(pattern, polygon({{50, 10}, {50, 30}, {70, 30}, {70, 10}, {70, 30}, {50, 30}}));
  EXPECT_TRUE(of_code(check(pattern), "smallest_opening").empty()) << text_of(check(pattern));
}

// ---- many of a kind

TEST(CheckRules, TellsManyOfAKindInOneSentence) {
  FlatPattern pattern = flat_plate(rectangle(500, 60));
  for (int i = 0; i < 10; ++i)
    open(pattern, circular_opening({20.0 + 20 * i, 6}, 3));
  EXPECT_EQ(check(pattern).size(), 10u);
  for (int i = 10; i < 23; ++i)
    open(pattern, circular_opening({20.0 + 20 * i, i == 15 ? 5.5 : 6.0}, 3));
  open(pattern, circular_opening({480, 7.5}, 4));
  const auto found = check(pattern);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(
      found[0].message,
      HasSubstr("23 openings Ø 6 mm are too near to the outer edge; the worst: the opening Ø 6 mm "
                "at (320, 5.5) is 2.5 mm from"));
  EXPECT_EQ(found[0].at.size(), 23u);
  EXPECT_THAT(found[1].message, HasSubstr("Ø 8 mm"));
}

TEST(CheckRules, TellsAPerforationInOneSentence) {
  FlatPattern pattern = flat_plate(rectangle(160, 160));
  for (int i = 0; i < 15; ++i)
    for (int k = 0; k < 15; ++k)
      open(pattern, circular_opening({10.0 + 10 * i, 10.0 + 10 * k}, 3));
  const Finding found = only(check(pattern), "opening_to_opening");
  EXPECT_THAT(found.message, HasSubstr("places between openings Ø 6 mm and Ø 6 mm are too narrow"));
}

// ---- wherever it lies

/// A part that breaks most rules.
FlatPattern bad_part() {
  FlatPattern pattern = tab(15.0, 1.5, 1.0);
  const double w = test::zone_width();
  open(pattern, rectangular_opening({0, -5}, 6, 4));
  open(pattern, circular_opening({0, w + 10}, 2));
  open(pattern, circular_opening({-25, -20}, 2));
  open(pattern, test::obround_opening({20, -25}, 6, 0.8, Angle::degrees(30)));
  test::add_bend(pattern, {Vec2(-10, w + 18 - 0.5 * w), Vec2(10, w + 18 - 0.5 * w)},
                 {90, 1.0, 0.1});
  return pattern;
}

TEST(CheckRules, FindsTheSameInMovedAndMirroredPatterns) {
  const auto summary = [](const std::vector<Finding>& findings) {
    std::multiset<std::string> result;
    for (const Finding& f : findings) {
      std::string message = f.message;
      // Coordinates move, everything else stays.
      for (size_t at = message.find(" at ("); at != std::string::npos; at = message.find(" at ("))
        message.erase(at, message.find(')', at) - at + 1);
      result.insert(f.code + message);
    }
    return result;
  };
  const auto expected = summary(check(bad_part()));
  EXPECT_GE(expected.size(), 8u) << text_of(check(bad_part()));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    Isometry2 motion = Isometry2::Identity();
    motion.rotate(4.0 * any(random)).pretranslate(Vec2(300 * any(random), 300 * any(random)));
    if (i % 2 == 1) motion.linear().col(0) *= -1.0;
    EXPECT_EQ(summary(check(test::moved(bad_part(), motion))), expected) << i;
  }
}

}  // namespace
}  // namespace planish
