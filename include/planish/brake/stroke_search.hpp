#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace planish {

/// The lines that are formed in a stage, or pressed in a stroke: bit i is line i. As many words as
/// the lines need.
using LineSet = std::vector<std::uint64_t>;

/// A way in which a stroke can be made in a stage. Numbers are the caller's: equal means the same.
struct StrokeChoice {
  LineSet lines;  ///< pressed together, none formed before
  int punch = 0;
  int die = 0;
  bool reference_up = true;  ///< the side of the lying sheet that faces up
  int direction = 0;         ///< of the pattern, towards the gauge
  bool gauged = true;
  int v_away = 0;  ///< sizes of the catalogue between its V and the wanted one
  /// Tools with equal numbers can stand on the bed together, so that going from one to the other is
  /// no change. Below 0: with no others.
  int bed = -1;
};

/// Costs, at least 0 each: of a stroke; of a stroke without gauge, besides; of turning the sheet
/// over, of rotating it and of changing the set-up of tools between two strokes; of each size by
/// which the V of a stroke differs from the wanted one.
struct StrokeWeights {
  double turn_over = 3.0, rotate = 2.0, tool_change = 5.0, stroke = 1.0, ungauged = 4.0, v = 1.0;

  /// Of a stroke by itself, without what is changed before it.
  double of(const StrokeChoice& choice) const {
    return stroke + (choice.gauged ? 0.0 : ungauged) + v * choice.v_away;
  }
};

/// Where a search ends although more could be found: after so much work, the same everywhere,
/// and after a time, whatever it did, as a guard.
struct StrokeLimits {
  bool first = false;             ///< at the first plan
  bool reasons = true;            ///< if there is none: find out which lines cannot be formed
  std::int64_t stages = 300'000;  ///< looked at
  std::int64_t checks = 20'000;   ///< of a tool in a stroke, as `StrokeProblem::checks` counts
  double seconds = 60.0;          ///< of all, with the reasons
  /// When it ends in any case, with all that it is a part of.
  std::chrono::steady_clock::time_point until = std::chrono::steady_clock::time_point::max();

  /// When the time is over of what starts then.
  std::chrono::steady_clock::time_point end(std::chrono::steady_clock::time_point start) const;
};

/// Whether a stroke can be made.
struct StrokeVerdict {
  bool feasible = true;
  /// Of one that cannot: the lines by which this is so. In every other stage in which these are
  /// formed or not as in this one, the same choice, gauged or not, is infeasible too. No line at
  /// all (every bit 0): it is infeasible in every stage. Empty: nothing is known of other stages.
  std::optional<LineSet> because = {};
};

/// What a search asks. Each stage and each choice in a stage is asked for once at most, and only
/// stages that can be reached; once more those that lack one stroke.
struct StrokeProblem {
  int lines = 0;
  /// All strokes that may be made in a stage; quick. Several may press the same lines.
  std::function<std::vector<StrokeChoice>(const LineSet& formed)> choices;
  /// Whether one of them can be made; slow. Empty: each can.
  std::function<StrokeVerdict(const LineSet& formed, const StrokeChoice& choice)> check = {};
  /// How much work `check` has done so far, of whatever is counted. Empty: nothing is counted.
  std::function<std::int64_t()> checks = {};
  /// Covers what `choices` gives in any stage: for each choice there is one here with the same
  /// tools, side and direction, that is gauged if the choice is, and that presses its lines and
  /// perhaps more. The narrower, the sooner a plan is proven cheapest. Empty: nothing is known.
  std::vector<StrokeChoice> possible = {};
  /// How far inside the part each line is. Parts are mostly bent from the outside in, so this is
  /// one order in which plans are looked for; it does not change what is found in the end. May be
  /// empty.
  std::vector<int> depth = {};
  /// Lines to be pressed before all others, in this order; what is pressed together with one of
  /// them does not matter.
  std::vector<int> begin_with = {};
};

enum class PlanStatus {
  optimal,     ///< there is no cheaper plan
  feasible,    ///< a limit ended the search: there may be a cheaper plan
  infeasible,  ///< no order of strokes forms all lines
  gave_up,     ///< a limit ended the search before a plan was found or shown not to exist
};

struct StrokeSearch {
  PlanStatus status = PlanStatus::gave_up;
  std::vector<StrokeChoice> strokes;  ///< the cheapest found; empty if none was
  double cost = 0.0;
  double bound = 0.0;  ///< no plan costs less
  int turn_overs = 0, rotations = 0, tool_changes = 0, ungauged = 0;
  int v_away = 0;           ///< of all strokes together
  std::int64_t stages = 0;  ///< looked at
  bool timed_out = false;   ///< the time ended it or the reasons, not the work: next time it may
                            ///< end otherwise
  /// If infeasible: lines that no reachable stage can form. `blocked_all`: these are all such
  /// lines; else it was not looked at every stage once this was proven, and there may be more.
  std::vector<int> blocked = {};
  bool blocked_all = true;
  bool none_last = false;  ///< if infeasible: since no stroke can be made after all others
  LineSet furthest = {};   ///< if there is no plan: the stage with the most lines formed
};

/// Finds the cheapest sequence of strokes that forms every line: A* over stages, each with the last
/// tools, side and direction, after a depth-first search for any plan. The bound is exact where
/// strokes never exclude each other, so such problems of any size end at once; at worst all 2^lines
/// stages are looked at. The first stroke costs no change. Errors: `cancelled`.
Result<StrokeSearch> search_strokes(const StrokeProblem& problem, const StrokeWeights& weights = {},
                                    const StrokeLimits& limits = {}, const Progress& progress = {});

}  // namespace planish
