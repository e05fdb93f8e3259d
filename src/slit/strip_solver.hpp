#pragma once

#include "descend.hpp"

#include <functional>
#include <vector>

namespace planish::slit_detail {

/// The planes that a shape breaks; empty where it breaks none.
using PlanesBroken = std::function<std::vector<HalfSpace>(const FoldedStrip&)>;

/// A strip solved, or as far as it came.
struct StripSolution {
  StripParameters p;
  std::vector<Inequality> inequalities;  ///< that were needed
  double objective = 0.0;
  int iterations = 0;
  bool reached = false;  ///< the end conditions are met
  bool converged = false;
};

/// Meets the end conditions from the shape the strip has, from a first shape where it has none
/// (empty) or where that one leads nowhere, and descends. Inequalities come in where the minimum
/// breaks them: planes as a growing penalty until the strip is clear of what it ran through, radii
/// as an augmented Lagrangian until they hold (`kHolds`); its multipliers are kept from
/// one call to the next in `problem.inequalities`. What is still broken after 10 rounds stays so; a
/// strip that would be creased to get clear is left as it was.
StripSolution solve_strip(StripProblem problem, const StripParameters& from,
                          const DescentOptions& options, const PlanesBroken& planes_broken);

}  // namespace planish::slit_detail
