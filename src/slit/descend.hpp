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

/// Lowers the objective from a shape that meets the end conditions, among shapes that meet them:
/// Levenberg–Marquardt steps (Ceres) on the manifold of those shapes.
Descent descend(const StripProblem& problem, const StripParameters& from,
                const DescentOptions& options);

}  // namespace planish::slit_detail
