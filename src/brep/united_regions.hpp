#pragma once

#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish::brep {

/// A region of a plane, in its (u, v): the outer loop first, counter-clockwise, then openings.
using PlaneRegion = std::vector<BorderLoop>;

/// A part of a border of one of the regions, or all of it.
struct BorderPiece {
  Border border;  ///< its curve as the union's loop runs; without the edge's length unless whole
  int region = 0, loop = 0, place = 0;  ///< that it is from: regions[region][loop][place]
  bool whole = false;
};

/// The union of regions of one plane, as loops of pieces of their borders: the outer one first,
/// counter-clockwise. Borders that coincide count as those of the earlier region. Lines and arcs
/// are met to 1e-5 mm. Empty where the union is not one connected region, or the kernel fails; may
/// throw the kernel's exceptions: call it inside `guarded`.
std::optional<std::vector<std::vector<BorderPiece>>> united_regions(
    const std::vector<PlaneRegion>& regions);

}  // namespace planish::brep
