#pragma once

#include "station.hpp"

#include <planish/brake/plan.hpp>

#include <optional>
#include <vector>

namespace planish::brake_detail {

/// How the tools of all strokes stand.
struct Bed {
  std::vector<Station> stations;               ///< by set-up, from the left
  std::vector<StrokeChoice> choices;           ///< by stroke, with the tools that stand there
  std::vector<std::optional<PressRows>> rows;  ///< by stroke, along its line; empty if blocked
  int set_ups = 0;

  /// Counts the set-ups beyond the changes that a search counted, for want of segments or length of
  /// the press, among the changes and in the cost; whether there are any.
  bool count_more(double weight, int& tool_changes, double& cost) const;
};

/// Stands the tools of strokes on the bed, in as few set-ups as this order of strokes allows: each
/// takes as many as find room with the segments that there are, if need be those of other tools
/// that make the stroke and cost the same (math.md#stations).
Bed bed_of(StageCache& cache, const std::vector<ChosenStroke>& strokes);

}  // namespace planish::brake_detail
