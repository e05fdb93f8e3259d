#include "slit_equilibrium.hpp"

#include "report_schema.hpp"
#include "sentences.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <algorithm>

// What a sheet of a material bears, in words, numbers and findings. A stress above the yield stress
// is a warning, as the sheet is then no more elastic; one below it is information: the strip
// springs open when it is let go. A sheet that falls over is no error, as it may be held.

namespace planish::job {
using namespace schema;
namespace {

constexpr std::string_view kStress = "N/mm²";

Json vector_json(const Vec3& v) {
  return {number_json(v.x()), number_json(v.y()), number_json(v.z())};
}

std::string_view word_of_holder(HeldBy end) {
  return word_of(end, {"panel", "end", "ground", "neighbours", "wishes"});
}

Json standing_json(const SlitStanding& standing, const Units& units) {
  Json json;
  json["stands"] = standing.stands;
  json["margin"] = number_json(standing.margin.degrees());
  json["centre_of_mass"] = space_point_json(standing.centre_of_mass, units);
  json["support"] = json_array(standing.support,
                               [&](const Vec2& point) { return point_json(point, units); });
  return json;
}

Finding with_remedy(Finding finding, std::string change) {
  finding.remedies.push_back({{}, {}, std::move(change)});
  return finding;
}

Finding yields(const SlitReport& report, int strip, const Vec2& at) {
  const SlitEquilibrium& state = *report.equilibrium;
  Facts facts{{"strip", place::strip(strip)},
              {"stress", state.stress[strip], kStress},
              {"yield", *report.design.material->yield, kStress}};
  if (const auto kept = state.kept_radius[strip]) facts.emplace_back("kept", *kept, unit::mm);
  return with_remedy(
      finding_of("yields", Severity::warning,
                 state.kept_radius[strip] ? say::strip_yields_and_keeps : say::strip_yields, facts,
                 {at}),
      "Use a thinner sheet or a stronger material, or bend the strip less");
}

Finding unstable(int strip, const Vec2& at) {
  return with_remedy(finding_of("unstable", Severity::warning, say::strip_unstable,
                                {{"strip", place::strip(strip)}}, {at}),
                     "Use a thicker sheet, make the strip shorter or wider, or load it less");
}

Finding falls_over(const SlitStanding& standing) {
  const double back = std::max(0.0, -standing.margin.degrees());
  return with_remedy(finding_of("falls_over", Severity::warning, say::falls_over,
                                {{"margin", back, unit::degrees}}, {}),
                     "Move the load over the feet, or set the feet wider apart");
}

/// One for all strips that spring open.
Finding springs_open(const SlitReport& report, const std::vector<int>& strips,
                     const std::vector<Vec2>& at) {
  Facts facts;
  std::vector<Vec2> where;
  double most = 0.0;
  for (const int strip : strips) {
    facts.emplace_back("strip", place::strip(strip));
    where.push_back(at[strip]);
    most = std::max(most, report.equilibrium->stress[strip]);
  }
  facts.emplace_back("spring", strips.size() == 1 ? "springs" : "spring");
  facts.emplace_back("stress", most, kStress);
  facts.emplace_back("yield", *report.design.material->yield, kStress);
  return with_remedy(
      finding_of("springs_open", Severity::info, say::springs_open, facts, std::move(where)),
      "Hold the ends of the strips");
}

}  // namespace

std::vector<Field> strip_equilibrium_fields() {
  return {optional("stress", number(kAnyNumber).or_null()),
          optional("kept_radius", measured_length().or_null())};
}

std::vector<Field> equilibrium_fields() {
  const auto vector = [] { return tuple(3, number(kAnyNumber).or_null(), "three numbers"); };
  const Schema reaction = object(
      {required("strip", whole()),
       required("end", words({"panel", "end", "ground", "neighbours", "wishes"})),
       required("force", vector()), required("moment", vector()),
       required("at", report_space_point())});
  const Schema standing = object({required("stands", flag()),
                                  required("margin", number(kAnyNumber)),
                                  required("centre_of_mass", report_space_point()),
                                  required("support", list(report_point()))});
  return {optional("stable", flag()), optional("standing", standing.or_null()),
          optional("reactions", list(reaction))};
}

void add_equilibrium(Json& slit, const SlitReport& report, const Units& units) {
  if (!report.equilibrium) return;
  const SlitEquilibrium& state = *report.equilibrium;
  for (std::size_t i = 0; i < state.stress.size(); ++i) {
    const auto kept = state.kept_radius[i];
    slit["strips"][i]["stress"] = number_json(state.stress[i]);
    slit["strips"][i]["kept_radius"] = kept ? number_json(units.length(*kept)) : Json(nullptr);
  }
  if (state.is_stable.empty()) return;
  slit["stable"] = std::ranges::find(state.is_stable, false) == state.is_stable.end();
  slit["standing"] = state.standing ? standing_json(*state.standing, units) : Json(nullptr);
  slit["reactions"] = json_array(state.reactions, [&](const SlitReaction& one) {
    return Json{{"strip", one.strip},
                {"end", word_of_holder(one.end)},
                {"force", vector_json(one.force)},
                {"moment", vector_json(one.moment)},
                {"at", space_point_json(one.at, units)}};
  });
}

std::string equilibrium_text(const SlitReport& report) {
  if (!report.equilibrium) return {};
  const SlitEquilibrium& state = *report.equilibrium;
  const auto most = std::ranges::max_element(state.stress);
  std::string text = fmt::format("largest bending stress {} N/mm², in strip {}\n",
                                 number_text(*most), most - state.stress.begin() + 1);
  if (state.standing && state.standing->stands)
    text += fmt::format("it stands, and may be tilted by {}°\n",
                        number_text(state.standing->margin.degrees()));
  return text;
}

std::vector<Finding> equilibrium_findings(const SlitReport& report, const std::vector<Vec2>& at) {
  std::vector<Finding> findings;
  if (!report.equilibrium) return findings;
  const SlitEquilibrium& state = *report.equilibrium;
  const auto yield = report.design.material->yield;
  std::vector<int> springs;
  for (int strip = 0; strip < std::ssize(state.stress); ++strip) {
    const double stress = state.stress[strip];
    if (yield && stress > *yield) findings.push_back(yields(report, strip, at[strip]));
    if (yield && stress > 0.0 && stress <= *yield) springs.push_back(strip);
    if (!state.is_stable.empty() && !state.is_stable[strip])
      findings.push_back(unstable(strip, at[strip]));
  }
  if (state.standing && !state.standing->stands) findings.push_back(falls_over(*state.standing));
  if (!springs.empty()) findings.push_back(springs_open(report, springs, at));
  return findings;
}

}  // namespace planish::job
