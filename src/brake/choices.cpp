// The strokes that a stage offers, and those that may be offered at all. What must hold:
// `possible` covers `choices` of every stage, as the search's bound is made of it
// (StrokeProblem::possible).
#include "choices.hpp"

#include "gauge.hpp"
#include "one_line.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

LineSet set_of(const StrokeInputs& inputs, const std::vector<int>& lines) {
  LineSet set = no_lines(inputs.lines());
  for (const int line : lines)
    insert(set, line);
  return set;
}

/// A stroke on lines towards a direction, with each pair of tools that fits the first of them.
void add_pairs(const FittingTools& fitting, StrokeChoice choice, std::vector<StrokeChoice>& all) {
  for (const int punch : fitting.punches)
    for (const int die : fitting.dies) {
      choice.punch = punch;
      choice.die = die;
      all.push_back(choice);
    }
}

/// An edge for the gauge is looked for once: it does not depend on the tools.
bool is_gauged(StageCache& cache, const LineSet& formed, StrokeChoice choice, int first) {
  const StrokeInputs& inputs = cache.inputs();
  const FittingTools& fitting = inputs.fitting[first];
  if (inputs.work.lines[first].closes) return true;
  if (fitting.punches.empty() || fitting.dies.empty()) return true;
  choice.punch = fitting.punches.front();
  choice.die = fitting.dies.front();
  return gauge(cache, setting(inputs, formed, choice)).has_value();
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
    choice.gauged = is_gauged(cache, formed, choice, lines.front());
    add_pairs(inputs.fitting[lines.front()], choice, all);
  }
}

}  // namespace

std::vector<StrokeChoice> choices(StageCache& cache, const LineSet& formed) {
  std::vector<StrokeChoice> all;
  for (int line = 0; line < cache.inputs().lines(); ++line) {
    const auto& closes = cache.inputs().work.lines[line].closes;
    if (holds(formed, line) || (closes && !holds(formed, *closes))) continue;
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
    StrokeChoice choice;
    choice.lines = set_of(inputs, lines);
    choice.reference_up = inputs.work.lines[line].reference_up;
    for (const int other : lines)
      for (const int direction : {1, -1}) {
        choice.direction = direction_number(inputs, direction * inputs.work.lines[other].across());
        add_pairs(inputs.fitting[line], choice, all);
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
