// What is measured on a strip's shape: by how much it misses its end, with derivatives, and how
// tightly it is bent (math.md#strip-conditions).
#include "strip_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace planish::slit_detail {
namespace {

/// Calls f(side, neighbouring quad, its abscissa difference) at both sides of a ridge.
template <typename F>
void for_neighbours(const StripBase& base, const StripParameters& p, int ridge, const F& f) {
  for (int side = 0; side < 2; ++side)
    for (int quad = std::max(0, ridge - 1); quad <= ridge; ++quad)
      f(side, quad, abscissa(base, p, quad + 1, side) - abscissa(base, p, quad, side));
}

double fold_radius(const StripBase& base, const StripParameters& p, int ridge, double spacing) {
  const double length = std::hypot(abscissa(base, p, ridge, 1) - abscissa(base, p, ridge, 0),
                                   base.width());
  const double tangent = std::tan(0.5 * std::abs(p[ridge]));
  return tangent > 0.0 ? 0.5 * spacing * base.width() / length / tangent
                       : std::numeric_limits<double>::infinity();
}

}  // namespace

Vec3 end_vector(EndCondition::Of of, const StripFold& fold, int quads) {
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
      return last.y;
    case EndCondition::Of::normal:
      return last.z;
  }
  return Vec3::Zero();
}

Eigen::VectorXd end_violation(const StripProblem& problem, const StripFold& fold) {
  Eigen::VectorXd violation(static_cast<Eigen::Index>(problem.ends.size()));
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const double missed = condition.gradient.dot(
                              end_vector(condition.of, fold, problem.base.quads)) -
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
    const Vec3 v = end_vector(condition.of, fold, problem.base.quads);
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

Angle fold_into(const Frame& last, const Frame& facet) {
  return Angle::radians(std::atan2(-facet.x.dot(last.z), facet.x.dot(last.x)));
}

Tightest far_fold(const StripProblem& problem, const StripParameters& p) {
  Tightest fold{std::numeric_limits<double>::infinity(), problem.base.quads};
  if (!problem.far_facet) return fold;
  const StripBase& base = problem.base;
  const int last = base.quads - 1;
  const double angle = fold_into(folded(base, p).quad(last), *problem.far_facet).radians();
  const double tangent = std::tan(0.5 * std::abs(angle));
  for (int side = 0; side < 2; ++side)
    if (tangent > 0.0)
      fold.radius = std::min(fold.radius,
                             0.5 * (base.end - abscissa(base, p, last, side)) / tangent);
  return fold;
}

Tightest tightest_fold(const StripBase& base, const StripParameters& p) {
  Tightest tightest{std::numeric_limits<double>::infinity(), 0};
  for (int ridge = 0; ridge < base.quads; ++ridge)
    for_neighbours(base, p, ridge, [&](int, int, double spacing) {
      const double radius = fold_radius(base, p, ridge, spacing);
      if (radius < tightest.radius) tightest = {radius, ridge};
    });
  return tightest;
}

std::vector<RadiusLimit> radius_limits(const StripBase& base, const StripParameters& p,
                                       double min_radius) {
  constexpr double kNear = 2.0;
  std::vector<RadiusLimit> limits;
  for (int ridge = 0; ridge < base.quads; ++ridge)
    for_neighbours(base, p, ridge, [&](int side, int quad, double spacing) {
      if (fold_radius(base, p, ridge, spacing) < kNear * min_radius)
        limits.push_back({ridge, side, quad});
    });
  return limits;
}

}  // namespace planish::slit_detail
