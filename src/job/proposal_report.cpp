#include "proposal_report.hpp"

#include "plan_report.hpp"
#include "report_schema.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/json_parts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::job {
using namespace schema;
namespace {

using Kind = Proposal::Kind;

std::string_view kind_word(Kind kind) {
  return word_of(kind, {"smaller_v", "punch", "taller_punches", "shorter_flange", "swap",
                        "any_order", "split"});
}

std::string flange_name(const Proposal& proposal) {
  return proposal.flange ? flange_id(*proposal.flange) : std::string();
}

std::string with_unit(double mm, const Units& units) {
  return fmt::format("{} {}", units.short_text(mm), units.symbol());
}

}  // namespace

std::string blocked_sentence(const BlockedBend& blocked, const Report& report) {
  const Units units(report.units);
  std::string text = bend_id(report, blocked.bend);
  if (!blocked.hits.empty()) {
    text += blocked.with ? fmt::format(": {} hits ", flange_id(*blocked.with))
                         : std::string(": the part hits ");
    text += fmt::format("{} by {} {}", blocked.hits, units.short_text(blocked.depth),
                        units.symbol());
    if (blocked.at_turn) text += fmt::format(" at {:.0f}°", blocked.at_turn->degrees());
  }
  if (!blocked.why.empty()) text += (blocked.hits.empty() ? ": " : "; ") + blocked.why;
  return text;
}

std::string proposal_sentence(const Proposal& proposal, const Report& report) {
  const Units units(report.units);
  const std::string tools = fmt::format("{}", fmt::join(proposal.tools, ", "));
  const std::vector<std::string> bends = bend_ids(report, proposal.bends);
  switch (proposal.kind) {
    case Kind::smaller_v:
      return fmt::format("over a V of {} ({})", with_unit(proposal.opening, units), tools);
    case Kind::punch:
      return fmt::format("with the additional punch {}", tools);
    case Kind::taller_punches:
      return fmt::format("with punches {} taller and the upper beam higher by the same",
                         with_unit(proposal.by, units));
    case Kind::shorter_flange:
      return fmt::format("with {} shorter by {}", flange_name(proposal),
                         with_unit(proposal.by, units));
    case Kind::swap:
      return fmt::format("with {} swapped in the order you gave", fmt::join(bends, " and "));
    case Kind::any_order:
      return "in another order than you gave";
    case Kind::split:
      break;
  }
  return fmt::format("as two parts, cut at {}", fmt::join(bends, ", "));
}

Json proposals_json(const Plan& plan, const Report& report) {
  const Units units(report.units);
  Json all = Json::array();
  for (const Proposal& proposal : plan.proposals) {
    Json json;
    json["kind"] = kind_word(proposal.kind);
    json["sentence"] = proposal_sentence(proposal, report);
    if (proposal.opening > 0.0) json["opening"] = number_json(units.length(proposal.opening));
    if (proposal.by > 0.0) json["by"] = number_json(units.length(proposal.by));
    if (!proposal.tools.empty()) json["tools"] = proposal.tools;
    if (proposal.flange) json["flange"] = flange_name(proposal);
    if (!proposal.bends.empty()) json["bends"] = bend_ids(report, proposal.bends);
    all.push_back(std::move(json));
  }
  return all;
}

Schema proposal_schema() {
  return object(
      {required("kind", words({"smaller_v", "punch", "taller_punches", "shorter_flange", "swap",
                               "any_order", "split"})),
       required("sentence", text().said("goes on from \"it can be bent\"")),
       optional("opening", measured_length().said("of the V")),
       optional("by", measured_length().said("that punches are taller, or the flange is shorter")),
       optional("tools", list(text()).said("the dies of that V; the punch")),
       optional("flange", text()), optional("bends", list(text()))});
}

std::string proposals_text(const Plan& plan, const Report& report) {
  std::string lines;
  for (const Proposal& proposal : plan.proposals)
    lines += fmt::format("  {}\n", proposal_sentence(proposal, report));
  return lines.empty() ? lines : "it can be bent\n" + lines;
}

}  // namespace planish::job
