#include "rule_checks.hpp"

#include <planish/base/tolerance.hpp>

#include <fmt/format.h>

#include <cmath>

namespace planish::inspect_detail {
namespace {

std::vector<Vec2> middle_of(const Workpiece& workpiece, size_t bend) {
  if (!workpiece.spans[bend]) return {};
  return {0.5 * (workpiece.spans[bend]->start + workpiece.spans[bend]->end)};
}

Observation bend_observation(const Workpiece& workpiece, size_t bend, const char* code,
                             Severity severity, std::string message, double excess) {
  return {code, {severity, std::move(message), middle_of(workpiece, bend)}, excess};
}

void observe_radius(const Workpiece& workpiece, size_t b, const Rules& rules,
                    std::vector<Observation>& result) {
  const FlatBend& bend = workpiece.pattern.bends[b];
  const double limit = rules.inside_radius_t * workpiece.thickness;
  if (bend.inside_radius >= limit - kDrawn) return;
  // A shop bends with the tools that it has; its radius changes the flat length a little.
  result.push_back(bend_observation(
      workpiece, b, "inside_radius", rules.strict ? Severity::warning : Severity::info,
      fmt::format("the inside radius of bend {} is {}; at least {} ({}) is needed", bend.id,
                  mm_text(bend.inside_radius), mm_text(limit), factors_text(rules.inside_radius_t)),
      bend.inside_radius - limit));
}

void observe_hem(const Workpiece& workpiece, size_t b, const Rules& rules,
                 std::vector<Observation>& result) {
  const FlatBend& bend = workpiece.pattern.bends[b];
  const double diameter = 2.0 * bend.inside_radius;
  const double least_diameter = rules.hem_diameter_t * workpiece.thickness;
  if (diameter < least_diameter - kDrawn) {
    result.push_back(bend_observation(
        workpiece, b, "hem", severity_of(diameter, least_diameter, kHalf, rules),
        fmt::format("the hem at bend {} is {} wide inside; at least {} ({}) is needed", bend.id,
                    mm_text(diameter), mm_text(least_diameter), factors_text(rules.hem_diameter_t)),
        diameter - least_diameter));
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
      workpiece, b, "hem", severity_of(measured, least_return, kHalf, rules),
      fmt::format("the return of the hem at bend {} is {} long from the outside "
                  "of the bend; at least {} ({}) is needed",
                  bend.id, mm_text(measured), mm_text(least_return),
                  factors_text(rules.hem_return_t)),
      measured - least_return);
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
    const auto same = std::find_if(
        alike.begin(), alike.end(), [&](const std::vector<size_t>& group) {
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
    const std::string who = group.size() == 1
                                ? "bend " + first.id
                                : fmt::format("{} bends ({} is the first)", group.size(), first.id);
    const std::string source = first.allowance.source.empty()
                                   ? ""
                                   : fmt::format(" ({})", first.allowance.source);
    FindingPlace place{
        Severity::warning,
        fmt::format("{} {} the K-factor {}{}, outside [{}, {}], the range of measured ones", who,
                    group.size() == 1 ? "has" : "have", number_text(first.allowance.k_factor),
                    source, number_text(rules.k_low), number_text(rules.k_high)),
        {}};
    for (const size_t b : group)
      for (const Vec2& p : middle_of(workpiece, b))
        place.at.push_back(p);
    result.push_back({"k_factor", std::move(place)});
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
