#pragma once

#include "station.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace planish::brake_detail {

/// Strokes of one set-up: their tools stand on the bed at the same time.
struct OnBed {
  std::vector<std::shared_ptr<const Demand>> strokes;
  std::vector<StationTools> stations;  ///< from the left
};

/// Where stations begin on the bed, each as near to the one before as the workpieces allow; the
/// last is where the bed must end.
std::vector<double> starts_of(const std::vector<StationTools>& stations);

/// The set-up with one stroke more; empty if its tools find no room beside the others, or none at
/// all on an empty bed.
std::optional<OnBed> with_stroke(StageCache& cache, const OnBed& before,
                                 std::shared_ptr<const Demand> demand);

/// The same, if need be with other tools that make the stroke and cost the same; `stroke` is then
/// given these.
std::optional<OnBed> with_any_tools(StageCache& cache, const OnBed& before, ChosenStroke& stroke,
                                    std::shared_ptr<const Demand> demand);

}  // namespace planish::brake_detail
