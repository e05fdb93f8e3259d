#pragma once

#include "plate_plane.hpp"

#include <optional>

namespace planish::connect_detail {

/// Where two plates pass through each other: a point of both interiors, none where they do not.
/// A place on the border of plate b that lies within the sheet of plate a, `thickness` thick,
/// though not where a bend could join them: behind a's outline, nearer than both sheets have room;
/// none where there is none.
struct TooNear {
  Vec3 at;
  double distance = 0.0, needed = 0.0;  ///< of the mid-surfaces, mm
};
std::optional<TooNear> too_near(const PlacedPlate& a, const PlacedPlate& b, double thickness);

std::optional<Vec3> intersection(const PlacedPlate& a, const PlacedPlate& b, double planarity);

}  // namespace planish::connect_detail
