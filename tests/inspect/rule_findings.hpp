#pragma once

#include "flat_plates.hpp"

#include <planish/inspect/findings.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace planish::test {

// Everything here is of 2 mm sheet, so the limits of `strict_rules` are: flange height 1.5 T + R,
// opening to bend 4, to edge 4, to opening 10, smallest opening 2, inside radius 2, relief 2 wide.
inline constexpr double kT = 2.0;
inline constexpr double kJustShort = 0.01;

inline Rules strict_rules() {
  Rules rules;
  rules.opening_to_edge_t = 2.0;
  rules.opening_to_opening_t = 5.0;
  rules.opening_to_opening_mm = 0.0;
  rules.smallest_opening_t = 1.0;
  rules.relief_width_t = 1.0;
  rules.strict = true;
  return rules;
}

/// A finding for each place.
inline std::vector<Finding> places_of(const std::vector<Finding>& findings) {
  std::vector<Finding> all;
  for (const Finding& finding : findings)
    for (const FindingPlace& place : finding.places)
      all.push_back({finding.code,
                     place.severity,
                     place.message,
                     place.at,
                     {},
                     place.places,
                     place.numbers,
                     finding.remedies});
  return all;
}

inline std::vector<Finding> findings_of(const FlatPattern& pattern,
                                        const Rules& rules = strict_rules(),
                                        const Sheet& sheet = {}) {
  return places_of(check_rules(sheet, pattern, rules));
}

inline std::vector<std::string> messages(const std::vector<Finding>& findings) {
  std::vector<std::string> result;
  for (const Finding& f : findings)
    result.push_back(f.message);
  return result;
}

/// The only finding, which must have this code.
inline Finding only(const std::vector<Finding>& findings, const std::string& code) {
  EXPECT_EQ(findings.size(), 1u) << text_of(findings);
  if (findings.size() != 1) return {};
  EXPECT_EQ(findings[0].code, code) << findings[0].message;
  EXPECT_EQ(findings[0].severity, Severity::warning);
  return findings[0];
}

/// A number of a finding by its name; not a number if there is none.
inline double number_of(const Finding& finding, const std::string& name) {
  for (const NamedQuantity& number : finding.numbers)
    if (number.name == name) return number.quantity.value;
  return std::numeric_limits<double>::quiet_NaN();
}

/// A tab 20 wide on top of a base 60 wide and 40 high, bend along x. The base's edges beside the
/// tab are at `shoulder` above the tangent line; reliefs `width` wide reach `depth` below it.
inline FlatPattern tab(double shoulder, double width, double depth) {
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

}  // namespace planish::test
