#pragma once

#include "descend.hpp"

#include <functional>
#include <vector>

namespace planish::slit_detail {

/// Planes that a shape breaks and must not; none where it breaks none.
using PlanesBroken = std::function<std::vector<HalfSpace>(const FoldedStrip&)>;

/// A strip solved, or as far as it came.
struct StripSolution {
  StripParameters p;
  std::vector<Inequality> inequalities;  ///< that were needed
  double objective = 0.0;
  int iterations = 0;
  bool reached = false;    ///< the end conditions are met
  bool converged = false;
};

/// Where to start: from the shape the strip has (empty: none yet), else from a first shape or from a neighbour's (may
/// be empty), whichever leads lower.
struct StripStart {
  StripParameters own, neighbour;
};

/// Meets the end conditions, then descends. Inequalities come in where the minimum breaks them, as an augmented Lagrangian whose
/// multipliers are kept from one call to the next in `problem.inequalities`; they hold to 1e-7 of the strip's length or of
/// a spacing, or stay broken after 12 rounds.
StripSolution solve_strip(StripProblem problem, const StripStart& start, const DescentOptions& options, const PlanesBroken& planes_broken);

}  // namespace planish::slit_detail
