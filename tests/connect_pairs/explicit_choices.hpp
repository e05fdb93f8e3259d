#pragma once

#include <planish/connect/plates.hpp>

#include <functional>
#include <vector>

namespace planish::pairs {

/// Calls `tried` with one way after another in which a person could ask for the bend between both
/// plates: edges (any one of each plate, any two neighbours, or none named), lateral boundaries,
/// trade-offs, surfaces and radii. Ends when it returns true; says whether it did.
bool any_choice(const PlateStructure& pair, const std::function<bool(const BendRequest&)>& tried);

}  // namespace planish::pairs
