#pragma once

#include "plate_plane.hpp"

#include <optional>

namespace planish::connect_detail {

/// Where two plates pass through each other: a point of both interiors, none where they do not.
std::optional<Vec3> intersection(const PlacedPlate& a, const PlacedPlate& b, double planarity);

}  // namespace planish::connect_detail
