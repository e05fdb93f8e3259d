#pragma once

#include "bend_energy.hpp"

#include <array>
#include <vector>

namespace planish::slit_detail {

/// The load of a strip as forces at the ends of its ridges, left and right. They do the same work
/// as the load does: areas count at their centroid.
using EndForces = std::array<std::vector<Vec3>, 2>;
EndForces end_forces(const StripBase& base, const StripFold& fold, const StripLoad& load);

/// Potential of the load of a problem for D = 1 N mm, from a level above which it is whatever the
/// shape; 0 without a load (math.md#standing). O(quads).
double load_potential(const StripProblem& problem, const StripParameters& p);

/// The same with derivatives. O(quads²).
SecondOrder load_potential_derivatives(const StripProblem& problem, const StripParameters& p);

}  // namespace planish::slit_detail
