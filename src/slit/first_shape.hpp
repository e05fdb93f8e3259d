#pragma once

#include "strip_problem.hpp"

namespace planish::slit_detail {

/// A shape to start from: bent in one plane, perpendicular to the panel's facet, so that it runs about as far as it
/// must and ends as it must. Of a family of such curves the one of least objective is taken (smoothness, the end's
/// place, the seat curve). Ridges are equally spaced and perpendicular to the sides.
StripParameters first_shape(const StripProblem& problem);

}  // namespace planish::slit_detail
