#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace planish::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
      << "defaults of shop-floor.md#rules-of-manufacture";
  // Every threshold is a double, `enabled` the only other member: none can be missing.
  EXPECT_EQ(sizeof(Rules), rule_fields().size() * sizeof(double) + sizeof(double));
}

TEST(CheckRules, FindsNothingInGoodParts) {
  FlatPattern pattern = flat_l(50, 30);
  open(pattern, circular_opening({-30, 20}, 4));
  open(pattern, rectangular_opening({20, 20}, 10, 12));
  EXPECT_TRUE(findings_of(pattern).empty()) << text_of(findings_of(pattern));
  EXPECT_TRUE(findings_of(flat_plate(rectangle(10, 10))).empty());
}

TEST(CheckRules, FindsNothingInNothing) { EXPECT_TRUE(findings_of({}).empty()); }

TEST(CheckRules, FindsNothingWhenSwitchedOff) {
  FlatPattern pattern = flat_l(50, 0.1, {90, 0.5, 0.9});
  open(pattern, circular_opening({-49, 20}, 0.5));
  EXPECT_GE(findings_of(pattern).size(), 4u);
  Rules rules;
  rules.enabled = false;
  EXPECT_TRUE(findings_of(pattern, rules).empty());
}

TEST(CheckRules, TellsManyOfAKindInOneSentence) {
  FlatPattern pattern = flat_plate(rectangle(500, 60));
  for (int i = 0; i < 10; ++i)
    open(pattern, circular_opening({20.0 + 20 * i, 6}, 3));
  EXPECT_EQ(findings_of(pattern).size(), 10u);
  for (int i = 10; i < 23; ++i)
    open(pattern, circular_opening({20.0 + 20 * i, i == 15 ? 5.5 : 6.0}, 3));
  open(pattern, circular_opening({480, 7.5}, 4));
  const auto found = findings_of(pattern);
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
  const Finding found = only(findings_of(pattern), "opening_to_opening");
  EXPECT_THAT(found.message, HasSubstr("gaps between openings Ø 6 mm and Ø 6 mm are too narrow"));
}

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
  const auto expected = summary(findings_of(bad_part()));
  EXPECT_GE(expected.size(), 8u) << text_of(findings_of(bad_part()));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    Isometry2 motion = Isometry2::Identity();
    motion.rotate(4.0 * any(random)).pretranslate(Vec2(300 * any(random), 300 * any(random)));
    if (i % 2 == 1) motion.linear().col(0) *= -1.0;
    EXPECT_EQ(summary(findings_of(test::moved(bad_part(), motion))), expected) << i;
  }
}

TEST(CheckRules, StopsAtThresholdsThatAreNotNumbers) {
  const FlatPattern pattern = flatten(u_channel()).value();
  Rules rules;
  rules.flange_height_t = std::nan("");
  EXPECT_DEATH((void)check_rules(u_channel(), pattern, rules), "isfinite");
  rules.flange_height_t = -1.0;
  EXPECT_DEATH((void)check_rules(u_channel(), pattern, rules), "isfinite");
}

}  // namespace
}  // namespace planish::test
