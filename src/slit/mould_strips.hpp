#pragma once

#include "mould_clear.hpp"

#include <planish/slit/folded_slit_sheet.hpp>

#include <vector>

namespace planish::slit_detail {

/// By strip, whole or both halves where these do not meet. `sign`: of the sheet's normal towards
/// the mould. With `under_panels`, the direction in which the sheet is lifted off, panels that are
/// not upright in it add their facets at the strips' ends.
std::vector<std::vector<WholeStrip>> mould_strips(const FoldedSlitSheet& folded, double sign,
                                                  const Vec3* under_panels);

}  // namespace planish::slit_detail
