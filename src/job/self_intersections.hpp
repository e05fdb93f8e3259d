#pragma once

#include "lay_flat.hpp"

#include <planish/job/report.hpp>

#include <vector>

namespace planish::job {

/// Where the folded solid of the report's sheet runs through itself: findings with the code
/// "self_intersection", severity error, deepest first, one for each two parts that do, with the
/// depth in the message; places in the pattern alternate between the two parts. A sheet without
/// bends has none and costs nothing. If the solid cannot be tested, a warning "folded_solid" says
/// so. What shares space along a seam only is one finding "seam_edges", severity info. Requires
/// sheet, layout and pattern of the report; the body is made from its sheet or recognised as it.
std::vector<Finding> self_intersections(const Report& report, const FoldedBody& folded);

}  // namespace planish::job
