#pragma once

#include "rim.hpp"

#include <set>

namespace planish::brep {

/// Why the body has no flat pattern if a part that leaves the sheet is at its outer contour. The
/// cause shows in a face of the part that continues a skin: it is doubly curved (`doubly_curved`),
/// or the material below it has another thickness (`thickness_not_constant`). Else `not_a_sheet`,
/// at the face that lies farthest outside. `edges`: by face; `outside`: those of the part that
/// leave the sheet.
Error rim_refusal(const SolidModel& model, const std::vector<std::vector<int>>& edges,
                  const Skins& skins, const RimPart& part, const std::set<int>& outside);

}  // namespace planish::brep
