#include "describe.hpp"
#include "plan_search.hpp"
#include "preferred_tools.hpp"
#include "prepared.hpp"
#include "sentences.hpp"

#include <planish/brake/plan.hpp>

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

/// Radii that air bending over the chosen V does not give, a remark on each of them.
void note_radii(const StrokeInputs& inputs, Plan& plan) {
  constexpr double kBeyond = 1.0 / 3.0;  // math.md#tool-fit
  std::vector<std::pair<std::string, Facts>> bends_by_radius;
  for (int i = 0; i < inputs.lines(); ++i) {
    const BrakeLine& line = inputs.work.lines[i];
    const double opening = inputs.tools.dies[inputs.fitting[i].dies.front()].opening;
    const double left = inputs.options.radius_of_opening * opening;
    if (!line.given_radius || line.closes || line.closed_by ||
        std::abs(line.inside_radius - left) <= kBeyond * left)
      continue;
    const std::string sizes = number_text(line.inside_radius) + " " + number_text(opening);
    auto known = std::ranges::find(bends_by_radius, sizes, &std::pair<std::string, Facts>::first);
    if (known == bends_by_radius.end())
      known = bends_by_radius.insert(known, {sizes,
                                             {{"radius", line.inside_radius, unit::mm},
                                              {"opening", opening, unit::mm},
                                              {"left", left, unit::mm}}});
    for (const BendId bend : line.bends)
      known->second.emplace_back("bend", place::bend(name_of(bend)));
  }
  for (const auto& [sizes, facts] : bends_by_radius)
    plan.remarks.push_back(remark_of(say::other_radius, facts));
  for (const BendId bend : inputs.work.rolled)
    plan.remarks.push_back(remark_of(say::rolled, {{"bend", place::bend(name_of(bend))}}));
}

void add_strokes(StageCache& cache, const StrokeSearch& search, Plan& plan) {
  LineSet formed = no_lines(cache.inputs().lines());
  for (const StrokeChoice& choice : with_preferred_tools(cache, search.strokes)) {
    plan.strokes.push_back(describe(cache, formed, choice));
    formed = joined(formed, choice.lines);
  }
}

/// What is in the way of a bend in the stage that got furthest.
Remark told_of(const BlockedBend& blocked) {
  Facts facts{{"bend", place::bend(name_of(blocked.bend))}};
  if (!blocked.hits) {
    Remark remark = remark_of(say::cannot_be_bent, facts);
    say_after(remark.told, ": ", blocked.why->told);
    return remark;
  }
  if (blocked.with) facts.emplace_back("flange", place::flange(index_of(*blocked.with) + 1));
  facts.emplace_back("depth", blocked.depth, unit::mm);
  facts.emplace_back("tool", text_of(*blocked.hits));
  Remark remark = remark_of(blocked.with ? say::flange_in_tool : say::sheet_in_tool, facts);
  if (blocked.at_turn)
    say_after(remark.told, " ",
              tell(say::at_turn, {{"turn", blocked.at_turn->degrees(), unit::degrees}}));
  return remark;
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
    if (!blocked.hits && !blocked.why) continue;
    ++told;
    plan.in_the_way.push_back(blocked);
    plan.remarks.push_back(told_of(blocked));
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
