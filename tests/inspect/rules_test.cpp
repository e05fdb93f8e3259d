#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
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
  EXPECT_THAT(names, ElementsAre("flange_height_t", "flange_height_r", "opening_to_bend_t",
                                 "opening_to_edge_t", "opening_to_opening_t",
                                 "opening_to_opening_mm", "smallest_opening_t", "inside_radius_t",
                                 "relief_width_t", "relief_depth_r", "relief_depth_t",
                                 "hem_diameter_t", "hem_return_t", "k_low", "k_high"));
  EXPECT_THAT(values, ElementsAre(1.5, 1, 2, 1, 1, 0.8, 0.5, 1, 0.5, 1, 1, 1, 6, 0.2, 0.5))
      << "defaults of shop-floor.md#rules-of-manufacture";
  // Every threshold is a double, `strict` and `enabled` the only others: none can be missing.
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
  Rules rules = strict_rules();
  rules.enabled = false;
  EXPECT_TRUE(findings_of(pattern, rules).empty());
}

TEST(CheckRules, TellsARuleInOneFindingWithAllItsPlaces) {
  FlatPattern pattern = flat_plate(rectangle(500, 60));
  for (int i = 0; i < 23; ++i)
    open(pattern, circular_opening({20.0 + 20 * i, i == 15 ? 5.5 : 6.0}, 3));
  open(pattern, circular_opening({480, 7.5}, 4));
  const Finding found = only(check_rules({}, pattern, strict_rules()), "opening_to_edge");
  EXPECT_THAT(found.message,
              HasSubstr("24 openings are too near to the outer edge; the worst: the opening Ø 6 mm "
                        "at (320, 5.5) is 2.5 mm from"));
  ASSERT_EQ(found.places.size(), 24u);
  EXPECT_EQ(found.at.size(), 24u);
  EXPECT_THAT(found.places.front().message, HasSubstr("(320, 5.5)"));
  EXPECT_THAT(found.places.back().message, HasSubstr("Ø 8 mm"));
}

TEST(CheckRules, TellsAPerforationInOneSentence) {
  FlatPattern pattern = flat_plate(rectangle(160, 160));
  for (int i = 0; i < 15; ++i)
    for (int k = 0; k < 15; ++k)
      open(pattern, circular_opening({10.0 + 10 * i, 10.0 + 10 * k}, 3));
  const Finding found = only(check_rules({}, pattern, strict_rules()), "opening_to_opening");
  EXPECT_THAT(found.message, HasSubstr("gaps between openings are too narrow"));
}

/// The severity of an opening of radius 5 in 2 mm sheet at a distance from the edge; none: fine.
std::optional<Severity> beside_edge(double distance, const Rules& rules) {
  FlatPattern pattern = flat_plate(rectangle(100, 60));
  open(pattern, circular_opening({50, 5 + distance}, 5));
  const auto found = check_rules({}, pattern, rules);
  return found.empty() ? std::nullopt : std::optional(found.front().severity);
}

TEST(CheckRules, WarnsBelowHalfTheLimitOfTheProcess) {
  const Rules laser = rules_for(Process::laser), punch = rules_for(Process::punch);
  EXPECT_EQ(beside_edge(2.0, laser), std::nullopt) << "T";
  EXPECT_EQ(beside_edge(1.9, laser), Severity::info);
  EXPECT_EQ(beside_edge(0.9, laser), Severity::warning);
  EXPECT_EQ(beside_edge(4.0, punch), std::nullopt) << "2 T";
  EXPECT_EQ(beside_edge(3.9, punch), Severity::info);
  EXPECT_EQ(beside_edge(1.9, punch), Severity::warning);
  Rules own = laser;
  own.strict = true;
  EXPECT_EQ(beside_edge(1.9, own), Severity::warning);
}

TEST(CheckRules, AsksForEightTenthsBetweenOpeningsOfThinSheet) {
  const auto apart = [](double gap, const Rules& rules) {
    FlatPattern pattern = flat_plate(rectangle(100, 60));
    pattern.thickness = 0.5;
    open(pattern, circular_opening({40, 30}, 5));
    open(pattern, circular_opening({50 + gap, 30}, 5));
    return check_rules({}, pattern, rules);
  };
  EXPECT_TRUE(apart(0.8, rules_for(Process::laser)).empty());
  const Finding found = apart(0.79, rules_for(Process::laser)).at(0);
  EXPECT_EQ(found.severity, Severity::info);
  EXPECT_THAT(found.message, HasSubstr("0.79 mm from"));
  EXPECT_THAT(found.message, HasSubstr("at least 0.8 mm is needed"));
  EXPECT_EQ(apart(0.39, rules_for(Process::laser)).at(0).severity, Severity::warning);
  EXPECT_THAT(apart(0.9, rules_for(Process::punch)).at(0).message, HasSubstr("1 mm (2 T)"));
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
  Rules rules = strict_rules();
  rules.flange_height_t = std::nan("");
  EXPECT_DEATH((void)check_rules(u_channel(), pattern, rules), "isfinite");
  rules.flange_height_t = -1.0;
  EXPECT_DEATH((void)check_rules(u_channel(), pattern, rules), "isfinite");
}

}  // namespace
}  // namespace planish::test
