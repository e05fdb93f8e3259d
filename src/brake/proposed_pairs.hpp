#pragma once

#include "proposing.hpp"

namespace planish::brake_detail {

/// Two changes of tools where one does not do: segments of a common set, or a punch that the shop
/// might get, and the least second change beside it. The first that helps ends it.
void try_pairs(Trying& trying);

}  // namespace planish::brake_detail
