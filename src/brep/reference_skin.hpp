#pragma once

#include "skins.hpp"

namespace planish::brep {

/// The skin from which the pattern is drawn: the connected one, else the one with fewer outward
/// sharp folds (its borders need no setback), else the one with the wider outlines, else the one
/// with more material (its openings and rims are narrower).
Skin reference_skin(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins);

}  // namespace planish::brep
