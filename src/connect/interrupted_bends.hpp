#pragma once

#include "taken_edges.hpp"

namespace planish::connect_detail {

/// Adds the further stretches of interrupted bends, once every bend has its edges, to `fits` and
/// `taken`, and measures what is left of these. A bend whose stretches would run a plate's outline
/// over itself keeps its own band alone.
void add_stretches(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   TakenEdges& taken, std::vector<BendFit>& fits);

/// Measures how wide a bend joins its plates, and what it leaves of the edges on its tangent lines.
void measure_joint(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   const TakenEdges& taken, BendFit& fit);

/// Makes the stretches and further joints of bends fits of their own, after all others.
void append_stretches(Parts& parts);

}  // namespace planish::connect_detail
