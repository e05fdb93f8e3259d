#pragma once

#include <planish/brep/step.hpp>
#include <planish/job/report.hpp>

#include <vector>

namespace planish::job {

/// Where the folded solid of the report's sheet runs through itself: findings with the code
/// "self_intersection", severity error, deepest first, one for each two parts that do, with the
/// depth in the message; places in the pattern alternate between the two parts. A sheet without
/// bends has none and costs nothing. If the solid cannot be tested, a warning "folded_solid" says
/// so. Requires sheet, layout and pattern of the report. `folded` is its sheet, as the body was
/// made from it or recognised in it.
std::vector<Finding> self_intersections(const Report& report, const Sheet& folded,
                                        const Body& body);

}  // namespace planish::job
