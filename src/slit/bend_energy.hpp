#pragma once

#include "strip_problem.hpp"

#include <Eigen/Core>

namespace planish::slit_detail {

/// A value with first and second derivatives by all parameters of a strip.
struct SecondOrder {
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;  ///< symmetric
};

/// Bending energy of a strip for D = 1 N mm, in N mm (math.md#bending-energy), with the fold into
/// the panel at its end. O(quads).
double bend_energy(const StripProblem& problem, const StripParameters& p);

/// The same with derivatives. O(quads²) with a panel at the end, else O(quads).
SecondOrder bend_energy_derivatives(const StripProblem& problem, const StripParameters& p);

/// Largest curvature of a strip in absolute value, 1/mm: of the material that a fold stands for, at
/// the end of its ridge where that is narrower.
double largest_curvature(const StripProblem& problem, const StripParameters& p);

/// Moment of the panel at the end on the strip, through the fold into it, N mm for D = 1 N mm.
Vec3 far_moment(const StripProblem& problem, const StripParameters& p);

/// By which the energy is multiplied in the objective: there it counts for a strip as long as it is
/// wide, so that neither size nor material matters to the shape, and weighs as the wishes do.
double energy_scale(const StripBase& base);

}  // namespace planish::slit_detail
