// An order that is given. Its strokes are taken one after the other, each with all ways in which
// it can be made, or the way that comes nearest; then the search for the cheapest plan chooses
// among these ways. What must hold: stages after a stroke that cannot be made are what they would
// be (math.md#bend-order).
#include "bed.hpp"
#include "check.hpp"
#include "choices.hpp"
#include "describe.hpp"
#include "line_depth.hpp"
#include "prepared.hpp"
#include "refusals.hpp"
#include "scene.hpp"
#include "sentences.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <limits>

namespace planish {
namespace {

using namespace brake_detail;

/// A stroke of an order with the ways in which it can be made; if there is none, with the one that
/// comes nearest.
struct OrderStep {
  LineSet formed;  ///< before it
  std::vector<StrokeChoice> ways;
  std::optional<BlockedBend> blocked = {};
};

/// Takes the strokes of an order one after the other.
class OrderSteps {
 public:
  explicit OrderSteps(StageCache& cache)
      : cache_(cache), work_(cache.inputs().work), formed_(no_lines(cache.inputs().lines())) {}

  const std::vector<OrderStep>& steps() const { return steps_; }
  const LineSet& formed() const { return formed_; }
  /// A hem that was closed before it was bent counts as closed once it is bent.
  LineSet standing(LineSet formed) const {
    LineSet stage = no_lines(cache_.inputs().lines());
    for (const int line : members(formed)) {
      const auto& closes = work_.lines[line].closes;
      if (!closes || holds(formed, *closes)) insert(stage, line);
    }
    return stage;
  }

  /// Presses these lines, all at once as far as they are offered together.
  void press(LineSet lines) {
    while (count(lines) > 0) {
      const LineSet next = offered(lines);
      add(next);
      for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i] &= ~next[i];
    }
  }

  /// Presses what is left, first what can be made, from the outside in.
  void press_rest(const Progress& progress) {
    std::vector<int> rest;
    for (int line = 0; line < std::ssize(work_.lines); ++line)
      if (!holds(formed_, line)) rest.push_back(line);
    const std::vector<int> depth = line_depths(work_);
    std::ranges::stable_sort(rest, {}, [&](int line) { return depth[line]; });
    while (!rest.empty() && !progress.should_stop()) {
      auto next = std::ranges::find_if(rest, [&](int line) { return can_press(line); });
      if (next == rest.end())
        next = std::ranges::find_if(rest, [&](int line) {
          const auto& closes = work_.lines[line].closes;
          return !closes || holds(formed_, *closes);
        });
      add(only(cache_.inputs().lines(), *next));
      rest.erase(next);
    }
  }

 private:
  /// Of these lines as many as a stroke may press together; one if it may press none.
  LineSet offered(const LineSet& lines) {
    LineSet best = no_lines(cache_.inputs().lines());
    for (const StrokeChoice& choice : choices(cache_, standing(formed_)))
      if (within(choice.lines, lines) && count(choice.lines) > count(best)) best = choice.lines;
    if (count(best) == 0) insert(best, members(lines).front());
    return best;
  }

  std::vector<StrokeChoice> ways(const LineSet& lines) {
    const LineSet stage = standing(formed_);
    std::vector<StrokeChoice> ways = choices(cache_, stage);
    std::erase_if(ways, [&](const StrokeChoice& choice) {
      return choice.lines != lines || !check(cache_, stage, choice).feasible;
    });
    return ways;
  }

  bool can_press(int line) { return !ways(only(cache_.inputs().lines(), line)).empty(); }

  void add(const LineSet& lines) {
    OrderStep step{formed_, ways(lines)};
    if (step.ways.empty()) {
      const LineSet stage = standing(formed_);
      auto nearest = blocked_way(cache_, stage, lines);
      const auto& closes = work_.lines[members(lines).front()].closes;
      if (closes && !holds(stage, *closes))
        nearest.bend = {.bend = nearest.bend.bend, .why = remark_of(say::hem_not_bent)};
      step.ways = {nearest.choice};
      step.blocked = nearest.bend;
    }
    steps_.push_back(std::move(step));
    formed_ = joined(std::move(formed_), lines);
  }

  StageCache& cache_;
  const Workpiece& work_;
  LineSet formed_;
  std::vector<OrderStep> steps_;
};

/// A stroke of an order, by its number from 1, and its bends.
Error refused(const Refusal& refusal, int number, const OrderedStroke& stroke) {
  Facts facts{{"stroke", place::stroke(number)}};
  for (const BendId bend : stroke.bends)
    facts.emplace_back("bend", place::bend(name_of(bend)));
  return error_of(refusal, facts, "order");
}

/// Presses what an order says. The error says which of its strokes makes no sense.
std::optional<Error> take(OrderSteps& steps, const Workpiece& work,
                          const std::vector<OrderedStroke>& order, const Progress& progress) {
  LineSet taken = no_lines(static_cast<int>(work.lines.size()));
  int number = 0;
  for (const OrderedStroke& stroke : order) {
    if (progress.should_stop()) return std::nullopt;
    const LineSet lines = lines_of(work, stroke);
    ++number;
    if (count(lines) == 0)
      return refused(stroke.bends.empty() ? refuse::stroke_of_no_bend : refuse::no_such_stroke,
                     number, stroke);
    if (!disjoint(taken, lines)) return refused(refuse::pressed_twice, number, stroke);
    taken = joined(std::move(taken), lines);
    steps.press(lines);
  }
  steps.press_rest(progress);
  return std::nullopt;
}

/// Of the ways to make each step those that make the whole cheapest.
Result<StrokeSearch> cheapest(const std::vector<OrderStep>& steps, const LineSet& all,
                              const StrokeWeights& weights, const Progress& progress) {
  StrokeProblem problem;
  problem.lines = count(all);
  problem.choices = [&](const LineSet& formed) {
    const auto step = std::ranges::find(steps, formed, &OrderStep::formed);
    PLANISH_ASSERT(step != steps.end());
    return step->ways;
  };
  StrokeLimits limits;
  limits.seconds = std::numeric_limits<double>::infinity();
  limits.stages = std::numeric_limits<std::int64_t>::max();
  return search_strokes(problem, weights, limits, progress);
}

}  // namespace

struct OrderChecker::State {
  BrakeTools tools;
  PlanOptions options;
  std::optional<StrokeInputs> inputs = {};
  std::optional<StageCache> cache = {};
};

OrderChecker::OrderChecker(std::unique_ptr<State> state) : state_(std::move(state)) {}
OrderChecker::OrderChecker(OrderChecker&&) noexcept = default;
OrderChecker& OrderChecker::operator=(OrderChecker&&) noexcept = default;
OrderChecker::~OrderChecker() = default;

Result<OrderChecker> OrderChecker::make(const Sheet& sheet, const Layout& layout,
                                        const BrakeTools& tools, const PlanOptions& options) {
  auto state = std::make_unique<State>(State{tools, options});
  state->options.begin_with.clear();
  auto inputs = prepared(sheet, layout, state->tools, state->options);
  if (!inputs) return pass_on(inputs);
  state->cache.emplace(state->inputs.emplace(std::move(*inputs)));
  return OrderChecker(std::move(state));
}

Result<CheckedOrder> OrderChecker::check(const std::vector<OrderedStroke>& order,
                                         const Progress& progress) {
  StageCache& cache = *state_->cache;
  OrderSteps steps(cache);
  if (const auto error = take(steps, cache.inputs().work, order, progress))
    return tl::unexpected(*error);
  if (progress.should_stop()) return fail(refuse::checking_cancelled);
  const auto search = cheapest(steps.steps(), steps.formed(), state_->options.weights, progress);
  if (!search) return pass_on(search);
  CheckedOrder checked;
  checked.cost = search->cost;
  checked.turn_overs = search->turn_overs;
  checked.rotations = search->rotations;
  checked.tool_changes = search->tool_changes;
  checked.ungauged = search->ungauged;
  checked.v_away = search->v_away;
  std::vector<ChosenStroke> chosen;
  for (std::size_t i = 0; i < search->strokes.size(); ++i) {
    const OrderStep& step = steps.steps()[i];
    chosen.push_back({steps.standing(step.formed), search->strokes[i], step.blocked.has_value()});
  }
  Bed bed = bed_of(cache, chosen);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const LineSet& stage = chosen[i].formed;
    const StrokeChoice& choice = bed.choices[i];
    checked.strokes.push_back({describe(cache, stage, choice, bed.rows[i]),
                               steps.steps()[i].blocked, scene(cache, stage, choice, bed.rows[i])});
  }
  checked.stations = std::move(bed.stations);
  bed.count_more(state_->options.weights.tool_change, checked.tool_changes, checked.cost);
  return checked;
}

bool CheckedOrder::feasible() const {
  return std::ranges::none_of(strokes,
                              [](const CheckedStroke& s) { return s.blocked.has_value(); });
}

OrderedStroke ordered(const Stroke& stroke) {
  return {stroke.bends, stroke.press_line, stroke.flattening};
}

ToolSections tool_sections(const BrakeTools& tools) {
  ToolSections sections;
  for (const Punch& punch : tools.punches) {
    sections.punches.push_back(section_of(punch).outline);
    sections.feet.push_back(foot_of(punch).outline);
    if (!tools.machine.upper_beam.empty())
      sections.upper_beams.push_back(upper_beam_over(punch, tools.machine).outline);
  }
  sections.dies = mapped(tools.dies, [](const Die& die) { return section_of(die).outline; });
  if (!tools.machine.lower_beam.empty())
    sections.lower_beam = section_of(tools.machine.lower_beam).outline;
  return sections;
}

}  // namespace planish
