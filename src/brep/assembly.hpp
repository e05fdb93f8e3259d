#pragma once

#include "grouping.hpp"
#include "rim.hpp"

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// Builds the Sheet whose reference skin is `side`: faces, joints, flanges, bends, features. Borders
/// are read within `tolerance` (mm). Errors: `doubly_curved` when two faces meet tangentially along a
/// curve (no development keeps both).
Result<Sheet> assemble_sheet(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins,
                             const Rim& rim, const Groups& groups, Side side, double tolerance);

}  // namespace planish::brep
