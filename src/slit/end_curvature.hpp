#pragma once

#include "strip_problem.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace planish::slit_detail {

/// A point or a direction in space that is fixed to a quad, and by what its coordinates are
/// multiplied in a sum.
struct WeighedVector {
  int ridge = 0;  ///< folds of the ridges before this one move it
  bool is_point = false;
  Vec3 at = Vec3::Zero();
  Vec3 weight = Vec3::Zero();
  int side = -1;  ///< of the ridge whose end it is and slides with; −1: none
};

/// What lies behind a ridge, as one force and Σ x wᵀ of all vectors: turns see no more of it, so
/// that their cost does not grow with the vectors.
struct Behind {
  Vec3 force = Vec3::Zero();  ///< of points
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();

  Eigen::Matrix3d about(const Vec3& pole) const { return moment - pole * force.transpose(); }
};

/// Second derivatives of the sum of weight · vector by all parameters: symmetric. A turn upstream
/// carries along what a turn downstream does, ω_a × (ω_b × v); both numbers of one ridge are
/// differentiated in its own quad. O(quads² + vectors).
Eigen::MatrixXd second_derivatives(const StripBase& base, const StripParameters& p,
                                   const StripFold& fold, const std::vector<WeighedVector>& sum);

/// The same by what lies behind each ridge, without what slides.
Eigen::MatrixXd second_derivatives(const StripBase& base, const StripParameters& p,
                                   const StripFold& fold, const std::vector<Twist>& twists,
                                   const std::vector<Behind>& behind);

/// What end conditions are about, weighed by their multipliers in their own units.
std::vector<WeighedVector> weighed_conditions(const StripProblem& problem, const StripFold& fold,
                                              const Eigen::VectorXd& multipliers);

}  // namespace planish::slit_detail
