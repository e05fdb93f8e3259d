#pragma once

#include "unfolding_tree.hpp"

namespace planish {

/// The bends of the flat pattern, lines clipped to the material, in order of BendId.
std::vector<FlatBend> flat_bends(const Sheet& sheet, const UnfoldingTree& tree);

}  // namespace planish
