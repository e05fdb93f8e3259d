#pragma once

#include "snapshot.hpp"

#include <planish/slit/equilibrium.hpp>

namespace planish::slit_detail {

/// What the strips of a snapshot bear, how they are held and whether they stay; nothing without a
/// material. Strips that have no shape yet bear nothing. O(strips × quads³).
std::optional<SlitEquilibrium> equilibrium_of(const Snapshot& now);

}  // namespace planish::slit_detail
