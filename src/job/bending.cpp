#include "bending.hpp"

#include "plan_report.hpp"
#include "proposal_report.hpp"
#include "refusals.hpp"
#include "sentences.hpp"

#include <planish/base/text.hpp>
#include <planish/brake/bend_numbers.hpp>
#include <planish/brake/codes.hpp>
#include <planish/brake/proposals.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

// The plan of strokes in a report. Where none exists, `planish bend` refuses the part; where a
// pattern is made and bending is only looked into, the same sentences are a finding. A search that
// its limit ended claims nothing either way. Bends in the pattern are numbered by their first
// stroke.

namespace planish::job {
using namespace shop;
namespace {

/// What is in the way of each bend; the data of all, in words the first.
void say_blocked(Told& told, const Report& report, const std::vector<BlockedBend>& blocked) {
  constexpr std::size_t kTold = 3;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    Told one = told_of(blocked[i], report);
    if (i >= kTold) one.sentence.clear(), one.named.clear();
    say_after(told, i < kTold ? "; " : "", one);
  }
  if (blocked.size() > kTold)
    say_after(told, "; ", tell(say::more_blocked, {{"more", blocked.size() - kTold}}));
}

/// Of a bend with several press lines the first that is blocked says why.
void name_once(std::vector<BlockedBend>& blocked) {
  std::set<BendId> named;
  std::erase_if(blocked, [&](const BlockedBend& one) { return !named.insert(one.bend).second; });
}

/// Where the bends are that a plan leaves out.
std::vector<Vec2> places_of(const Report& report, const Plan& plan) {
  std::vector<Vec2> places;
  const auto add = [&](BendId bend) {
    const auto found = std::ranges::find(report.flat.bends, bend, &FlatBend::bend);
    if (found != report.flat.bends.end() && !found->lines.empty())
      places.push_back(0.5 * (found->lines.front().a + found->lines.front().b));
  };
  for (const BlockedBend& blocked : plan.blocked)
    add(blocked.bend);
  if (plan.blocked.empty())
    for (const BendId bend : plan.unformed)
      add(bend);
  return places;
}

/// Strokes without a gauge, those for one reason together; of several strokes of a bend the first.
void find_ungauged(Report& report, const Plan& plan) {
  std::map<std::string, std::pair<Told, std::vector<BendId>>> by_reason;
  std::set<BendId> told;
  for (const Stroke& stroke : plan.strokes) {
    if (!stroke.ungauged || !told.insert(stroke.bends.front()).second) continue;
    auto& [why, bends] = by_reason.try_emplace(stroke.ungauged->told.sentence).first->second;
    why = stroke.ungauged->told;
    for (const BendId bend : stroke.bends)
      if (std::ranges::find(bends, bend) == bends.end()) bends.push_back(bend);
  }
  for (const auto& [sentence, reason] : by_reason) {
    Facts facts = mapped(reason.second,
                         [&](BendId bend) { return Fact("bend", part_place(report.flat, bend)); });
    facts.emplace_back("why", Told{sentence, {}, {}, reason.first.named});
    Finding finding = finding_of("no_gauge_edge", Severity::info, say::no_gauge_edge, facts, {});
    finding.numbers.insert(finding.numbers.end(), reason.first.numbers.begin(),
                           reason.first.numbers.end());
    report.findings.push_back(std::move(finding));
  }
}

/// A bend that the press brake does not form is said where the plan is called done.
void find_rolled(Report& report, const Plan& plan) {
  Facts facts;
  for (const LargeBend& large : plan.large)
    if (large.forming == Forming::rolled)
      facts.emplace_back("bend", part_place(report.flat, large.bend));
  if (!facts.empty())
    report.findings.push_back(
        finding_of("rolled_bend", Severity::warning, say::rolled_bend, facts, {}));
}

/// The whole part is meant: `where` is empty.
Error cannot_bend(const Report& report, const Plan& plan, const Bending& bending) {
  Told told = cannot_be_bent(report, plan, bending);
  told.sentence = capitalized(std::move(told.sentence));
  Error error = error_of(refuse::cannot_bend, {{"sentence", told.sentence}});
  error.places = std::move(told.places);
  error.numbers = std::move(told.numbers);
  error.named = std::move(told.named);
  return error;
}

/// The same where bending is only looked into: the pattern is right, and other tools may bend it.
Finding cannot_bend_finding(Error why, std::vector<Vec2> at) {
  Told words = going_on(why);
  return {"cannot_bend",
          Severity::warning,
          std::move(words.sentence),
          std::move(at),
          {},
          std::move(why.places),
          std::move(why.numbers),
          std::move(why.remedies),
          std::move(words.named)};
}

/// "; it can be bent over a V of 10 mm, or as two parts, cut at B6".
std::string help_of(const Report& report, const Plan& plan) {
  std::vector<std::string> ways;
  for (const Proposal& proposal : plan.proposals)
    ways.push_back(proposal_sentence(proposal, report));
  return ways.empty() ? std::string()
                      : fmt::format("; it can be bent {}", fmt::join(ways, ", or "));
}

std::optional<Error> take_plan(Report& report, Plan plan, const Bending& bending) {
  const bool only_finding = bending.ask == Bending::Ask::finding;
  std::optional<Error> refusal;
  name_once(plan.blocked);
  if (plan.status == PlanStatus::infeasible) {
    Error why = cannot_bend(report, plan, bending);
    why.remedies = remedies_of(plan.proposals, report);
    if (only_finding) {
      report.findings.push_back(cannot_bend_finding(std::move(why), places_of(report, plan)));
      report.findings.back().message += help_of(report, plan);
    } else {
      refusal = std::move(why);
    }
  }
  if (plan.status == PlanStatus::gave_up) {
    Told told = no_plan_found(plan);
    report.findings.push_back({.code = "no_plan",
                               .message = std::move(told.sentence),
                               .at = {},
                               .numbers = std::move(told.numbers),
                               .named = std::move(told.named)});
  }
  find_rolled(report, plan);
  number_bends(report.flat, plan);
  if (only_finding) return std::nullopt;
  find_ungauged(report, plan);
  for (const Remark& remark : plan.remarks)
    report.notes.push_back(in_units(remark.told, report.units).sentence);
  report.plan = std::move(plan);
  return refusal;
}

/// Seconds that ended the search for reasons and changes are told as those of the search for an
/// order.
void note_ended(Plan& plan, std::chrono::steady_clock::time_point until, double seconds) {
  constexpr std::string_view kTimedOut = "timed_out";
  if (std::chrono::steady_clock::now() < until ||
      std::ranges::count(plan.remarks, kTimedOut, &Remark::code) > 0)
    return;
  plan.remarks.push_back(
      {kTimedOut, tell(say::changes_timed_out, {{"seconds", seconds, unit::seconds}})});
}

/// Whether a name is that of mild steel, as shops write it.
bool is_mild_steel(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return !has("stainless") && !has("inox") &&
         std::ranges::any_of(std::array{"steel", "stahl", "acier", "s235", "s355", "dc0", "st37"},
                             has);
}

/// The file may name a metal that nothing was chosen for.
void note_metal(const Report& report, const Bending& bending, Plan& plan) {
  const bool chosen = !bending.metal.empty() ||
                      bending.plan.tensile_strength != PlanOptions{}.tensile_strength;
  if (chosen || report.material.empty() || is_mild_steel(report.material)) return;
  plan.remarks.push_back({"other_metal", tell(say::other_metal, {{"material", report.material}})});
}

}  // namespace

Result<std::vector<BendId>> bends_named(const Report& report,
                                        const std::vector<std::string>& names) {
  std::vector<BendId> bends;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(report.flat.bends, name, &FlatBend::id);
    if (found == report.flat.bends.end()) {
      const auto known = mapped(report.flat.bends, &FlatBend::id);
      return fail(
          refuse::no_such_bend,
          {{"bend", place::bend(name)}, {"known", fmt::format("{}", fmt::join(known, ", "))}},
          "fix");
    }
    bends.push_back(found->bend);
  }
  return bends;
}

const BrakeTools& tools_of(const Bending& bending) {
  return bending.tools ? *bending.tools : default_tools();
}

Told cannot_be_bent(const Report& report, const Plan& plan, const Bending& bending) {
  Told told = tell(say::no_order, {});
  if (!bending.begin_with.empty())
    say_after(told, " ",
              tell(say::that_begins,
                   {{"begun", fmt::format("{}", fmt::join(bending.begin_with, ", "))}}));
  if (!plan.blocked.empty() || plan.unformed.empty()) {
    say_blocked(told, report, plan.blocked);
    return told;
  }
  const Facts left = mapped(
      plan.unformed, [&](BendId bend) { return Fact("bend", part_place(report.flat, bend)); });
  say_after(told, "; ", tell(say::not_after_others, left));
  // The last of these: it says the most.
  if (!plan.in_the_way.empty()) say_after(told, "; ", told_of(plan.in_the_way.back(), report));
  return told;
}

Told no_plan_found(const Plan& plan) { return tell(say::no_plan, {{"stages", plan.states}}); }

std::optional<Error> plan_strokes(Report& report, const Bending& bending,
                                  const Progress& progress) {
  if (bending.ask == Bending::Ask::nothing) return std::nullopt;
  progress.at("ordering the bends", 0.95);
  PlanOptions options = bending.plan;
  auto begin = bends_named(report, bending.begin_with);
  if (!begin) return begin.error();
  for (const BendId bend : *begin)
    if (std::ranges::count(*begin, bend) > 1)
      return error_of(refuse::bend_named_twice, {{"bend", part_place(report.flat, bend)}}, "fix");
  options.begin_with = std::move(*begin);
  const BrakeTools& tools = tools_of(bending);
  const auto until = options.limits.end(std::chrono::steady_clock::now());
  auto plan = plan_bending(report.sheet, report.layout, tools, options, progress);
  if (plan && plan->status == PlanStatus::infeasible) {
    progress.at("looking for changes that would help", 0.97);
    const ProposalOptions trying{.others = bending.tools ? &default_tools() : nullptr,
                                 .until = until};
    plan->proposals = proposals(report.sheet, report.layout, tools, options, *plan, trying,
                                progress);
    note_ended(*plan, until, options.limits.seconds);
  }
  if (plan) note_metal(report, bending, *plan);
  if (plan) return take_plan(report, std::move(*plan), bending);
  if (bending.ask == Bending::Ask::plan || plan.error().code.status != ExitStatus::refused)
    return plan.error();
  report.findings.push_back(cannot_bend_finding(plan.error(), {}));
  return std::nullopt;
}

}  // namespace planish::job
