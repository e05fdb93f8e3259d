#pragma once

#include "strip_problem.hpp"

#include <planish/slit/session.hpp>

#include <functional>

namespace planish::slit_detail {

struct DescentOptions {
  int max_iterations = 200;
  double function_tolerance = SlitSolveOptions{}.function_tolerance;  ///< gain of an iteration, as
                                                                      ///< a share, at which it is
                                                                      ///< done
  std::function<bool()> stop = {};  ///< asked after every iteration
};

/// The best shape so far.
struct Descent {
  StripParameters p;
  double objective = 0.0;
  int iterations = 0;
  bool converged = false;
};

/// What a descent lowers; infinite where there is no shape.
double whole_objective(const StripProblem& problem, const StripParameters& p);

/// Lowers the objective from a shape that meets the end conditions, among shapes that meet them:
/// the energy by Newton's method (newton.hpp), smoothness by Levenberg–Marquardt steps (Ceres) on
/// the manifold of those shapes.
Descent descend(const StripProblem& problem, const StripParameters& from,
                const DescentOptions& options);

}  // namespace planish::slit_detail
