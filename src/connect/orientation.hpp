#pragma once

#include "parts.hpp"

#include <vector>

namespace planish::connect_detail {

/// Which side of each plate and bend is on the reference skin.
struct Orientation {
  std::vector<int> plates;  ///< +1: outwards is the plate's normal, −1: the opposite
  std::vector<int> bends;  ///< +1: outwards is the normal of the bend's surface, −1: the opposite
};

/// Starts at the root, whose normal points outwards. Bends without plates have +1.
Orientation orientation_of(const Parts& parts);

/// Whether all bends agree: a loop of them may turn the sheet over, as a Möbius strip is.
bool has_two_sides(const Parts& parts);

}  // namespace planish::connect_detail
