// Shapes with which the solving of a strip begins, that meet its end conditions: from one that it
// had, or from one whose quads were just halved.
#include "strip_start.hpp"

#include "descend.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

/// Whether every other ridge was just inserted by subdivision, without a fold.
bool just_divided(const StripBase& base, const StripParameters& p) {
  if (base.quads % 2 != 0) return false;
  bool any = false;
  for (int ridge = 0; ridge < base.quads; ridge += 2) {
    any |= p[ridge] != 0.0;
    if (p[ridge + 1] != 0.0) return false;
  }
  return any;
}

/// New ridges take a quarter of each neighbour's fold: the shape stays nearly the same, and as
/// smooth as it was.
StripParameters shared_out(const StripBase& base, const StripParameters& p) {
  StripParameters shared = p;
  shared[0] = 0.75 * p[0];
  for (int ridge = 2; ridge < base.quads; ridge += 2)
    shared[ridge] = 0.5 * p[ridge];
  for (int ridge = 1; ridge < base.quads; ridge += 2)
    shared[ridge] = 0.25 * (p[ridge - 1] + (ridge + 1 < base.quads ? p[ridge + 1] : 0.0));
  return shared;
}

/// Folds averaged between neighbours; their sum is kept.
StripParameters smoothed(const StripBase& base, const StripParameters& p) {
  StripParameters even = p;
  for (int ridge = 0; ridge < base.quads; ++ridge) {
    const double before = p[std::max(ridge - 1, 0)], after = p[std::min(ridge + 1, base.quads - 1)];
    even[ridge] = 0.25 * (before + 2.0 * p[ridge] + after);
  }
  return even;
}

}  // namespace

double objective(const StripProblem& problem, const StripParameters& p) {
  StripProblem plain = problem;
  plain.inequalities.clear();
  return whole_objective(plain, p);
}

Found met_from(const StripProblem& problem, const StripParameters& from, Found best) {
  if (!is_shape(problem.base, from)) return best;
  const Reach reach = meet_ends(problem, from);
  best.solution.iterations += reach.iterations;
  if (reach.violation < best.violation) {
    best.solution.p = reach.p;
    best.solution.reached = reach.met();
    best.violation = reach.violation;
  }
  return best;
}

namespace {

/// Of shapes with the subdivided one's folds that of least objective: new ridges take more and more
/// of their neighbours' folds, then folds are smoothed more and more. Removing the unevenness of
/// folds step by step would crease fine strips, in which it outweighs everything else; but shares
/// of folds about ridges of much different directions lead the end away.
Found met_from_divided(const StripProblem& problem, const StripParameters& divided) {
  Found last;
  std::optional<Found> best;
  const auto see = [&](const StripParameters& from) {
    last.violation = std::numeric_limits<double>::infinity();
    last = met_from(problem, from, std::move(last));
    if (!last.met()) return;
    last.solution.objective = objective(problem, last.solution.p);
    if (!best || last.solution.objective < best->solution.objective) best = last;
  };
  constexpr int kShares = 4, kPasses = 6;
  StripParameters from = shared_out(problem.base, divided);
  if (problem.objective == SlitObjective::energy)
    for (int share = 0; share < kShares; ++share)
      see(divided + static_cast<double>(share) / kShares * (from - divided));
  for (int pass = 0; pass < kPasses; ++pass, from = smoothed(problem.base, from))
    see(from);
  return best ? *best : last;
}

}  // namespace

Found met_from_before(const StripProblem& problem, const StripParameters& from) {
  if (from.size() != problem.parameters()) return {};
  Found found;
  if (just_divided(problem.base, from)) found = met_from_divided(problem, from);
  return found.met() ? found : met_from(problem, from, std::move(found));
}

}  // namespace planish::slit_detail
