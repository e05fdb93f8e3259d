#pragma once

#include "outline.hpp"

#include <optional>

namespace planish::brep {

/// Depths at which much area of opposite faces agrees (within `tolerance`, a share), likeliest
/// first; at most three.
std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance);

/// Depths beyond the likeliest at which less agrees: that of the rim, where more of the sheet is
/// milled than left; thinnest first, at most three.
std::vector<double> milled_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance);

/// Depth of the nearest face opposite the largest plane: the thickness if the solid is a flat
/// plate.
std::optional<double> plate_thickness(const SolidModel& model,
                                      const std::vector<Outline>& outlines);

}  // namespace planish::brep
