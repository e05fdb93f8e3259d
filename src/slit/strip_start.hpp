#pragma once

#include "reach.hpp"
#include "strip_solver.hpp"

#include <limits>

namespace planish::slit_detail {

/// The objective without the terms of inequalities.
double objective(const StripProblem& problem, const StripParameters& p);

/// The shape that comes nearest to the end conditions, and by how much it misses them.
struct Found {
  StripSolution solution;
  double violation = std::numeric_limits<double>::infinity();
  bool met() const { return violation <= kEndsMet; }
};

/// The result of meeting the end conditions from a shape, if nearer than `best`.
Found met_from(const StripProblem& problem, const StripParameters& from, Found best);

/// The same from the shape that a strip had before; where that was just divided, smoothed.
Found met_from_before(const StripProblem& problem, const StripParameters& from);

}  // namespace planish::slit_detail
