#pragma once

#include "strip_problem.hpp"

#include <planish/base/tolerance.hpp>

#include <Eigen/QR>

#include <optional>

namespace planish::slit_detail {

/// End conditions are met if none is missed by more than this (of the strip's length, or of a unit
/// vector).
constexpr double kEndsMet = tolerance::kRounding;

/// A shape that meets the end conditions, or the nearest one found.
struct Reach {
  StripParameters p;
  double violation = 0.0;  ///< largest
  int iterations = 0;
  bool met() const { return violation <= kEndsMet; }
};

/// Damped Gauss–Newton steps of least norm from a shape, each at most a quarter radian per ridge
/// and never past a neighbouring ridge; abscissae move less readily than angles. O(iterations ×
/// quads).
Reach meet_ends(const StripProblem& problem, const StripParameters& from, int max_iterations = 200);

/// Coordinates for the shapes that meet the end conditions, near one of them. The parameters are
/// transformed by an orthogonal matrix Q so that the conditions' derivative there involves only the
/// first ones, and the others, the coordinates ξ, span its null space: p = p0 + Q (η, ξ). η follows
/// from ξ through the conditions (Newton's method).
class EndChart {
 public:
  EndChart(const StripProblem& problem, const StripParameters& at);
  int dimensions() const { return static_cast<int>(qr_.rows()) - conditions(); }

  /// The shape with these coordinates; empty if the conditions cannot be met there, or ridges
  /// cross.
  std::optional<StripParameters> shape(const Eigen::Ref<const Eigen::VectorXd>& xi) const;

  /// Derivatives with respect to the parameters at a shape become those with respect to ξ: J_ξ −
  /// J_η C_η⁻¹ C_ξ, C the derivative of the conditions (implicit functions).
  RowMatrix derivative(const StripParameters& shape, RowMatrix jacobian) const;

 private:
  int conditions() const { return static_cast<int>(problem_.ends.size()); }

  const StripProblem& problem_;
  StripParameters origin_;
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
};

}  // namespace planish::slit_detail
