#pragma once

#include "rim.hpp"

namespace planish::brep {

/// Why the body has no flat pattern if a part that leaves the sheet is at its outer contour. The
/// cause shows in a face of the part that continues a skin: it is doubly curved (`doubly_curved`),
/// or the material below it has another thickness (`thickness_not_constant`). Else `not_a_sheet`.
/// `edges`: by face.
Error rim_refusal(const SolidModel& model, const std::vector<std::vector<int>>& edges,
                  const Skins& skins, const RimPart& part);

}  // namespace planish::brep
