#include "rule_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

using testing::HasSubstr;

TEST(InsideRadius, IsAtLeastTheThickness) {
  EXPECT_TRUE(findings_of(flat_l(50, 30, {90, kT})).empty());
  EXPECT_EQ(only(findings_of(flat_l(50, 30, {90, 1.9})), "inside_radius").message,
            "the inside radius of bend B1 is 1.9 mm; at least 2 mm (T) is needed");
  Rules steel = strict_rules();
  steel.inside_radius_t = 0.5;
  EXPECT_TRUE(findings_of(flat_l(50, 30, {90, 1.0}), steel).empty());
}

TEST(InsideRadius, OfASharpBendIsZero) {
  FlatPattern pattern = flat_plate(shifted(rectangle(60, 40), Vec2(-30, 0)));
  FlatBend& bend = test::add_bend(pattern, {Vec2(0, 0), Vec2(0, 40)}, {90, 0.0, 0.3});
  bend.kind = BendKind::sharp;
  EXPECT_THAT(only(findings_of(pattern), "inside_radius").message, HasSubstr("is 0 mm"));
  // No allowance at all: both tangent lines are the bend line.
  bend.tangent_lines = {bend.lines.front(), bend.lines.front()};
  EXPECT_THAT(only(findings_of(pattern), "inside_radius").message, HasSubstr("is 0 mm"));
}

TEST(Hem, NeedsAnInsideDiameterOfTheThickness) {
  EXPECT_TRUE(findings_of(flat_l(50, 20, {180, 1.0})).empty())
      << text_of(findings_of(flat_l(50, 20, {180, 1.0})));
  EXPECT_EQ(only(findings_of(flat_l(50, 20, {180, 0.9})), "hem").message,
            "the hem at bend B1 is 1.8 mm wide inside; at least 2 mm (T) is needed");
}

TEST(Hem, NeedsAReturnOfSixTimesTheThickness) {
  // 12 mm from the outside of a bend of R 1: 9 mm flat.
  EXPECT_TRUE(findings_of(flat_l(50, 9, {180, 1.0})).empty())
      << text_of(findings_of(flat_l(50, 9, {180, 1.0})));
  EXPECT_EQ(only(findings_of(flat_l(50, 9 - kJustShort, {180, 1.0})), "hem").message,
            "the return of the hem at bend B1 is 11.99 mm long from the outside of the bend; at "
            "least 12 mm (6 T) is "
            "needed");
}

TEST(Hem, BeginsAt170Degrees) {
  EXPECT_TRUE(findings_of(flat_l(50, 3, {169.9})).empty());
  only(findings_of(flat_l(50, 3, {170.0})), "hem");
}

TEST(KFactor, IsDoubtedOutsideItsRange) {
  EXPECT_TRUE(findings_of(flat_l(50, 30, {90, 2, 0.2})).empty());
  EXPECT_TRUE(findings_of(flat_l(50, 30, {90, 2, 0.5})).empty());
  EXPECT_THAT(only(findings_of(flat_l(50, 30, {90, 2, 0.19})), "k_factor").message,
              HasSubstr("K-factor of 0.19 (test)"));
  EXPECT_EQ(only(findings_of(flat_l(50, 30, {90, 2, 0.6})), "k_factor").message,
            "bend B1 has a K-factor of 0.6 (test); measured ones lie between 0.2 and 0.5");
}

TEST(KFactor, IsDoubtedOnceForAllBendsThatHaveIt) {
  FlatPattern pattern = flat_l(50, 30, {90, 2, 0.6});
  test::add_bend(pattern, {Vec2(-20, 0), Vec2(-20, 40)}, {90, 2, 0.6});
  test::add_bend(pattern, {Vec2(-40, 0), Vec2(-40, 40)}, {90, 2, 0.7});
  const auto found = findings_of(pattern);
  ASSERT_EQ(found.size(), 2u) << text_of(found);
  EXPECT_THAT(found[0].message, HasSubstr("2 bends (bend B1 is the first) have a K-factor of 0.6"));
  ASSERT_EQ(found[0].about.size(), 2u);
  EXPECT_EQ(found[0].about[1].id, Place::Id("B2"));
  EXPECT_EQ(number_of(found[0], "measured"), 0.6);
  EXPECT_EQ(found[0].at.size(), 2u);
  EXPECT_THAT(found[1].message, HasSubstr("bend B3 has a K-factor of 0.7"));
}

}  // namespace
}  // namespace planish::test
