// The inequalities of a strip from one round of its augmented Lagrangian to the next: which are
// violated, and with what multipliers (Nocedal and Wright, Numerical Optimization, 17.4). Planes
// that only lead a strip out of its neighbours are a penalty without a multiplier, which would
// throw it into another shape.
#include "strip_limits.hpp"

#include <algorithm>
#include <cstddef>

namespace planish::slit_detail {
namespace {

bool same_place(const RadiusLimit& a, const RadiusLimit& b) {
  return a.ridge == b.ridge && a.side == b.side;
}
bool same_place(const HalfSpace& a, const HalfSpace& b) {
  return a.ridge == b.ridge && a.side == b.side && a.normal.dot(b.normal) > 0.5;
}

/// Adds limits not yet in the list; planes that moved keep their multiplier.
template <typename Limit>
void add(std::vector<Inequality>& list, const Limit& limit) {
  for (Inequality& known : list)
    if (auto* other = std::get_if<Limit>(&known.what); other && same_place(*other, limit)) {
      *other = limit;
      return;
    }
  list.push_back({limit, 0.0});
}

}  // namespace

bool is_too_tight(const StripProblem& problem, const StripParameters& p) {
  return problem.min_radius > 0.0 &&
         tightest_fold(problem, p).radius < problem.min_radius / (1.0 + kRadiusMargin);
}

std::vector<Inequality> with_broken(const StripProblem& problem, const StripParameters& p,
                                    const std::vector<HalfSpace>& planes) {
  std::vector<Inequality> inequalities = problem.inequalities;
  for (const HalfSpace& plane : planes)
    add(inequalities, plane);
  if (is_too_tight(problem, p))
    for (const RadiusLimit& limit : radius_limits(problem, p))
      add(inequalities, limit);
  return inequalities;
}

bool firm_ones_hold(const StripProblem& problem, const StripParameters& p) {
  const Eigen::VectorXd values = inequality_values(problem, p);
  for (std::size_t i = 0; i < problem.inequalities.size(); ++i)
    if (problem.inequalities[i].is_firm() && values[static_cast<Eigen::Index>(i)] > kHolds)
      return false;
  return true;
}

bool load_rests(const StripProblem& problem, const StripParameters& p) {
  if (problem.load.empty()) return true;
  constexpr double kRests = 10.0 * kHolds;
  const Eigen::VectorXd values = inequality_values(problem, p);
  for (std::size_t i = 0; i < problem.inequalities.size(); ++i) {
    const Inequality& one = problem.inequalities[i];
    if (std::holds_alternative<HalfSpace>(one.what) && one.multiplier > 0.0 &&
        values[static_cast<Eigen::Index>(i)] < -kRests)
      return false;
  }
  return true;
}

std::vector<Inequality> with_new_multipliers(const StripProblem& problem,
                                             const StripParameters& p) {
  const Eigen::VectorXd values = inequality_values(problem, p);
  std::vector<Inequality> inequalities = problem.inequalities;
  for (std::size_t i = 0; i < inequalities.size(); ++i)
    if (Inequality& one = inequalities[i]; one.is_firm())
      one.multiplier = std::max(
          0.0, one.multiplier + problem.penalty * values[static_cast<Eigen::Index>(i)]);
  return inequalities;
}

}  // namespace planish::slit_detail
