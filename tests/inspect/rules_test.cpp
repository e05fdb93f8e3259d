#include "rule_findings.hpp"
#include "support/sheets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
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
  EXPECT_THAT(
      found.message,
      HasSubstr("24 openings are too close to the outer edge; the worst: the opening Ø 6 mm "
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
  EXPECT_THAT(found.message, HasSubstr("the rule of thumb is 0.8 mm"));
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

// ---- every limit

/// A pattern of 2 mm sheet with two places of a rule, one short of the limit by `first`, the other
/// by `second` (mm; negative: more than enough).
struct LimitCase {
  const char* code;
  std::function<FlatPattern(double first, double second)> pattern;
  double wanted;
  /// Below this share of what is wanted a place is a warning; none: it is the same everywhere.
  std::optional<double> warning_below = std::nullopt;
};

FlatPattern two_bends(const BendShape& first, const BendShape& second) {
  FlatPattern pattern = flat_plate(shifted(rectangle(400, 40), Vec2(-200, 0)));
  test::add_bend(pattern, {Vec2(-80, 0), Vec2(-80, 40)}, first);
  test::add_bend(pattern, {Vec2(80, 0), Vec2(80, 40)}, second);
  return pattern;
}

FlatPattern with_circles(const std::vector<std::pair<Vec2, double>>& circles) {
  FlatPattern pattern = flat_plate(rectangle(400, 100));
  for (const auto& [center, radius] : circles)
    open(pattern, circular_opening(center, radius));
  return pattern;
}

/// Hems of R 1 with returns of this flat length at both ends of a plate.
FlatPattern two_hems(double first, double second) {
  const double w = test::zone_width({180, 1.0});
  FlatPattern pattern = flat_plate(
      shifted(rectangle(first + second + 2 * w + 100, 40), Vec2(-first - w, 0)));
  test::add_bend(pattern, {Vec2(-0.5 * w, 0), Vec2(-0.5 * w, 40)}, {180, 1.0});
  test::add_bend(pattern, {Vec2(100 + 0.5 * w, 0), Vec2(100 + 0.5 * w, 40)}, {180, 1.0});
  return pattern;
}

/// A tab like that of `tab`, its reliefs of different width and depth.
FlatPattern uneven_tab(const Vec2& left, const Vec2& right) {
  const double w = test::zone_width();
  FlatPattern pattern = flat_plate(polygon({{-30, -40},
                                            {30, -40},
                                            {30, 15},
                                            {10 + right.x(), 15},
                                            {10 + right.x(), -right.y()},
                                            {10, -right.y()},
                                            {10, w + 20},
                                            {-10, w + 20},
                                            {-10, -left.y()},
                                            {-10 - left.x(), -left.y()},
                                            {-10 - left.x(), 15},
                                            {-30, 15}}));
  test::add_bend(pattern, {Vec2(-10, 0.5 * w), Vec2(10, 0.5 * w)});
  return pattern;
}

Rules all_limits() {
  Rules rules = strict_rules();
  rules.relief_depth_t = 1.5;  // 5 mm from the outside of the bend: 1 mm beyond the tangent line
  rules.strict = false;
  return rules;
}

std::vector<LimitCase> limit_cases() {
  const double tangent = 0.5 * test::zone_width();
  return {
      {"flange_height", [](double a, double b) { return flat_l(1 - a, 1 - b); }, 5.0},
      {"bend_relief",
       [](double a, double b) {
         return uneven_tab({2 - a, 5}, {2 - b, 5});
       },
       2.0},
      {"bend_relief",
       [](double a, double b) {
         return uneven_tab({5, 1 - a}, {5, 1 - b});
       },
       5.0, 0.5},
      {"inside_radius",
       [](double a, double b) {
         return two_bends({90, 2 - a}, {90, 2 - b});
       },
       2.0},
      {"hem",
       [](double a, double b) {
         return two_bends({180, 1 - a / 2}, {180, 1 - b / 2});
       },
       2.0, 0.5},
      {"hem", [](double a, double b) { return two_hems(9 - a, 9 - b); }, 12.0, 0.5},
      {"opening_to_bend",
       [=](double a, double b) {
         FlatPattern pattern = flat_l(60, 60);
         open(pattern, circular_opening({-(tangent + 7 - a), 20}, 3));
         open(pattern, circular_opening({tangent + 7 - b, 20}, 3));
         return pattern;
       },
       4.0, 0.25},
      {"opening_to_edge",
       [](double a, double b) {
         return with_circles({{{7 - a, 50}, 3}, {{200, 93 + b}, 3}});
       },
       4.0, 0.5},
      {"opening_to_opening",
       [](double a, double b) {
         return with_circles(
             {{{50, 50}, 4}, {{68 - a, 50}, 4}, {{250, 40}, 4}, {{250, 58 - b}, 4}});
       },
       10.0, 0.5},
      {"smallest_opening",
       [](double a, double b) {
         return with_circles({{{50, 50}, 1 - a / 2}, {{90, 50}, 1 - b / 2}});
       },
       2.0},
  };
}

TEST(EveryLimit, IsKeptWithinAThousandthOfAMillimetreAndNoMore) {
  for (const LimitCase& one : limit_cases()) {
    const auto found = [&](double first, double second) {
      return of_code(check_rules({}, one.pattern(first, second), all_limits()), one.code);
    };
    EXPECT_TRUE(found(-0.5, -0.5).empty()) << one.code;
    EXPECT_TRUE(found(0.0009, 0.0009).empty()) << one.code << text_of(found(0.0009, 0.0009));
    for (const auto& short_ones : {std::pair{0.0012, -0.5}, std::pair{-0.5, 0.0012}}) {
      const auto finding = found(short_ones.first, short_ones.second);
      ASSERT_EQ(finding.size(), 1u) << one.code;
      EXPECT_EQ(finding[0].places.size(), 1u) << one.code;
      EXPECT_NEAR(number_of(finding[0], "measured"), one.wanted - 0.0012, 1e-6) << one.code;
      EXPECT_NEAR(number_of(finding[0], "wanted"), one.wanted, 1e-9) << one.code;
    }
  }
}

TEST(EveryLimit, IsToldByTheWorstOfItsPlaces) {
  for (const LimitCase& one : limit_cases())
    for (const auto& [first, second] : {std::pair{0.05, 0.2}, std::pair{0.2, 0.05}}) {
      const auto found = of_code(check_rules({}, one.pattern(first, second), all_limits()),
                                 one.code);
      ASSERT_EQ(found.size(), 1u) << one.code;
      ASSERT_EQ(found[0].places.size(), 2u) << one.code;
      EXPECT_NEAR(number_of(found[0], "measured"), one.wanted - 0.2, 1e-6) << one.code;
      EXPECT_NEAR(number_of(places_of(found).at(1), "measured"), one.wanted - 0.05, 1e-6)
          << one.code;
    }
}

TEST(EveryLimit, IsAWarningWhereAShopWouldCall) {
  for (const LimitCase& one : limit_cases()) {
    if (!one.warning_below) continue;
    const double few = (1.0 - *one.warning_below) * one.wanted;
    const auto severity = [&](double short_by) {
      return of_code(check_rules({}, one.pattern(short_by, -0.5), all_limits()), one.code)
          .at(0)
          .severity;
    };
    // Depth and return are limited by what is flat: less than that cannot be drawn.
    const double most = std::string_view(one.code) == "bend_relief" ? 0.9 : few + 0.02;
    EXPECT_EQ(severity(std::min(few, most) - 0.02), Severity::info) << one.code;
    if (most > few) {
      EXPECT_EQ(severity(most), Severity::warning) << one.code;
    }
  }
}

}  // namespace
}  // namespace planish::test
