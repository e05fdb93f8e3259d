#pragma once

#include "plate_plane.hpp"

#include <planish/connect/connect.hpp>

#include <optional>

namespace planish::connect_detail {

/// A place where two sheets run into each other, on the first one.
struct SheetsMeet {
  Vec3 at;
};

/// Whether plates in planes that cross, `thickness` thick with cut edges normal to the sheet, share
/// material: their sections across the intersection line are rectangles, of which two overlap.
/// Empty for parallel planes.
std::optional<SheetsMeet> sheets_meet(const PlacedPlate& a, const PlacedPlate& b,
                                      const BendFrame& frame, double thickness);

}  // namespace planish::connect_detail
