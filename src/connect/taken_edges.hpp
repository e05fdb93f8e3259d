#pragma once

#include "parts.hpp"

#include <planish/connect/plates.hpp>

namespace planish::connect_detail {

using TakenEdges = std::vector<UsedEdges>;  // by plate

/// Marks the edges of a bend, or of a further stretch of it, as used.
void take(const BendFit& fit, const std::vector<PlacedPlate>& plates, TakenEdges& taken);
void take(const BendBand& band, const std::vector<int>& rows,
          const std::vector<PlacedPlate>& plates, TakenEdges& taken);

/// What all bends use, but one.
TakenEdges taken_by(const Parts& parts, const BendFit* but = nullptr);

/// The task of a bend between the plates in `rows`.
FitTask task_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                const TakenEdges& taken, const std::vector<int>& rows, const BendRequest& request);

/// The plates, with room for so many bends.
Parts parts_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
               std::size_t bends);

}  // namespace planish::connect_detail
