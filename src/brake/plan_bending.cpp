#include "describe.hpp"
#include "plan_search.hpp"
#include "preferred_tools.hpp"
#include "prepared.hpp"

#include <planish/brake/plan.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

// A plan of strokes, or why there is none. The search (stroke_search.cpp) knows lines and choices;
// here they become strokes with tools and gauge, notes, and reasons. If some bends cannot be formed
// in any stage that can be reached, these are the reasons, with what they hit in the stage that got
// furthest. Otherwise each can be formed but not after the others, and the same is told of what
// that stage leaves.

namespace planish {
namespace {

using namespace brake_detail;

/// "bend B1 has", "bends B1, B2 have"
std::string bends_have(const std::vector<std::string>& names) {
  return fmt::format("{} {} {}", names.size() == 1 ? "bend" : "bends", fmt::join(names, ", "),
                     names.size() == 1 ? "has" : "have");
}

/// Radii that air bending over the chosen V does not give, a note for each of them.
void note_radii(const StrokeInputs& inputs, Plan& plan) {
  constexpr double kBeyond = 1.0 / 3.0;  // math.md#tool-fit
  std::vector<std::pair<std::string, std::vector<std::string>>> names_by_radius;
  for (int i = 0; i < inputs.lines(); ++i) {
    const BrakeLine& line = inputs.work.lines[i];
    const double opening = inputs.tools.dies[inputs.fitting[i].dies.front()].opening;
    const double given = inputs.options.radius_of_opening * opening;
    if (!line.given_radius || line.closes || line.closed_by ||
        std::abs(line.inside_radius - given) <= kBeyond * given)
      continue;
    const std::string radius = fmt::format(
        "an inside radius of {:.4g} mm, a V of {:.4g} mm leaves about {:.4g} mm",
        line.inside_radius, opening, given);
    auto known = std::ranges::find_if(names_by_radius,
                                      [&](const auto& one) { return one.first == radius; });
    if (known == names_by_radius.end()) known = names_by_radius.insert(known, {radius, {}});
    for (const BendId bend : line.bends)
      known->second.push_back(name_of(bend));
  }
  for (const auto& [radius, names] : names_by_radius)
    plan.notes.push_back(fmt::format("{} {}", bends_have(names), radius));
  for (const BendId bend : inputs.work.rolled)
    plan.notes.push_back(fmt::format("bend {} is rolled and takes no stroke", name_of(bend)));
}

void add_strokes(StageCache& cache, const StrokeSearch& search, Plan& plan) {
  LineSet formed = no_lines(cache.inputs().lines());
  for (const StrokeChoice& choice : with_preferred_tools(cache, search.strokes)) {
    plan.strokes.push_back(describe(cache, formed, choice));
    formed = joined(formed, choice.lines);
  }
}

/// What is in the way of a bend in a stage, as a sentence.
std::string why_not(const BlockedBend& blocked) {
  if (blocked.hits.empty()) return blocked.why;
  std::string sentence;
  if (blocked.with) sentence = fmt::format("flange {}", index_of(*blocked.with) + 1);
  return fmt::format("{} is {:.3g} mm deep in the {}{}", sentence.empty() ? "the sheet" : sentence,
                     blocked.depth, blocked.hits,
                     blocked.at_turn ? fmt::format(" at {:.0f}°", blocked.at_turn->degrees()) : "");
}

/// Where each bend can be formed in some stage, but no order forms all: what is in the way of the
/// rest in the stage that got furthest. Nothing is told of a bend that could be formed there, and
/// was not because another can no longer be.
void note_furthest(StageCache& cache, const LineSet& furthest, Clock::time_point until,
                   Plan& plan) {
  constexpr int kTold = 4;  // lines: more say the same again
  int told = 0;
  for (int line = 0; line < cache.inputs().lines(); ++line) {
    if (holds(furthest, line) || told == kTold) continue;
    const BlockedBend blocked = brake_detail::blocked(cache, furthest, line, until);
    if (blocked.hits.empty() && blocked.why.empty()) continue;
    ++told;
    plan.in_the_way.push_back(blocked);
    plan.notes.push_back(fmt::format("in the stage that got furthest, {} cannot be bent: {}",
                                     name_of(blocked.bend), why_not(blocked)));
  }
}

/// What every stage hits, told for the stage that got furthest.
void add_blocked(StageCache& cache, const StrokeSearch& search, Clock::time_point until,
                 Plan& plan) {
  const std::vector<BrakeLine>& lines = cache.inputs().work.lines;
  for (const int line : search.blocked) {
    const auto& closes = lines[line].closes;
    if (closes && std::ranges::count(search.blocked, *closes)) continue;
    BlockedBend blocked = brake_detail::blocked(cache, search.furthest, line, until);
    for (const BendId bend : lines[line].bends) {
      blocked.bend = bend;
      plan.blocked.push_back(blocked);
    }
  }
  for (int i = 0; i < std::ssize(lines); ++i)
    if (!holds(search.furthest, i)) {
      for (const BendId bend : lines[i].bends)
        if (!std::ranges::count(plan.unformed, bend)) plan.unformed.push_back(bend);
    }
  if (search.blocked.empty()) note_furthest(cache, search.furthest, until, plan);
}

}  // namespace

Result<Plan> plan_bending(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                          const PlanOptions& options, const Progress& progress) {
  const auto inputs = prepared(sheet, layout, tools, options);
  if (!inputs) return pass_on(inputs);
  StageCache cache(*inputs);
  Plan plan;
  note_radii(*inputs, plan);
  const Clock::time_point until = options.limits.end(Clock::now());
  auto search = search_plan(cache, progress);
  if (!search) return pass_on(search);
  if (search->furthest.empty()) search->furthest = no_lines(inputs->lines());
  plan.status = search->status;
  plan.cost = search->cost;
  plan.turn_overs = search->turn_overs;
  plan.rotations = search->rotations;
  plan.tool_changes = search->tool_changes;
  plan.ungauged = search->ungauged;
  plan.states = search->stages;
  add_strokes(cache, *search, plan);
  if (plan.status == PlanStatus::infeasible) add_blocked(cache, *search, until, plan);
  return plan;
}

}  // namespace planish
