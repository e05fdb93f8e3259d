#include "observation.hpp"

#include <planish/base/assert.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace planish::inspect_detail {
namespace {

std::string term_text(double factor, const char* name) {
  return factor == 1.0 ? name : fmt::format("{} {}", number_text(factor), name);
}

/// What the places of a rule have in common; follows their number.
const char* many_of(std::string_view code) {
  static const std::map<std::string_view, const char*> kMany{
      {"flange_height", "flanges are too low to be bent"},
      {"bend_relief", "ends of bends lack a relief, or have too small a one"},
      {"flush_bend", "ends of bends are flush with an edge"},
      {"inside_radius", "bends have too small an inside radius"},
      {"hem", "hems are too narrow inside or have too short a return"},
      {"k_factor", "K-factors lie outside the range of measured ones"},
      {"opening_to_bend", "openings are too near to bends"},
      {"opening_in_bend", "openings reach into bends"},
      {"opening_to_edge", "openings are too near to the outer edge"},
      {"opening_to_opening", "gaps between openings are too narrow"},
      {"smallest_opening", "openings are too small"}};
  const auto found = kMany.find(code);
  PLANISH_ASSERT(found != kMany.end());
  return found->second;
}

Finding finding_of(const char* code, std::vector<const Observation*> alike) {
  std::stable_sort(alike.begin(), alike.end(), [](const Observation* a, const Observation* b) {
    if (a->place.severity != b->place.severity) return a->place.severity > b->place.severity;
    return a->excess < b->excess;
  });
  const FindingPlace& worst = alike.front()->place;
  Finding result{code, worst.severity, worst.message, {}};
  if (alike.size() > 1)
    result.message = fmt::format("{} {}; the worst: {}", alike.size(), many_of(code),
                                 worst.message);
  for (const Observation* one : alike) {
    result.places.push_back(one->place);
    result.at.insert(result.at.end(), one->place.at.begin(), one->place.at.end());
  }
  return result;
}

}  // namespace

Severity severity_of(double measured, double limit, double share, const Rules& rules) {
  return rules.strict || measured < share * limit - kDrawn ? Severity::warning : Severity::info;
}

std::vector<Finding> grouped(const std::vector<Observation>& observations) {
  std::vector<std::pair<const char*, std::vector<const Observation*>>> rules;
  for (const Observation& one : observations) {
    const auto same = std::find_if(rules.begin(), rules.end(), [&](const auto& rule) {
      return std::string_view(rule.first) == one.code;
    });
    if (same == rules.end())
      rules.push_back({one.code, {&one}});
    else
      same->second.push_back(&one);
  }
  std::vector<Finding> findings;
  for (auto& [code, alike] : rules)
    findings.push_back(finding_of(code, std::move(alike)));
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return findings;
}

std::string number_text(double value) {
  constexpr double kHalfDigit = 0.0005;
  std::string text = fmt::format("{:.3f}", std::abs(value) < kHalfDigit ? 0.0 : value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string mm_text(double value) { return number_text(value) + " mm"; }

std::string point_text(const Vec2& p) {
  return fmt::format("({}, {})", number_text(p.x()), number_text(p.y()));
}

std::string factors_text(double t_factor, double r_factor) {
  if (r_factor == 0.0) return term_text(t_factor, "T");
  if (t_factor == 0.0) return term_text(r_factor, "R");
  return term_text(t_factor, "T") + " + " + term_text(r_factor, "R");
}

}  // namespace planish::inspect_detail
