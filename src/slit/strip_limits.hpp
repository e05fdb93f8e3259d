#pragma once

#include "strip_problem.hpp"

#include <vector>

namespace planish::slit_detail {

/// Radii are solved for this much more than needed, so that they hold.
constexpr double kRadiusMargin = 2e-4;

/// Whether a fold is tighter than allowed. `problem.min_radius` is that with the margin.
bool is_too_tight(const StripProblem& problem, const StripParameters& p);

/// The inequalities of a problem, with planes and the radii that a shape violates. Known ones keep
/// their multipliers.
std::vector<Inequality> with_broken(const StripProblem& problem, const StripParameters& p,
                                    const std::vector<HalfSpace>& planes);

/// Whether all that must hold exactly does (`kHolds`).
bool firm_ones_hold(const StripProblem& problem, const StripParameters& p);

/// Whether a loaded strip lies on the ground that carries it: multipliers that are too large lift
/// it off.
bool load_rests(const StripProblem& problem, const StripParameters& p);

/// The inequalities of a problem for the next round of an augmented Lagrangian.
std::vector<Inequality> with_new_multipliers(const StripProblem& problem, const StripParameters& p);

}  // namespace planish::slit_detail
