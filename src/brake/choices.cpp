// The strokes that a stage offers, and those that may be offered at all. What must hold:
// `possible` covers `choices` of every stage, as the search's bound is made of it
// (StrokeProblem::possible).
#include "choices.hpp"

#include "gauge.hpp"
#include "one_line.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace planish::brake_detail {
namespace {

LineSet set_of(const StrokeInputs& inputs, const std::vector<int>& lines) {
  LineSet set = no_lines(inputs.lines());
  for (const int line : lines)
    insert(set, line);
  return set;
}

/// kN over a die that these lines take together (math.md#tool-fit).
double force_on(const StrokeInputs& inputs, const LineSet& lines, int die) {
  double force = 0.0;
  for (const int line : members(lines))
    force += force_of(inputs.work.lines[line], inputs.tools.dies[die], inputs.options);
  return force;
}

StrokeChoice with_tools(const StrokeInputs& inputs, StrokeChoice choice, const ToolPair& pair) {
  choice.punch = pair.punch;
  choice.die = pair.die;
  choice.bed = inputs.beds[pair.punch][pair.die];
  choice.v_away = pair.v_away;
  return choice;
}

/// A stroke on lines towards a direction, with each pair of tools that fits one of them and that
/// the press can bring down on all. A hem that is closed counts as gauged.
void add_pairs(StageCache& cache, const LineSet& formed, const FittingTools& fitting,
               StrokeChoice choice, std::vector<StrokeChoice>& all) {
  const StrokeInputs& inputs = cache.inputs();
  const Setting stroke = setting(inputs, formed, choice);
  const bool closes = inputs.work.lines[stroke.line].closes.has_value();
  GaugeStops stops(cache, stroke);
  const bool alone = count(choice.lines) == 1;  // its pairs were held against the press
  for (const ToolPair& pair : fitting.pairs) {
    if (!alone && force_on(inputs, choice.lines, pair.die) > inputs.tools.machine.force) continue;
    choice.gauged = closes || stops.touch(pair.punch, pair.die);
    all.push_back(with_tools(inputs, choice, pair));
  }
}

/// Each pair of tools that fits one of these lines, which are bent alike.
std::vector<ToolPair> pairs_of_any(const StrokeInputs& inputs, const std::vector<int>& lines) {
  std::vector<ToolPair> pairs;
  for (const int line : lines)
    for (const ToolPair& pair : inputs.fitting[line].pairs)
      if (!std::ranges::count(pairs, pair)) pairs.push_back(pair);
  return pairs;
}

void add_strokes_on(StageCache& cache, const LineSet& formed, const std::vector<int>& lines,
                    std::vector<StrokeChoice>& all) {
  const StrokeInputs& inputs = cache.inputs();
  const BrakeLine& first = inputs.work.lines[lines.front()];
  StrokeChoice choice;
  choice.lines = set_of(inputs, lines);
  choice.reference_up = first.reference_up;
  for (const int direction : {1, -1}) {
    choice.direction = direction_number(inputs, direction * first.across());
    add_pairs(cache, formed, inputs.fitting[lines.front()], choice, all);
  }
}

/// The bumps of a bend are pressed one after the other, from either end, before anything else is.
/// Those of an only bend may be pressed from both ends in turn, the middle last, which some bends
/// of large angle need.
class BumpOrder {
 public:
  BumpOrder(const Workpiece& work, const LineSet& formed) : work_(work), formed_(formed) {
    std::map<BendId, int> left;
    for (int line = 0; line < std::ssize(work.lines); ++line)
      if (is_bump(line)) ++(holds(formed, line) ? done_ : left)[bend_of(line)];
    for (const auto& [bend, done] : done_)
      if (left.contains(bend)) begun_ = bend;
    left.insert(done_.begin(), done_.end());
    is_only_ = left.size() == 1;
  }

  bool allows(int line) const {
    if (!is_bump(line)) return !begun_;
    const BendId bend = bend_of(line);
    if (begun_ && *begun_ != bend) return false;
    return is_next_from(line, -1) || is_next_from(line, 1);
  }

 private:
  bool is_bump(int line) const { return work_.lines[line].bump_pitch.has_value(); }
  BendId bend_of(int line) const { return work_.lines[line].bends.front(); }

  /// Whether all bumps of the bend on one side of this one are formed, and of several bumped bends
  /// no other of its bumps.
  bool is_next_from(int line, int side) const {
    int beyond = 0;
    for (int other = 0; other < std::ssize(work_.lines); ++other) {
      const bool is_beyond = is_bump(other) && bend_of(other) == bend_of(line) &&
                             side * (*work_.lines[other].press_line -
                                     *work_.lines[line].press_line) >
                                 0;
      if (is_beyond && !holds(formed_, other)) return false;
      beyond += is_beyond ? 1 : 0;
    }
    const auto done = done_.find(bend_of(line));
    return is_only_ || beyond == (done == done_.end() ? 0 : done->second);
  }

  const Workpiece& work_;
  const LineSet& formed_;
  std::map<BendId, int> done_;  ///< bumps of each bend
  bool is_only_ = false;
  std::optional<BendId> begun_ = {};
};

}  // namespace

std::vector<StrokeChoice> choices(StageCache& cache, const LineSet& formed) {
  std::vector<StrokeChoice> all;
  const BumpOrder bumps(cache.inputs().work, formed);
  for (int line = 0; line < cache.inputs().lines(); ++line) {
    const auto& closes = cache.inputs().work.lines[line].closes;
    if (holds(formed, line) || (closes && !holds(formed, *closes)) || !bumps.allows(line)) continue;
    const std::vector<int> lines = together(cache, line, formed);
    if (lines.front() == line) add_strokes_on(cache, formed, lines, all);
    if (lines.size() > 1) add_strokes_on(cache, formed, {line}, all);
  }
  return all;
}

/// Only lines that continue each other in the pattern are ever pressed together.
std::vector<StrokeChoice> possible(const StrokeInputs& inputs) {
  std::vector<StrokeChoice> all;
  for (int line = 0; line < inputs.lines(); ++line) {
    const std::vector<int>& lines = inputs.on_one_line[line];
    if (lines.front() != line) continue;
    const std::vector<ToolPair> pairs = pairs_of_any(inputs, lines);
    StrokeChoice choice;
    choice.lines = set_of(inputs, lines);
    choice.reference_up = inputs.work.lines[line].reference_up;
    for (const int other : lines)
      for (const int direction : {1, -1}) {
        choice.direction = direction_number(inputs, direction * inputs.work.lines[other].across());
        for (const ToolPair& pair : pairs)
          all.push_back(with_tools(inputs, choice, pair));
      }
  }
  return all;
}

bool is_outermost(StageCache& cache, const LineSet& formed, const StrokeChoice& choice) {
  const LineSet done = joined(formed, choice.lines);
  return std::ranges::all_of(members(choice.lines), [&](int line) {
    const auto& beyond = cache.beyond(line);
    return within(beyond[0], done) || within(beyond[1], done);
  });
}

}  // namespace planish::brake_detail
