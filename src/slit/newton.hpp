#pragma once

#include "descend.hpp"

namespace planish::slit_detail {

/// Lowers the objective with bending energy among shapes that meet the end conditions, by Newton's
/// method within a reach: exact second derivatives of the energy, the conditions and what draws at
/// ridge ends. Quadratic near the minimum; O(quads³) for a step.
Descent descend_by_newton(const StripProblem& problem, const StripParameters& from,
                          const DescentOptions& options);

}  // namespace planish::slit_detail
