#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>

namespace planish::transitions {

/// A transition file between two random convex profiles in planes that may be inclined and offset,
/// of a sheet of 0.05 to 6 mm. Every one can be made: each profile lies on one side of the other's
/// plane.
nlohmann::json random_transition(std::uint64_t seed, int index);

/// Length of a profile, by its closed form; empty where it has none.
std::optional<double> perimeter_of(const nlohmann::json& profile);

/// Area of the surface between two polygons: that of the sides of their convex hull, by looking at
/// every three corners. Empty if a profile is no polygon.
std::optional<double> area_between(const nlohmann::json& transition);

}  // namespace planish::transitions
