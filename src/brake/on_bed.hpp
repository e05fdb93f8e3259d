#pragma once

#include "station.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace planish::brake_detail {

using DemandPtr = std::shared_ptr<const Demand>;

/// A stroke to stand tools for.
class Wanted {
 public:
  /// With the tools that it was chosen with, in this stage.
  Wanted(StageCache& cache, ChosenStroke stroke, int number);
  /// As those ask for it, and no others.
  explicit Wanted(DemandPtr demand) : ways_{std::move(demand)} {}

  const DemandPtr& chosen() const { return ways_.front(); }
  /// With each pair of tools that makes the stroke and costs the same, the chosen one first; the
  /// others are looked for when first asked for.
  const std::vector<DemandPtr>& ways(StageCache& cache);

 private:
  std::optional<ChosenStroke> stroke_;  ///< whose other tools are not looked for yet
  std::vector<DemandPtr> ways_;
};
using WantedPtr = std::shared_ptr<Wanted>;

/// Strokes of one set-up: their tools stand on the bed at the same time.
struct OnBed {
  std::vector<WantedPtr> strokes;
  std::vector<StationTools> stations;  ///< from the left
};

/// Where stations begin on the bed, each as near to the one before as the workpieces and a
/// clearance allow; the last is where the bed must end.
std::vector<double> starts_of(const std::vector<StationTools>& stations, double clearance = 0.0);

/// The set-up with one stroke more, if need be with other tools that cost the same, for it or for
/// those before; empty if its tools find no room beside the others, or none at all on an empty bed.
std::optional<OnBed> with_stroke(StageCache& cache, const OnBed& before, WantedPtr stroke);

/// The same strokes with the same tools, laid with as few stations as is found, and of those ways
/// that with the fewest ears and the shortest rows.
OnBed with_least_to_lay(StageCache& cache, OnBed bed);

}  // namespace planish::brake_detail
