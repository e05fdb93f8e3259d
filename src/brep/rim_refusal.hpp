#pragma once

#include "rim.hpp"

namespace planish::brep {

/// Why a part that leaves the sheet has no flat pattern at its outer contour. A face of the part
/// that continues a skin tells what went wrong there: it is curved two ways (`doubly_curved`), or
/// the material below it is not as thick (`thickness_not_constant`). Else `not_a_sheet`. `edges`:
/// by face.
Error rim_refusal(const SolidModel& model, const std::vector<std::vector<int>>& edges,
                  const Skins& skins, const RimPart& part);

}  // namespace planish::brep
