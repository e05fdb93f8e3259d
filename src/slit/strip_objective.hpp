#pragma once

#include "bend_energy.hpp"

#include <Eigen/Core>

namespace planish::slit_detail {

/// What the load of a strip adds to its objective.
double load_part(const StripProblem& problem, const StripParameters& p);

/// The objective of a strip with derivatives by all parameters: of squares the second ones are
/// those of Gauss and Newton, to which `pulls` adds the rest.
SecondOrder objective_derivatives(const StripProblem& problem, const StripParameters& p);

/// In steps a fold by one radian and a ridge end moved by a mean spacing are alike.
Eigen::VectorXd units_of(const StripBase& base);

}  // namespace planish::slit_detail
