#pragma once

#include "skins.hpp"

namespace planish::brep {

/// The skin that the pattern is drawn from: the one in one piece, then the one folded sharply
/// outwards least (its borders need no setting back), then the one with more material (openings and
/// rims are narrower there).
Skin reference_skin(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins);

}  // namespace planish::brep
