#pragma once

#include "strip_problem.hpp"

#include <vector>

namespace planish::slit_detail {

/// Shapes to start from, the best first, the flat one last: bent in one plane, perpendicular to the
/// panel's facet, so that they approximately meet their end conditions. From a family of such
/// curves those of least objective (smoothness, the end's place, the seat curve) are taken. Ridges
/// are equally spaced and perpendicular to the long edges.
std::vector<StripParameters> first_shapes(const StripProblem& problem);

}  // namespace planish::slit_detail
