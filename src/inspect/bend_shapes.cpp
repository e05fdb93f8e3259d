#include "rule_checks.hpp"

#include <planish/base/tolerance.hpp>

#include <cmath>

// Rules about a bend alone: its inside radius, a hem's inside diameter and return, its K
// (shop-floor.md#rules-of-manufacture). A return is the shortest flat length at the bend, measured
// as shops do from the outside of the bend. K belongs to material and tool rather than to a bend,
// so all bends with the same wrong K are one place.

namespace planish::inspect_detail {
namespace {

std::vector<Vec2> middle_of(const Workpiece& workpiece, size_t bend) {
  if (!workpiece.spans[bend]) return {};
  return {0.5 * (workpiece.spans[bend]->start + workpiece.spans[bend]->end)};
}

/// A length at a bend, and the least that a rule allows.
struct Measured {
  double measured, wanted;  // mm
  std::string rule;
};

Observation bend_observation(const Workpiece& workpiece, size_t bend, const char* code,
                             Severity severity, say::Sentence sentence, const Measured& length) {
  const Facts facts{{"bend", workpiece.place_of(bend)},
                    {"measured", length.measured, unit::mm},
                    {"wanted", length.wanted, unit::mm},
                    {"rule", length.rule}};
  return {code, breach(severity, sentence, facts, middle_of(workpiece, bend)),
          length.measured - length.wanted};
}

void observe_radius(const Workpiece& workpiece, size_t b, const Rules& rules,
                    std::vector<Observation>& result) {
  const FlatBend& bend = workpiece.pattern.bends[b];
  const double limit = rules.inside_radius_t * workpiece.thickness;
  if (bend.inside_radius >= limit - kDrawn) return;
  // A shop bends with the tools that it has; its radius changes the flat length a little.
  result.push_back(bend_observation(
      workpiece, b, "inside_radius", rules.strict ? Severity::warning : Severity::info,
      say::small_radius, {bend.inside_radius, limit, factors_text(rules.inside_radius_t)}));
}

void observe_hem(const Workpiece& workpiece, size_t b, const Rules& rules,
                 std::vector<Observation>& result) {
  const FlatBend& bend = workpiece.pattern.bends[b];
  const double diameter = 2.0 * bend.inside_radius;
  const double least_diameter = rules.hem_diameter_t * workpiece.thickness;
  if (diameter < least_diameter - kDrawn) {
    result.push_back(bend_observation(
        workpiece, b, "hem", severity_of(diameter, least_diameter, kHalf, rules), say::narrow_hem,
        {diameter, least_diameter, factors_text(rules.hem_diameter_t)}));
  }
  const double least_return = rules.hem_return_t * workpiece.thickness;
  const double outside = bend.inside_radius + workpiece.thickness;
  FlatLength shortest{std::numeric_limits<double>::infinity(), Vec2::Zero(), std::nullopt};
  for (const BendSide& side : workpiece.sides_of(b)) {
    const FlatLength flat = shortest_flat(workpiece, side, std::max(0.0, least_return - outside),
                                          least_return);
    if (flat.length < shortest.length) shortest = flat;
  }
  const double measured = shortest.length + outside;
  if (measured >= least_return - kDrawn) return;
  Observation one = bend_observation(
      workpiece, b, "hem", severity_of(measured, least_return, kHalf, rules), say::short_return,
      {measured, least_return, factors_text(rules.hem_return_t)});
  one.place.at = {shortest.at};
  result.push_back(std::move(one));
}

/// K is a property of material and tool, so all bends with the same wrong K are one place.
void observe_k_factors(const Workpiece& workpiece, const Rules& rules,
                       std::vector<Observation>& result) {
  constexpr double kSame = tolerance::kWrittenDigits;
  std::vector<std::vector<size_t>> alike;  // bends by K, in the order of their first
  const auto& bends = workpiece.pattern.bends;
  for (size_t b = 0; b < bends.size(); ++b) {
    const double k = bends[b].allowance.k_factor;
    if (k >= rules.k_low - kSame && k <= rules.k_high + kSame) continue;
    const auto same = std::ranges::find_if(alike, [&](const std::vector<size_t>& group) {
      return std::abs(bends[group.front()].allowance.k_factor - k) <= kSame;
    });
    if (same == alike.end()) {
      alike.push_back({b});
    } else {
      same->push_back(b);
    }
  }
  for (const std::vector<size_t>& group : alike) {
    const FlatBend& first = bends[group.front()];
    const std::string& source = first.allowance.source;
    Facts facts{{"measured", first.allowance.k_factor, unit::none},
                {"low", rules.k_low, unit::none},
                {"high", rules.k_high, unit::none},
                {"source", source.empty() ? source : " (" + source + ")"},
                {"bend", workpiece.place_of(group.front())}};
    const bool one = group.size() == 1;
    if (!one) facts.emplace_back("count", group.size());
    std::vector<Vec2> at;
    for (const size_t b : group) {
      if (b != group.front()) facts.emplace_back("more", workpiece.place_of(b));
      for (const Vec2& p : middle_of(workpiece, b))
        at.push_back(p);
    }
    result.push_back({"k_factor", breach(Severity::warning, one ? say::odd_k : say::odd_k_of_many,
                                         facts, std::move(at))});
  }
}

}  // namespace

std::vector<Observation> observe_bend_shapes(const Workpiece& workpiece, const Rules& rules) {
  std::vector<Observation> result;
  for (size_t b = 0; b < workpiece.pattern.bends.size(); ++b) {
    if (is_hem(workpiece.pattern.bends[b])) {
      observe_hem(workpiece, b, rules, result);
    } else {
      observe_radius(workpiece, b, rules, result);
    }
  }
  observe_k_factors(workpiece, rules, result);
  return result;
}

}  // namespace planish::inspect_detail
