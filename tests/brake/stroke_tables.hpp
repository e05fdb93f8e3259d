#pragma once

#include <planish/brake/stroke_search.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace planish::test {

using SetUpKey = std::tuple<int, int, bool, int>;

inline SetUpKey set_up_of(const StrokeChoice& choice) {
  if (choice.bed >= 0) return {-2, choice.bed, choice.reference_up, choice.direction};
  return {choice.punch, choice.die, choice.reference_up, choice.direction};
}

/// Made-up feasibility: for each stage of up to 16 lines, what can be pressed.
struct StrokeTable {
  int lines = 0;
  std::vector<std::vector<StrokeChoice>> by_stage;

  std::size_t stages() const { return by_stage.size(); }
  std::size_t full() const { return by_stage.size() - 1; }
};

inline double change_cost(const SetUpKey& a, const SetUpKey& b, const StrokeWeights& w) {
  const bool tools = std::get<0>(a) != std::get<0>(b) || std::get<1>(a) != std::get<1>(b);
  return (tools ? w.tool_change : 0.0) + (std::get<2>(a) != std::get<2>(b) ? w.turn_over : 0.0) +
         (std::get<3>(a) != std::get<3>(b) ? w.rotate : 0.0);
}

inline double stroke_cost(const StrokeChoice& choice, const StrokeWeights& w) {
  return w.stroke + (choice.gauged ? 0.0 : w.ungauged) + w.v * choice.v_away;
}

/// Cost of the cheapest plan, from the strokes of every stage and set-up; empty if there is none.
inline std::optional<double> cheapest_by_table(const StrokeTable& table, const StrokeWeights& w) {
  std::vector<std::map<SetUpKey, double>> least(table.stages());
  std::optional<double> best = table.lines == 0 ? std::optional(0.0) : std::nullopt;
  for (std::size_t stage = 0; stage < table.stages(); ++stage)
    for (const StrokeChoice& choice : table.by_stage[stage]) {
      const std::size_t after = stage | choice.lines[0];
      const SetUpKey key = set_up_of(choice);
      double cost = std::numeric_limits<double>::infinity();
      if (stage == 0) cost = stroke_cost(choice, w);
      for (const auto& [from, so_far] : least[stage])
        cost = std::min(cost, so_far + change_cost(from, key, w) + stroke_cost(choice, w));
      if (cost == std::numeric_limits<double>::infinity()) continue;
      const auto known = least[after].try_emplace(key, cost).first;
      known->second = std::min(known->second, cost);
      if (after == table.full() && (!best || cost < *best)) best = cost;
    }
  return best;
}

/// The same by writing out every order of strokes.
inline std::optional<double> cheapest_by_orders(const StrokeTable& table, const StrokeWeights& w,
                                                std::size_t stage = 0, double cost = 0.0,
                                                const SetUpKey* before = nullptr) {
  if (stage == table.full()) return cost;
  std::optional<double> best;
  for (const StrokeChoice& choice : table.by_stage[stage]) {
    const SetUpKey key = set_up_of(choice);
    const double so_far = cost + (before ? change_cost(*before, key, w) : 0.0) +
                          stroke_cost(choice, w);
    const auto found = cheapest_by_orders(table, w, stage | choice.lines[0], so_far, &key);
    if (found && (!best || *found < *best)) best = found;
  }
  return best;
}

/// Lines that no stage forms that can be reached.
inline std::vector<int> blocked_by_table(const StrokeTable& table) {
  std::vector<bool> reached(table.stages(), false);
  std::uint64_t formed = 0;
  reached[0] = true;
  for (std::size_t stage = 0; stage < table.stages(); ++stage)
    for (const StrokeChoice& choice : table.by_stage[stage])
      if (reached[stage]) {
        reached[stage | choice.lines[0]] = true;
        formed |= choice.lines[0];
      }
  std::vector<int> blocked;
  for (int line = 0; line < table.lines; ++line)
    if ((formed >> line & 1) == 0) blocked.push_back(line);
  return blocked;
}

}  // namespace planish::test
