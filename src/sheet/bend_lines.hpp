#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::sheet_detail {

/// The bends of the flat pattern, lines clipped to the material, in order of BendId.
std::vector<FlatBend> flat_bends(const Sheet& sheet, const Layout& layout);

}  // namespace planish::sheet_detail
