#include "proposal_report.hpp"

#include "plan_report.hpp"
#include "report_schema.hpp"
#include "sentences.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/schema/json_parts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

using Kind = Proposal::Kind;

constexpr int kDigits = 6;  // of an opening that is given as an option

struct Said {
  std::string_view key, pattern;
  std::string_view option = {};  ///< that does it
};

/// By kind.
const std::vector<Said> kSaid{
    {"smaller_v", "over a V of {opening} ({tools})", "opening"},
    {"punch", "with the additional punch {tools}"},
    {"taller_punches", "with punches {tools} {by} taller and the upper beam higher by the same"},
    {"shorter_flange", "with {flanges} shorter by {by}"},
    {"longer_flanges", "with {flanges} longer by {by}"},
    {"swap", "with {bends} swapped in the order you gave"},
    {"any_order", "in another order than you gave"},
    {"split", "as two parts, cut at {bends}"},
    {"rolled", "with {bends} rolled", "large_radii"},
    {"segments", "with segments of 10 to 300 mm for {tools}"},
    {"lower_ears", "with ears whose foot is {by} high"},
    {"die", "with the additional die {tools}"},
    {"short_punch", "with the punch up to {by} short of each end of a bend", "shortfall"}};

const Said& said_of(const Proposal& proposal) { return kSaid[static_cast<int>(proposal.kind)]; }

std::string_view pattern_of(const Proposal& proposal) {
  if (proposal.ears) return "with ears for punch {tools}";
  if (proposal.height > 0.0)
    return "with punch {tools} {height} high instead of {before}, and the upper beam higher by the "
           "same";
  if (proposal.kind == Kind::taller_punches && proposal.tools.empty())
    return "with all punches {by} taller and the upper beam higher by the same";
  return said_of(proposal).pattern;
}

std::string with_unit(double mm, const Units& units) {
  return fmt::format("{} {}", units.short_text(mm), units.symbol());
}

}  // namespace

Told told_of(const BlockedBend& blocked, const Report& report) {
  Facts facts{{"bend", part_place(report.flat, blocked.bend)}};
  Told told = tell(say::only_bend, facts);
  if (blocked.hits) {
    if (blocked.with) facts.emplace_back("flange", part_place(report.flat, *blocked.with));
    facts.emplace_back("tool", text_of(*blocked.hits));
    facts.emplace_back("depth", blocked.depth, unit::mm);
    // With a clearance that is wanted a tool may be in the way without being hit.
    const auto of = [&](std::string_view flange, std::string_view part) {
      return tell(blocked.with ? flange : part, facts);
    };
    told = blocked.through       ? of(say::flange_through, say::part_through)
           : blocked.depth > 0.0 ? of(say::flange_hits, say::part_hits)
                                 : of(say::flange_near, say::part_near);
    if (blocked.at_turn)
      say_after(told, " ",
                tell(say::at_turn, {{"turn", blocked.at_turn->degrees(), unit::degrees}}));
  }
  if (blocked.why) say_after(told, blocked.hits ? "; " : ": ", blocked.why->told);
  return in_units(std::move(told), report.units);
}

namespace {

std::string one_sentence(const Proposal& proposal, const Report& report) {
  const Units units(report.units);
  const auto all = [](const auto& names) { return fmt::format("{}", fmt::join(names, " and ")); };
  return fmt::format(fmt::runtime(pattern_of(proposal)),
                     fmt::arg("tools", fmt::format("{}", fmt::join(proposal.tools, ", "))),
                     fmt::arg("opening", with_unit(proposal.opening, units)),
                     fmt::arg("by", with_unit(proposal.by, units)),
                     fmt::arg("height", with_unit(proposal.height, units)),
                     fmt::arg("before", with_unit(proposal.height - proposal.by, units)),
                     fmt::arg("flanges", all(mapped(proposal.flanges, flange_id))),
                     fmt::arg("bends", all(bend_ids(report, proposal.bends))));
}

}  // namespace

std::string proposal_sentence(const Proposal& proposal, const Report& report) {
  std::string sentence;
  for (const Proposal& first : proposal.also)
    sentence += one_sentence(first, report) + " and ";
  return sentence + one_sentence(proposal, report);
}

std::vector<Remedy> remedies_of(const std::vector<Proposal>& proposals, const Report& report) {
  return mapped(proposals, [&](const Proposal& proposal) {
    Remedy remedy{{}, {}, "Bend it " + proposal_sentence(proposal, report)};
    remedy.option = proposal.also.empty() ? said_of(proposal).option : "";
    if (!remedy.option.empty())
      remedy.value = proposal.kind == Kind::rolled
                         ? "roll"
                         : number_text(std::max(proposal.opening, proposal.by), kDigits);
    return remedy;
  });
}

namespace {

Json proposal_json(const Proposal& proposal, const Report& report) {
  const Units units(report.units);
  Json json;
  json["kind"] = said_of(proposal).key;
  json["sentence"] = proposal_sentence(proposal, report);
  if (proposal.opening > 0.0) json["opening"] = number_json(units.length(proposal.opening));
  if (proposal.by > 0.0) json["by"] = number_json(units.length(proposal.by));
  if (proposal.height > 0.0) json["height"] = number_json(units.length(proposal.height));
  if (!proposal.tools.empty()) json["tools"] = proposal.tools;
  if (proposal.ears) json["ears"] = true;
  if (proposal.kind == Kind::shorter_flange)
    json["flange"] = flange_id(proposal.flanges.front());
  else if (!proposal.flanges.empty())
    json["flanges"] = mapped(proposal.flanges, flange_id);
  if (!proposal.bends.empty()) json["bends"] = bend_ids(report, proposal.bends);
  if (!proposal.also.empty())
    json["also"] = mapped(proposal.also,
                          [&](const Proposal& other) { return proposal_json(other, report); });
  return json;
}

std::vector<Field> proposal_keys() {
  return {required("kind", words(mapped(kSaid, &Said::key))),
          required("sentence", text().said("goes on from \"it can be bent\"")),
          optional("opening", measured_length().said("of the V")),
          optional("by",
                   measured_length().said("taller, shorter, longer or high, as the sentence says")),
          optional("height", measured_length().said("of the one punch that is taller then")),
          optional("tools", list(text()).said("the dies of that V; the punches; to have segments")),
          optional("ears", flag().said("for a punch that the shop has")),
          optional("flange", text()),
          optional("flanges", list(text())),
          optional("bends", list(text()))};
}

}  // namespace

Json proposals_json(const Plan& plan, const Report& report) {
  return mapped(plan.proposals, [&](const Proposal& one) { return proposal_json(one, report); });
}

Schema proposal_schema() {
  auto keys = proposal_keys();
  keys.push_back(optional(
      "also", list(object(proposal_keys())).said("a second change that it takes besides")));
  return object(std::move(keys));
}

std::string proposals_text(const Plan& plan, const Report& report) {
  std::string lines;
  for (const Proposal& proposal : plan.proposals)
    lines += fmt::format("  {}\n", proposal_sentence(proposal, report));
  return lines.empty() ? lines : "it can be bent\n" + lines;
}

}  // namespace planish::job
