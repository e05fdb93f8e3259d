#pragma once

#include <planish/connect/plates.hpp>

#include <functional>

namespace planish::pairs {

/// Calls `tried` with one way after another in which a person could ask for the bend between both
/// plates: by a trade-off; or by edges (any one of each plate, any two neighbours), a lateral
/// boundary and a surface or radius. Ends when it returns true; says whether it did.
bool any_choice(const PlateStructure& pair, const std::function<bool(const BendRequest&)>& tried);

}  // namespace planish::pairs
