#pragma once

#include "plate_plane.hpp"

#include <optional>

namespace planish::connect_detail {

/// A place on the border of plate b that lies within the sheet of plate a, `thickness` thick, but
/// not near a's outline, where a bend could join them.
struct TooNear {
  Vec3 at;
  double distance = 0.0, needed = 0.0;  ///< of the mid-surfaces, mm
};
/// The first such place; empty if both sheets have room.
std::optional<TooNear> too_near(const PlacedPlate& a, const PlacedPlate& b, double thickness);

/// A point of both interiors, where two plates pass through each other.
std::optional<Vec3> intersection(const PlacedPlate& a, const PlacedPlate& b, double planarity);

}  // namespace planish::connect_detail
