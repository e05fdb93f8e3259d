#include "bending.hpp"

#include "plan_report.hpp"
#include "proposal_report.hpp"
#include "refusals.hpp"
#include "sentences.hpp"

#include <planish/base/text.hpp>
#include <planish/brake/codes.hpp>
#include <planish/brake/proposals.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace planish::job {
using namespace shop;
namespace {

std::string names_of(const Report& report, const std::vector<BendId>& bends) {
  return fmt::format("{}", fmt::join(bend_ids(report, bends), ", "));
}

std::string reasons_of(const Report& report, const Plan& plan) {
  constexpr std::size_t kTold = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kTold, plan.blocked.size()); ++i)
    text += "; " + blocked_sentence(plan.blocked[i], report);
  if (plan.blocked.size() > kTold)
    text += fmt::format("; and {} more", plan.blocked.size() - kTold);
  return text;
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

void find_ungauged(Report& report, const Plan& plan) {
  std::vector<BendId> bends;
  for (const Stroke& stroke : plan.strokes)
    if (!stroke.gauge && !stroke.flattening)
      bends.insert(bends.end(), stroke.bends.begin(), stroke.bends.end());
  if (bends.empty()) return;
  Facts facts;
  for (const BendId bend : bends)
    facts.emplace_back("bend", part_place(report.flat, bend));
  report.findings.push_back(
      finding_of("no_gauge_edge", Severity::info, say::no_gauge_edge, facts, {}));
}

/// What a sentence about a bend that is in the way states.
void add_blocked(Facts& facts, const BlockedBend& blocked, const Report& report) {
  facts.emplace_back("bend", part_place(report.flat, blocked.bend));
  if (blocked.hits.empty()) return;
  if (blocked.with) facts.emplace_back("flange", place::flange(index_of(*blocked.with) + 1));
  facts.emplace_back("depth", blocked.depth, unit::mm);
  if (blocked.at_turn) facts.emplace_back("turn", blocked.at_turn->degrees(), unit::degrees);
}

/// `where` is empty: the whole part is meant.
Error cannot_bend(const Report& report, const Plan& plan, const Bending& bending) {
  std::string sentence = cannot_sentence(report, plan, bending);
  sentence.front() = 'N';
  Facts facts{{"sentence", std::move(sentence)}};
  for (const BlockedBend& blocked : plan.blocked)
    add_blocked(facts, blocked, report);
  if (plan.blocked.empty())
    for (const BendId bend : plan.unformed)
      facts.emplace_back("bend", part_place(report.flat, bend));
  Error error = error_of(refuse::cannot_bend, facts);
  error.where.clear();
  return error;
}

/// The same where bending is only looked into.
Finding cannot_bend_finding(Error why, std::vector<Vec2> at) {
  if (why.message.ends_with('.')) why.message.pop_back();  // findings have no full stop
  return {"cannot_bend",
          Severity::error,
          continued(std::move(why.message)),
          std::move(at),
          {},
          std::move(why.places),
          std::move(why.numbers)};
}

std::optional<Error> take_plan(Report& report, Plan plan, const Bending& bending) {
  const bool only_finding = bending.ask == Bending::Ask::finding;
  std::optional<Error> refusal;
  name_once(plan.blocked);
  if (plan.status == PlanStatus::infeasible) {
    Error why = cannot_bend(report, plan, bending);
    if (only_finding)
      report.findings.push_back(cannot_bend_finding(std::move(why), places_of(report, plan)));
    else
      refusal = std::move(why);
  }
  if (plan.status == PlanStatus::gave_up)
    report.findings.push_back({"no_plan",
                               Severity::warning,
                               gave_up_sentence(plan),
                               {},
                               {},
                               {},
                               {{"stages", {static_cast<double>(plan.states)}}}});
  number_bends(report.flat, plan);
  if (only_finding) return std::nullopt;
  find_ungauged(report, plan);
  report.notes.insert(report.notes.end(), plan.notes.begin(), plan.notes.end());
  report.plan = std::move(plan);
  return refusal;
}

}  // namespace

Result<std::vector<BendId>> bends_named(const Report& report,
                                        const std::vector<std::string>& names) {
  std::vector<BendId> bends;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(report.flat.bends, name, &FlatBend::id);
    if (found == report.flat.bends.end()) {
      std::vector<std::string> known;
      for (const FlatBend& bend : report.flat.bends)
        known.push_back(bend.id);
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

std::string cannot_sentence(const Report& report, const Plan& plan, const Bending& bending) {
  std::string text = "no order of strokes forms all bends with these tools";
  if (!bending.begin_with.empty())
    text += fmt::format(" that begins with {}", fmt::join(bending.begin_with, ", "));
  if (!plan.blocked.empty()) return text + reasons_of(report, plan);
  if (plan.unformed.empty()) return text;
  text += fmt::format("; each can be formed, but not after the others: {} {} left at best",
                      names_of(report, plan.unformed), plan.unformed.size() == 1 ? "is" : "are");
  // The plan's last note is then about the stage that got furthest.
  return plan.in_the_way.empty() ? text : text + "; " + plan.notes.back();
}

std::string gave_up_sentence(const Plan& plan) {
  return fmt::format(
      "no order of strokes was found among {} stages, nor was it shown that there is "
      "none: give it more time",
      plan.states);
}

std::optional<Error> plan_strokes(Report& report, const Bending& bending,
                                  const Progress& progress) {
  if (bending.ask == Bending::Ask::nothing) return std::nullopt;
  progress.at("ordering the bends", 0.95);
  PlanOptions options = bending.plan;
  auto begin = bends_named(report, bending.begin_with);
  if (!begin) return begin.error();
  options.begin_with = std::move(*begin);
  const BrakeTools& tools = tools_of(bending);
  auto plan = plan_bending(report.sheet, report.layout, tools, options, progress);
  if (plan && plan->status == PlanStatus::infeasible && bending.ask == Bending::Ask::plan) {
    progress.at("looking for what would help", 0.97);
    const ProposalOptions trying{.others = bending.tools ? &default_tools() : nullptr};
    plan->proposals = proposals(report.sheet, report.layout, tools, options, *plan, trying,
                                progress);
  }
  if (plan) return take_plan(report, std::move(*plan), bending);
  if (bending.ask == Bending::Ask::plan || plan.error().code.status != ExitStatus::refused)
    return plan.error();
  report.findings.push_back(cannot_bend_finding(plan.error(), {}));
  return std::nullopt;
}

}  // namespace planish::job
