// The closed cubic spline through points with equal steps of the parameter: its second derivatives
// are those of a cyclic tridiagonal system, so it is curvature-continuous all around.

#include "periodic_spline.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {

PeriodicSpline::PeriodicSpline(std::vector<Vec2> points) : points_(std::move(points)), knots_{0.0} {
  const auto n = static_cast<Eigen::Index>(points_.size());
  const auto at = [&](Eigen::Index i) -> const Vec2& { return points_[(i + n) % n]; };
  for (Eigen::Index i = 0; i < n; ++i)
    knots_.push_back(knots_.back() + (at(i + 1) - at(i)).norm());
  const auto h = [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>((i + n) % n);
    return knots_[k + 1] - knots_[k];
  };
  // Continuity of the first derivative at each point: h₋ M₋ + 2 (h₋ + h₊) M + h₊ M₊ = 6 [slopes].
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX2d right(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    system(i, (i + n - 1) % n) += h(i - 1);
    system(i, i) += 2.0 * (h(i - 1) + h(i));
    system(i, (i + 1) % n) += h(i);
    right.row(i) = 6.0 * ((at(i + 1) - at(i)) / h(i) - (at(i) - at(i - 1)) / h(i - 1)).transpose();
  }
  const Eigen::MatrixX2d moments = system.partialPivLu().solve(right);
  for (Eigen::Index i = 0; i < n; ++i)
    moments_.push_back(moments.row(i).transpose());
}

PlanePoint PeriodicSpline::operator()(double t) const {
  const double period = knots_.back();
  t -= period * std::floor(t / period);
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
  const auto i = static_cast<std::size_t>(above - knots_.begin()) - 1;
  const std::size_t j = (i + 1) % points_.size();
  const double h = knots_[i + 1] - knots_[i], s = t - knots_[i];
  const Vec2 slope = (points_[j] - points_[i]) / h - h / 6.0 * (2.0 * moments_[i] + moments_[j]);
  const Vec2 third = (moments_[j] - moments_[i]) / h;
  return {points_[i] + s * (slope + s * (0.5 * moments_[i] + s / 6.0 * third)),
          slope + s * (moments_[i] + 0.5 * s * third), moments_[i] + s * third, third};
}

}  // namespace planish::transition_detail
