#include "proposal_report.hpp"

#include "plan_report.hpp"
#include "report_schema.hpp"
#include "sentences.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/schema/json_parts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::job {
using namespace schema;
namespace {

using Kind = Proposal::Kind;

constexpr int kDigits = 6;  // of an opening that is given as an option

const std::vector<std::string_view> kKinds{
    "smaller_v",  "punch",     "taller_punches", "shorter_flange", "longer_flanges",
    "swap",       "any_order", "split",          "rolled",         "segments",
    "lower_ears", "die",       "short_punch"};

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

std::string proposal_sentence(const Proposal& proposal, const Report& report) {
  const Units units(report.units);
  const std::string tools = fmt::format("{}", fmt::join(proposal.tools, ", "));
  const std::vector<std::string> bends = bend_ids(report, proposal.bends);
  switch (proposal.kind) {
    case Kind::smaller_v:
      return fmt::format("over a V of {} ({})", with_unit(proposal.opening, units), tools);
    case Kind::punch:
      return fmt::format("with {} {}", proposal.ears ? "ears for punch" : "the additional punch",
                         tools);
    case Kind::taller_punches:
      return fmt::format("with punches {} taller and the upper beam higher by the same",
                         with_unit(proposal.by, units));
    case Kind::shorter_flange:
    case Kind::longer_flanges:
      return fmt::format("with {} {} by {}",
                         fmt::join(mapped(proposal.flanges, flange_id), " and "),
                         proposal.kind == Kind::shorter_flange ? "shorter" : "longer",
                         with_unit(proposal.by, units));
    case Kind::swap:
      return fmt::format("with {} swapped in the order you gave", fmt::join(bends, " and "));
    case Kind::any_order:
      return "in another order than you gave";
    case Kind::rolled:
      return fmt::format("with {} rolled", fmt::join(bends, " and "));
    case Kind::segments:
      return fmt::format("with segments of 10 to 300 mm for {}", tools);
    case Kind::die:
      return "with the additional die " + tools;
    case Kind::lower_ears:
      return fmt::format("with ears whose foot is {} high", with_unit(proposal.by, units));
    case Kind::short_punch:
      return fmt::format("with the punch up to {} short of each end of a bend",
                         with_unit(proposal.by, units));
    case Kind::split:
      break;
  }
  return fmt::format("as two parts, cut at {}", fmt::join(bends, ", "));
}

std::vector<Remedy> remedies_of(const std::vector<Proposal>& proposals, const Report& report) {
  return mapped(proposals, [&](const Proposal& proposal) {
    Remedy remedy{{}, {}, "Bend it " + proposal_sentence(proposal, report)};
    if (proposal.kind == Kind::smaller_v) {
      remedy.option = "opening";
      remedy.value = number_text(proposal.opening, kDigits);
    }
    if (proposal.kind == Kind::short_punch) {
      remedy.option = "shortfall";
      remedy.value = number_text(proposal.by, kDigits);
    }
    if (proposal.kind == Kind::rolled) remedy.option = "large_radii", remedy.value = "roll";
    return remedy;
  });
}

Json proposals_json(const Plan& plan, const Report& report) {
  const Units units(report.units);
  Json all = Json::array();
  for (const Proposal& proposal : plan.proposals) {
    Json json;
    json["kind"] = kKinds[static_cast<int>(proposal.kind)];
    json["sentence"] = proposal_sentence(proposal, report);
    if (proposal.opening > 0.0) json["opening"] = number_json(units.length(proposal.opening));
    if (proposal.by > 0.0) json["by"] = number_json(units.length(proposal.by));
    if (!proposal.tools.empty()) json["tools"] = proposal.tools;
    if (proposal.ears) json["ears"] = true;
    if (!proposal.flanges.empty()) {
      if (proposal.kind == Kind::shorter_flange)
        json["flange"] = flange_id(proposal.flanges.front());
      else
        json["flanges"] = mapped(proposal.flanges, flange_id);
    }
    if (!proposal.bends.empty()) json["bends"] = bend_ids(report, proposal.bends);
    all.push_back(std::move(json));
  }
  return all;
}

Schema proposal_schema() {
  return object(
      {required("kind", words(kKinds)),
       required("sentence", text().said("goes on from \"it can be bent\"")),
       optional("opening", measured_length().said("of the V")),
       optional("by",
                measured_length().said("taller, shorter, longer or high, as the sentence says")),
       optional("tools", list(text()).said("the dies of that V; the punch; to have segments")),
       optional("ears", flag().said("for a punch that the shop has")), optional("flange", text()),
       optional("flanges", list(text())), optional("bends", list(text()))});
}

std::string proposals_text(const Plan& plan, const Report& report) {
  std::string lines;
  for (const Proposal& proposal : plan.proposals)
    lines += fmt::format("  {}\n", proposal_sentence(proposal, report));
  return lines.empty() ? lines : "it can be bent\n" + lines;
}

}  // namespace planish::job
