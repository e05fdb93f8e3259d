// What is measured on a strip's shape: by how much it misses its end, with derivatives, and how
// tightly it is bent (math.md#strip-conditions).
#include "bent_fold.hpp"
#include "strip_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace planish::slit_detail {
Vec3 end_vector(EndCondition::Of of, const StripBase& base, const StripFold& fold) {
  const int quads = base.quads;
  const Frame& last = fold.quad(quads - 1);
  switch (of) {
    case EndCondition::Of::left_end:
      return fold.end(0, quads);
    case EndCondition::Of::right_end:
      return fold.end(1, quads);
    case EndCondition::Of::middle:
      return 0.5 * (fold.end(0, quads) + fold.end(1, quads));
    case EndCondition::Of::along:
      return last.x;
    case EndCondition::Of::across:
      return base.along_last_ridge(last).y;
    case EndCondition::Of::normal:
      return last.z;
  }
  return Vec3::Zero();
}

Eigen::VectorXd end_violation(const StripProblem& problem, const StripFold& fold) {
  Eigen::VectorXd violation(static_cast<Eigen::Index>(problem.ends.size()));
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const double missed = condition.gradient.dot(end_vector(condition.of, problem.base, fold)) -
                          condition.value;
    violation[static_cast<Eigen::Index>(i)] = condition.is_length() ? missed / problem.base.unit()
                                                                    : missed;
  }
  return violation;
}

RowMatrix end_derivative(const StripProblem& problem, const StripFold& fold) {
  const std::vector<Twist> all = twists(problem.base, fold);
  RowMatrix derivative(static_cast<Eigen::Index>(problem.ends.size()), problem.parameters());
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const Vec3 v = end_vector(condition.of, problem.base, fold);
    const double scale = condition.is_length() ? 1.0 / problem.base.unit() : 1.0;
    for (std::size_t q = 0; q < all.size(); ++q) {
      const Vec3 velocity = condition.is_length() ? all[q].velocity(v) : Vec3(all[q].axis.cross(v));
      derivative(static_cast<Eigen::Index>(i),
                 static_cast<Eigen::Index>(q)) = scale * condition.gradient.dot(velocity);
    }
  }
  return derivative;
}

double end_gap(const StripProblem& problem, const StripFold& fold) {
  const Eigen::VectorXd violation = end_violation(problem, fold);
  double largest = 0.0, middle = 0.0;
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const double missed = violation[static_cast<Eigen::Index>(i)] * problem.base.unit();
    if (problem.ends[i].of == EndCondition::Of::middle)
      middle += missed * missed;
    else if (problem.ends[i].is_length())
      largest = std::max(largest, std::abs(missed));
  }
  return std::max(largest, std::sqrt(middle));
}

Frame last_frame(const StripBase& base, const StripParameters& p) {
  return base.along_last_ridge(folded(base, p).quad(base.quads - 1));
}

Angle fold_into(const Frame& last, const Frame& facet) {
  return Angle::radians(std::atan2(-facet.x.dot(last.z), facet.x.dot(last.x)));
}

Tightest far_fold(const StripProblem& problem, const StripParameters& p) {
  const int quads = problem.base.quads;
  if (!problem.far_facet) return {std::numeric_limits<double>::infinity(), quads};
  const Angle angle = fold_into(last_frame(problem.base, p), *problem.far_facet);
  return {fold_at(problem, p, quads).radius(angle.radians()), quads};
}

Tightest tightest_fold(const StripProblem& problem, const StripParameters& p) {
  Tightest tightest{std::numeric_limits<double>::infinity(), 0};
  for (int ridge = 0; ridge < problem.base.quads; ++ridge)
    if (const double radius = fold_at(problem, p, ridge).radius(p[ridge]); radius < tightest.radius)
      tightest = {radius, ridge};
  return tightest;
}

std::vector<RadiusLimit> radius_limits(const StripProblem& problem, const StripParameters& p) {
  constexpr double kNear = 2.0;
  std::vector<RadiusLimit> limits;
  for (int ridge = 0; ridge < problem.base.quads; ++ridge) {
    const BentFold fold = fold_at(problem, p, ridge);
    const double tangent = std::tan(0.5 * std::abs(p[ridge]));
    for (int side = 0; side < 2; ++side)
      if (fold.bent(side) < 2.0 * kNear * problem.min_radius * tangent)
        limits.push_back({ridge, side});
  }
  return limits;
}

}  // namespace planish::slit_detail
