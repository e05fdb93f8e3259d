#include "describe.hpp"
#include "laid_strokes.hpp"
#include "large_radius.hpp"
#include "plan_search.hpp"
#include "prepared.hpp"
#include "sentences.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/brake/plan.hpp>

#include <algorithm>
#include <cmath>
#include <set>

// A plan of strokes, or why there is none. The search (stroke_search.cpp) knows lines and choices;
// here they become strokes with tools and gauge, notes, and reasons. If some bends cannot be formed
// in any stage that can be reached, these are the reasons, with what they hit in the stage that got
// furthest. Otherwise each can be formed but not after the others, and the same is told of what
// that stage leaves.

namespace planish {
namespace {

using namespace brake_detail;

/// Says something of strokes, once for those of the same numbers.
class Remarks {
 public:
  void add(const say::Sentence& sentence, const Facts& numbers, const std::vector<BendId>& bends) {
    std::string key(sentence.code);
    for (const Fact& fact : numbers)
      key += " " + (fact.quantity() ? number_text(fact.quantity()->value) : fact.words()->sentence);
    auto known = std::ranges::find(all_, key, &One::key);
    if (known == all_.end()) known = all_.insert(known, {key, sentence, numbers});
    for (const BendId bend : bends)
      if (std::ranges::find(known->bends, bend) == known->bends.end()) {
        known->bends.push_back(bend);
        known->facts.emplace_back("bend", place::bend(name_of(bend)));
      }
  }

  void tell(Plan& plan) const {
    for (const One& one : all_)
      plan.remarks.push_back(remark_of(one.sentence, one.facts));
  }

 private:
  struct One {
    std::string key;
    say::Sentence sentence;
    Facts facts;
    std::vector<BendId> bends = {};
  };
  std::vector<One> all_;
};

/// Whether the V is to be told beside the wanted one: makers' sizes are a quarter apart.
bool is_other_size(const Stroke& stroke, double opening) {
  constexpr double kOtherSize = 0.2;
  return stroke.v_away > 0 || std::abs(opening - stroke.v_wanted) > kOtherSize * stroke.v_wanted;
}

/// Where tools leave another radius than the drawn one, or the V is not the wanted one.
void note_tools(const StrokeInputs& inputs, Plan& plan) {
  constexpr double kNarrow = 5.0;  // V in thicknesses (math.md#v-choice)
  const double thickness = inputs.work.thickness;
  Remarks remarks;
  for (const Stroke& stroke : plan.strokes) {
    if (stroke.open_hem)
      remarks.add(
          say::open_hem,
          {{"height", stroke.open_hem->height, unit::mm}, {"gap", stroke.open_hem->gap, unit::mm}},
          stroke.bends);
    if (stroke.gauge && !stroke.gauge->is_square())
      remarks.add(
          say::short_gauge,
          {{"touched", stroke.gauge->touched, unit::mm}, {"line", stroke.gauge->line, unit::mm}},
          stroke.bends);
    if (stroke.flattening || is_hem(stroke.angle)) continue;
    const auto die = std::ranges::find(inputs.tools.dies, stroke.die, &Die::id);
    const Fact opening("opening", die->opening, unit::mm);
    const Fact left("left", stroke.radius_made, unit::mm),
        radius("radius", stroke.radius_drawn, unit::mm);
    if (is_made_otherwise(stroke, thickness)) {
      if (stroke.radius_made > inputs.options.radius_of_opening * die->opening)
        remarks.add(say::tip_radius, {{"punch", stroke.punch}, left, radius}, stroke.bends);
      else
        remarks.add(say::other_radius, {opening, left, radius}, stroke.bends);
    }
    if (die->opening < kNarrow * thickness - tolerance::kWrittenDigits)
      remarks.add(say::narrow_v, {opening, {"least", kNarrow * thickness, unit::mm}}, stroke.bends);
    if (is_other_size(stroke, die->opening))
      remarks.add(
          say::other_v,
          {opening,
           {"wanted", stroke.v_wanted, unit::mm},
           {"force", force_per_length(inputs.options.tensile_strength, thickness, die->opening),
            say::kPerMetre}},
          stroke.bends);
  }
  remarks.tell(plan);
}

void note_large(const StrokeInputs& inputs, Plan& plan) {
  for (const LargeBend& large : inputs.work.large) {
    const Fact bend("bend", place::bend(name_of(large.bend)));
    if (large.forming == Forming::rolled)
      plan.remarks.push_back(
          remark_of(inputs.options.large_radii ? say::rolled : say::rolled_since, {bend}));
    if (large.forming == Forming::bumps) {
      const double wanted = inputs.options.chord_error;
      const bool coarser = large.chord_error > wanted * (1.0 + tolerance::kComputed);
      plan.remarks.push_back(remark_of(coarser ? say::bumped_coarser : say::bumped,
                                       {bend,
                                        {"bumps", large.bumps},
                                        {"angle", large.angle.degrees(), unit::degrees},
                                        {"pitch", large.pitch, unit::mm},
                                        {"error", large.chord_error, unit::mm},
                                        {"wanted", wanted, unit::mm}}));
    }
  }
}

/// The strokes with their stations, and what they cost with every set-up. One more than the search
/// counted, since segments or the length of the press do not do for all, may be one that another
/// order needs not.
void add_strokes(StageCache& cache, const LaidStrokes& laid, Plan& plan) {
  for (std::size_t i = 0; i < laid.chosen.size(); ++i)
    plan.strokes.push_back(
        describe(cache, laid.chosen[i].formed, laid.bed.choices[i], laid.bed.rows[i]));
  plan.stations = laid.bed.stations;
  plan.cost = laid.search.cost;
  plan.turn_overs = laid.search.turn_overs;
  plan.rotations = laid.search.rotations;
  plan.tool_changes = laid.search.tool_changes;
  plan.ungauged = laid.search.ungauged;
  plan.v_away = laid.search.v_away;
  if (plan.status == PlanStatus::optimal && laid.is_dearer) plan.status = PlanStatus::feasible;
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
  // With a clearance that is wanted a tool may be in the way without being hit.
  const auto of = [&](const say::Sentence& flange, const say::Sentence& sheet) {
    return remark_of(blocked.with ? flange : sheet, facts);
  };
  Remark remark = blocked.through       ? of(say::flange_through_tool, say::sheet_through_tool)
                  : blocked.depth > 0.0 ? of(say::flange_in_tool, say::sheet_in_tool)
                                        : of(say::flange_near_tool, say::sheet_near_tool);
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
  constexpr std::size_t kTold = 4;  // bends: more say the same again
  std::set<BendId> told;            // one of several press lines is enough
  for (int line = 0; line < cache.inputs().lines(); ++line) {
    const BendId bend = cache.inputs().work.lines[line].bends.front();
    if (holds(furthest, line) || told.size() == kTold || told.contains(bend)) continue;
    const BlockedBend blocked = brake_detail::blocked(cache, furthest, line, until);
    if (!blocked.hits && !blocked.why) continue;
    told.insert(bend);
    plan.in_the_way.push_back(blocked);
    plan.remarks.push_back(told_of(blocked));
  }
}

/// What is left in the stage that got furthest.
void add_unformed(const StrokeInputs& inputs, const StrokeSearch& search, Plan& plan) {
  for (int i = 0; i < inputs.lines(); ++i)
    if (!holds(search.furthest, i)) {
      for (const BendId bend : inputs.work.lines[i].bends)
        if (!std::ranges::count(plan.unformed, bend)) plan.unformed.push_back(bend);
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
  if (search.blocked.empty() && search.none_last) plan.remarks.push_back(remark_of(say::none_last));
  if (search.blocked.empty()) note_furthest(cache, search.furthest, until, plan);
}

}  // namespace

bool makes_radius(const Stroke& stroke) {
  return !stroke.flattening && !stroke.press_line && !is_hem(stroke.angle);
}

double told_from(double radius_drawn, double thickness) {
  constexpr double kTold = 0.1, kToldOfThickness = 0.2;  // math.md#made-radius
  return std::min(kTold * radius_drawn, kToldOfThickness * thickness);
}

bool is_made_otherwise(const Stroke& stroke, double thickness) {
  return makes_radius(stroke) && std::abs(stroke.radius_made - stroke.radius_drawn) >
                                     told_from(stroke.radius_drawn, thickness);
}

namespace {

/// The plan for what is prepared; without reasons where these are not wanted.
Result<Plan> planned(const StrokeInputs& inputs, const Progress& progress) {
  const PlanOptions& options = inputs.options;
  StageCache cache(inputs);
  Plan plan;
  plan.large = inputs.work.large;
  note_large(inputs, plan);
  const Clock::time_point until = options.limits.end(Clock::now());
  auto search = search_plan(cache, progress);
  if (!search) return pass_on(search);
  if (search->furthest.empty()) search->furthest = no_lines(inputs.lines());
  plan.status = search->status;
  plan.states = search->stages;
  if (search->timed_out)
    plan.remarks.push_back(
        remark_of(plan.status == PlanStatus::infeasible ? say::reasons_timed_out : say::timed_out,
                  {{"seconds", options.limits.seconds, unit::seconds}}));
  add_strokes(cache, laid_strokes(cache, *search, progress), plan);
  note_tools(inputs, plan);
  if (plan.status != PlanStatus::infeasible) return plan;
  add_unformed(inputs, *search, plan);
  if (options.limits.reasons) add_blocked(cache, *search, until, plan);
  return plan;
}

}  // namespace

bool has_order(const Plan& plan) {
  return plan.status == PlanStatus::optimal || plan.status == PlanStatus::feasible;
}

bool only_rolls(const Plan& plan) {
  return has_order(plan) && plan.strokes.empty() &&
         std::ranges::count(plan.large, Forming::rolled, &LargeBend::forming) > 0;
}

Result<Plan> plan_bending(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                          const PlanOptions& options, const Progress& progress) {
  PlanOptions tried = options;
  tried.limits.until = options.limits.end(Clock::now());
  std::optional<StrokeInputs> first;  // told if no way of forming large radii helps
  for (;;) {
    auto inputs = prepared(sheet, layout, tools, tried);
    if (!inputs) return pass_on(inputs);
    const bool is_last = !has_next(inputs->work.large, options);
    if (!is_last && !first) first.emplace(*inputs);
    inputs->options.limits.reasons = options.limits.reasons && is_last && !first;
    auto plan = planned(*inputs, progress);
    const bool ended = !plan || has_order(*plan) || Clock::now() > tried.limits.until;
    if (ended || (is_last && !first)) return plan;
    if (is_last) return plan->status == PlanStatus::infeasible ? planned(*first, progress) : plan;
    tried.large = plan->large;
    take_next(tried.large, plan->unformed, sheet, layout, options);
  }
}

}  // namespace planish
