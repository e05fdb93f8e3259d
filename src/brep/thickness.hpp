#pragma once

#include "outline.hpp"

namespace planish::brep {

/// Depths at which much area of opposite faces agrees (within `tolerance`, a share), likeliest
/// first; at most three.
std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance);

}  // namespace planish::brep
