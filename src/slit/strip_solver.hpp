#pragma once

#include "descend.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace planish::slit_detail {

/// The planes that a shape violates; empty if none.
using PlanesBroken = std::function<std::vector<HalfSpace>(const FoldedStrip&)>;

/// A solved strip, or the best shape reached.
struct StripSolution {
  StripParameters p;
  std::vector<Inequality> inequalities;  ///< that were needed
  double objective = 0.0;
  std::optional<double> runner_up = {};  ///< energy of the next best of several first shapes
  int iterations = 0;
  bool reached = false;  ///< the end conditions are met
  bool converged = false;
};

/// Meets the end conditions from the strip's present shape, or from a first shape if it has none
/// (empty) or that fails, and descends. Inequalities are added if the minimum violates them: planes
/// as a growing penalty until the strip is clear of its neighbours, radii as an augmented
/// Lagrangian until they hold (`kHolds`); its multipliers are kept from
/// one call to the next in `problem.inequalities`. Inequalities still violated after 10 rounds stay
/// so; a strip that would be creased to get clear is left unchanged.
StripSolution solve_strip(StripProblem problem, const StripParameters& from,
                          const DescentOptions& options, const PlanesBroken& planes_broken);

}  // namespace planish::slit_detail
