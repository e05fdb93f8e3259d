#pragma once

#include "strip_problem.hpp"

#include <Eigen/QR>

#include <optional>

namespace planish::slit_detail {

/// End conditions count as met when none is missed by more (of the strip's length, or of a unit vector).
constexpr double kEndsMet = 1e-12;

/// A shape that meets the end conditions, or comes as near as was found.
struct Reach {
  StripParameters p;
  double violation = 0.0;  ///< largest
  int iterations = 0;
  bool met() const { return violation <= kEndsMet; }
};

/// Damped Gauss–Newton steps of least norm from a shape, each at most a quarter radian a ridge and never past a
/// neighbouring ridge; abscissae move less readily than angles. O(iterations × quads).
Reach meet_ends(const StripProblem& problem, const StripParameters& from, int max_iterations = 200);

/// The directions in which a shape that meets the end conditions may move and still meet them to first order: an
/// orthonormal basis of the null space of their derivative.
class EndTangent {
 public:
  EndTangent(const StripProblem& problem, const StripParameters& p);
  int dimensions() const { return static_cast<int>(qr_.rows() - qr_.cols()); }
  Eigen::VectorXd step(const Eigen::VectorXd& tangent) const;
  Eigen::MatrixXd basis() const;

 private:
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

/// The shape moved along its tangent space and back onto the end conditions by Newton's method; none where that
/// does not converge.
std::optional<StripParameters> moved_on_ends(const StripProblem& problem, const StripParameters& moved);

}  // namespace planish::slit_detail
