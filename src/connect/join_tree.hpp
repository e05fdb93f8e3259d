#pragma once

#include "assemble.hpp"

#include <planish/base/progress.hpp>

namespace planish::connect_detail {

/// Fits every bend that is asked for, in order; those with edges given first, so that others leave
/// them alone. Errors: those of `connect`.
Result<std::vector<BendFit>> fit_requested(const PlateStructure& structure,
                                           const std::vector<PlacedPlate>& plates,
                                           const ConnectOptions& options, const Progress& progress);

/// Finds which plates to join, so that all become one: the pairs with the smallest span for their
/// width first, each edge used once (a minimum spanning tree). Error: `no_bend_fits` when a plate
/// stays alone.
Result<std::vector<BendFit>> fit_tree(const PlateStructure& structure,
                                      const std::vector<PlacedPlate>& plates,
                                      const ConnectOptions& options, const Progress& progress);

}  // namespace planish::connect_detail
