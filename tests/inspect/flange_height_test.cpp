#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace planish::test {
namespace {

using testing::HasSubstr;

TEST(FlangeHeight, IsMeasuredFromTheOutsideOfTheBend) {
  const Finding found = only(findings_of(flat_l(50, 1 - kJustShort)), "flange_height");
  EXPECT_EQ(found.message,
            "the flange at bend B1 is 4.99 mm high from the outside of the bend; at least 5 mm "
            "(1.5 T + R) is needed");
  ASSERT_EQ(found.at.size(), 1u);
  EXPECT_NEAR(found.at[0].x(), 0.5 * test::zone_width(), 1e-9);
}

TEST(FlangeHeight, IsEnoughAtTheLimit) {
  EXPECT_TRUE(findings_of(flat_l(1, 1)).empty()) << text_of(findings_of(flat_l(1, 1)));
}

TEST(FlangeHeight, NeedsTheSameFlatLengthAtEveryAngle) {
  for (const double degrees : {20.0, 45.0, 120.0, 160.0}) {
    EXPECT_TRUE(findings_of(flat_l(50, 1, {degrees})).empty()) << degrees;
    only(findings_of(flat_l(50, 1 - kJustShort, {degrees})), "flange_height");
  }
}

TEST(FlangeHeight, FollowsTheThresholds) {
  Rules rules = strict_rules();
  rules.flange_height_t = 4.0;
  rules.flange_height_r = 0.0;
  EXPECT_TRUE(findings_of(flat_l(50, 4), rules).empty());  // 8 mm from the outside
  EXPECT_THAT(only(findings_of(flat_l(50, 4 - kJustShort), rules), "flange_height").message,
              HasSubstr("8 mm (4 T)"));
  rules.flange_height_t = 0.0;
  EXPECT_TRUE(findings_of(flat_l(50, 0.01), rules).empty());
}

TEST(FlangeHeight, LetsChamferedAndRoundedEndsPass) {
  const double x = 0.5 * test::zone_width();
  // 6 mm flat with chamfers down to 0.5 mm at both ends.
  FlatPattern pattern = flat_plate(
      polygon({{-50, 0}, {x + 0.5, 0}, {x + 5, 4.5}, {x + 5, 35.5}, {x + 0.5, 40}, {-50, 40}}));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
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
  EXPECT_THAT(only(findings_of(pattern), "flange_height").message, HasSubstr("4.7 mm high"));
}

TEST(FlangeHeight, IsMeasuredBesideAWindowThroughTheBend) {
  FlatPattern pattern = flat_l(50, 1 - kJustShort);
  open(pattern, rectangular_opening({0, 20}, test::zone_width() + 0.5, 10));
  FlatBend& bend = pattern.bends.front();
  for (auto* lines : {&bend.lines, &bend.tangent_lines})
    for (const std::vector<Segment> before = std::exchange(*lines, {});
         const Segment& whole : before)
      for (const auto& [from, to] : {std::pair{0.0, 15.0}, std::pair{25.0, 40.0}})
        lines->push_back({{whole.a.x(), from}, {whole.a.x(), to}});
  const auto found = of_code(findings_of(pattern), "flange_height");
  ASSERT_EQ(found.size(), 1u) << text_of(findings_of(pattern));
  EXPECT_NEAR(number_of(found[0], "measured"), 4.99, 1e-9);
}

TEST(FlangeHeight, NamesTheFlangeOfTheSheet) {
  const Turn turn{Angle::degrees(90), 2.0, BendDirection::up};
  const auto flange_of = [](const Sheet& sheet) {
    std::vector<Place> flanges;
    for (const Place& place :
         only(findings_of(flatten(sheet).value(), strict_rules(), sheet), "flange_height").about)
      if (place.kind == PlaceKind::flange) flanges.push_back(place);
    return flanges;
  };
  EXPECT_EQ(flange_of(strip({Straight{50}, turn, Straight{0.5}}, 40.0, kT)),
            std::vector{place::flange(2)});
  EXPECT_EQ(flange_of(strip({Straight{0.5}, turn, Straight{50}}, 40.0, kT)),
            std::vector{place::flange(1)});
  EXPECT_EQ(flange_of(strip({Straight{50}, turn, Straight{0.5}, turn, Straight{40}}, 40.0, kT)),
            std::vector{place::flange(2)});
}

TEST(FlangeHeight, IsToldOnceForTheWebBetweenTwoBends) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(shifted(rectangle(60 + 2 * w, 40), Vec2(-30 - 0.5 * w, 0)));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  test::add_bend(pattern, {Vec2(w + 0.6, 0), Vec2(w + 0.6, 40)});
  EXPECT_EQ(only(findings_of(pattern), "flange_height").message,
            "the flange between bends B1 and B2 is 4.6 mm high from the outside of the bend; at "
            "least 5 mm (1.5 T + R) is "
            "needed");
}

TEST(FlangeHeight, LetsBendsGoOnInOneAnother) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(shifted(rectangle(60 + 2 * w, 40), Vec2(-30 - 0.5 * w, 0)));
  test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)});
  test::add_bend(pattern, {Vec2(w, 0), Vec2(w, 40)});
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
}

TEST(FlangeHeight, LetsRolledBendsEndAtTheEdge) {
  EXPECT_TRUE(findings_of(flat_l(50, 0, {90, 40})).empty())
      << text_of(findings_of(flat_l(50, 0, {90, 40})));
  EXPECT_THAT(only(findings_of(flat_l(50, 0, {90, 4})), "flange_height").message,
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
    const auto found = findings_of(pattern);
    if (flat < 1.0) {
      EXPECT_THAT(only(found, "flange_height").message, HasSubstr("4.9 mm high"));
    } else {
      EXPECT_TRUE(found.empty()) << text_of(found);
    }
  }
}

}  // namespace
}  // namespace planish::test
