#include "observation.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

// Breaches of a rule become one finding, with the message of the worst place and all places, the
// worst first: by severity, then by how far the limit is missed. So a part with a hundred holes too
// near to its edge says so once. A breach is a warning below a share of the limit, or always with
// strict rules (shop-floor.md#severity).

namespace planish::inspect_detail {
namespace {

std::string term_text(double factor, const char* name) {
  return factor == 1.0 ? name : number_text(factor) + " " + name;
}

/// The limit of a breach: what information misses is only a rule of thumb.
Told limit_words(Severity severity, const Facts& facts) {
  const bool usual = severity == Severity::info;
  if (std::ranges::none_of(facts, [](const Fact& fact) { return fact.name() == "rule"; }))
    return tell(usual ? say::usual_anyway : say::needed_anyway, facts);
  return tell(usual ? say::usual : say::needed, facts);
}

/// The same where all of them are information.
const char* many_unusual(std::string_view code) {
  static const std::map<std::string_view, const char*> kMany{
      {"bend_relief", "reliefs of bends are smaller than usual"},
      {"inside_radius", "bends have a smaller inside radius than usual"},
      {"hem", "hems are narrower inside or have a shorter return than usual"},
      {"opening_to_bend", "openings are closer to bends than usual"},
      {"opening_in_bend", "openings are cut through bends"},
      {"opening_to_edge", "openings are closer to the outer edge than usual"},
      {"opening_to_opening", "gaps between openings are narrower than usual"}};
  const auto found = kMany.find(code);
  return found == kMany.end() ? nullptr : found->second;
}

/// What the places of a rule have in common; follows their number.
const char* many_of(std::string_view code, Severity worst) {
  if (const char* unusual = many_unusual(code); unusual && worst == Severity::info) return unusual;
  static const std::map<std::string_view, const char*> kMany{
      {"flange_height", "flanges are too low to be bent"},
      {"bend_relief", "ends of bends have no relief, or too small a one"},
      {"flush_bend", "ends of bends are flush with an edge"},
      {"inside_radius", "bends have too small an inside radius"},
      {"hem", "hems are too narrow inside or have too short a return"},
      {"k_factor", "K-factors lie outside the range of measured ones"},
      {"opening_to_bend", "openings are too close to bends"},
      {"opening_in_bend", "openings reach into bends"},
      {"opening_to_edge", "openings are too close to the outer edge"},
      {"opening_to_opening", "gaps between openings are too narrow"},
      {"smallest_opening", "openings are too small"}};
  const auto found = kMany.find(code);
  PLANISH_ASSERT(found != kMany.end());
  return found->second;
}

/// What does away with all places of a rule.
std::vector<Remedy> remedies_of(std::string_view code) {
  if (code != "bend_relief") return {};
  return {{"bend_relief", "square", "Cut square reliefs"},
          {"bend_relief", "round", "Cut round reliefs"}};
}

Finding finding_of(const char* code, std::vector<const Observation*> alike) {
  std::ranges::stable_sort(alike, [](const Observation* a, const Observation* b) {
    if (a->place.severity != b->place.severity) return a->place.severity > b->place.severity;
    return a->excess < b->excess;
  });
  const FindingPlace& worst = alike.front()->place;
  Finding result{code,         worst.severity, worst.message,     {},         {},
                 worst.places, worst.numbers,  remedies_of(code), worst.named};
  if (alike.size() > 1) {
    Told many = told("{count} {what}; the worst: {worst}", {{"count", alike.size()},
                                                            {"what", many_of(code, worst.severity)},
                                                            {"worst", words_of(worst)}});
    result.message = std::move(many.sentence);
    result.named = std::move(many.named);
    result.numbers.insert(result.numbers.begin(), many.numbers.begin(), many.numbers.end());
  }
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
    const auto same = std::ranges::find_if(
        rules, [&](const auto& rule) { return std::string_view(rule.first) == one.code; });
    if (same == rules.end())
      rules.push_back({one.code, {&one}});
    else
      same->second.push_back(&one);
  }
  std::vector<Finding> findings;
  for (auto& [code, alike] : rules)
    findings.push_back(finding_of(code, std::move(alike)));
  std::ranges::stable_sort(findings, std::ranges::greater(), &Finding::severity);
  return findings;
}

Told told(say::Sentence sentence, const Facts& facts) {
  Told result = tell(sentence, facts);
  result.sentence = continued(std::move(result.sentence));
  return result;
}

FindingPlace breach(Severity severity, say::Sentence sentence, Facts facts, std::vector<Vec2> at) {
  facts.emplace_back("limit", limit_words(severity, facts));
  Told text = told(sentence, facts);
  return {severity,
          std::move(text.sentence),
          std::move(at),
          std::move(text.places),
          std::move(text.numbers),
          std::move(text.named)};
}

std::string factors_text(double t_factor, double r_factor) {
  if (r_factor == 0.0) return term_text(t_factor, "T");
  if (t_factor == 0.0) return term_text(r_factor, "R");
  return term_text(t_factor, "T") + " + " + term_text(r_factor, "R");
}

}  // namespace planish::inspect_detail

namespace planish {

Told words_of(const Finding& finding) { return {finding.message, {}, {}, finding.named}; }
Told words_of(const FindingPlace& place) { return {place.message, {}, {}, place.named}; }

Finding in_units(Finding finding, LengthUnit unit) {
  say_in(unit, finding.message, finding.named);
  for (FindingPlace& place : finding.places)
    say_in(unit, place.message, place.named);
  for (Remedy& remedy : finding.remedies)
    say_in(unit, remedy.change, remedy.named);
  return finding;
}

}  // namespace planish
