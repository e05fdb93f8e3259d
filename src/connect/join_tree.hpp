#pragma once

#include "assemble.hpp"

#include <planish/base/progress.hpp>

namespace planish::connect_detail {

/// Fits every requested bend, in order; those with given edges first, so that others do not take
/// their edges. Errors: those of `connect`.
Result<std::vector<BendFit>> fit_requested(const PlateStructure& structure,
                                           const std::vector<PlacedPlate>& plates,
                                           const ConnectOptions& options, const Progress& progress);

/// Finds which plates to join into one sheet: those that touch where that is possible, then pairs
/// with the smallest ratio of span to width first, each edge used once (a minimum spanning tree).
/// Error: `no_bend_fits` if a plate remains unconnected.
Result<std::vector<BendFit>> fit_tree(const PlateStructure& structure,
                                      const std::vector<PlacedPlate>& plates,
                                      const std::vector<SharedEdge>& touching,
                                      const ConnectOptions& options, const Progress& progress);

}  // namespace planish::connect_detail
