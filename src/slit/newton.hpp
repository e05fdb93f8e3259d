#pragma once

#include "descend.hpp"
#include "strip_system.hpp"

namespace planish::slit_detail {

/// The best shapes so far.
struct SystemDescent {
  Shapes shapes;
  double objective = 0.0;
  int iterations = 0;
  bool converged = false;
};

/// Lowers the sum of the strips' objectives with bending energy, and the penalty of contacts, among
/// shapes that meet the end conditions, by Newton's method within a reach: exact second derivatives
/// of the energy, the conditions and what draws at ridge ends. Quadratic near the minimum;
/// O(strips × quads³) for a step.
SystemDescent descend_by_newton(const StripSystem& system, Shapes from,
                                const DescentOptions& options);

/// The same of a strip by itself.
Descent descend_by_newton(const StripProblem& problem, const StripParameters& from,
                          const DescentOptions& options);

}  // namespace planish::slit_detail
