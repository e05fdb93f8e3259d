#pragma once

#include "plate_plane.hpp"

#include <optional>
#include <vector>

namespace planish::connect_detail {

/// A strip along an edge, from one distance from its start to another, that is cut off.
struct CutStrip {
  double from = 0.0, to = 0.0, depth = 0.0;
};

/// What is cut off along an edge, and at the corner at its start: so far along both edges, straight
/// between these places, or square to the edges.
struct EdgeCut {
  std::vector<CutStrip> strips;
  double corner = 0.0, square = 0.0;
};

/// By ring of a plate (none of holes that are no polygons), by corner.
using PlateCuts = std::vector<std::vector<EdgeCut>>;

/// Cuts a plate's outline and holes back, by edge. Beside a strip that ends inside its edge, or at
/// a corner that turns inwards, a relief is cut, `relief` wide and half of that deeper; where less
/// than that would remain, to the end. The edge along the first strip keeps the number of the edge,
/// new ones are numbered on. Returns the largest depth; empty if nothing is cut, or the plate would
/// not remain whole, which then stays as it is.
std::optional<double> cut_back(PlacedPlate& plate, const PlateCuts& cuts, double relief);

}  // namespace planish::connect_detail
