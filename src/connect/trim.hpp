#pragma once

#include "plate_plane.hpp"

#include <planish/connect/connect.hpp>

#include <array>
#include <vector>

namespace planish::connect_detail {

/// A plate that leaves no room for the bend along an edge that it shares with another one.
struct NarrowPlate {
  int plate = 0, other = 0;
  double width = 0.0, needed = 0.0;  ///< square to the edge, mm
  double inside_radius = 0.0;        ///< of the bend
};

/// Plates cut back where they touch, so that bends fit between them (math.md#trimming).
struct Trimmed {
  std::vector<PlacedPlate> plates;
  std::vector<TrimmedPlate> cut = {};   ///< those that were
  std::vector<SharedEdge> shared = {};  ///< stretches of edges that two plates have in common
  std::vector<NarrowPlate> narrow = {};
  bool all_touch = false;  ///< directly or through others
};

/// Cuts plates back along the edges that they share, by what a bend of the wanted inside radius
/// needs (by default the thickness), and at corners that they share. What a bend would have to be
/// placed on keeps its number; edges that come of it are numbered on from the plate's last. A plate
/// that would not remain whole stays as it is. Edges of folds (inside radius 0) stay, and the
/// joints beside them open.
Trimmed trimmed_where_touching(const PlateStructure& structure, std::vector<PlacedPlate> plates);

}  // namespace planish::connect_detail
