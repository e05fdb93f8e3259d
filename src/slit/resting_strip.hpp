#pragma once

#include "bend_energy.hpp"
#include "strip_system.hpp"

#include <planish/slit/equilibrium.hpp>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace planish::slit_detail {

/// A force in the unit of the objective, per mm, at a point that is a mix of ends of ridges.
struct PointForce {
  StripPoint point;
  Vec3 force = Vec3::Zero();
};

/// A strip that its forces leave at rest, with the multipliers of its end conditions and of the
/// ground. They are found anew from the shape, by least squares, and owe nothing to how it was
/// found.
class RestingStrip {
 public:
  /// `pressed`: by other strips; `ground`: the height that it keeps.
  RestingStrip(StripProblem problem, StripParameters p, std::vector<PointForce> pressed = {},
               std::optional<double> ground = {});

  const StripProblem& problem() const { return problem_; }
  const StripFold& fold() const { return fold_; }
  int parameters() const { return problem_.parameters(); }

  /// What acts on it, in the order of `HeldBy`; the panel bears the rest. `to_newtons`: of a force
  /// in the unit of the objective, per mm.
  std::vector<SlitReaction> reactions(int strip, double to_newtons) const;

  /// Derivative of a point along a direction.
  Eigen::VectorXd along(const StripPoint& point, const Vec3& direction) const;
  /// Derivative of a direction that is fixed to a quad, a column for each parameter.
  Eigen::Matrix3Xd turning(int quad, const Vec3& direction) const;

  /// Second derivatives of the Lagrange function: of the objective and of all that holds the strip,
  /// forces keeping their direction.
  Eigen::MatrixXd of_lagrange_function() const;
  /// Derivatives of what it cannot leave, by columns: end conditions, limits that are kept, the
  /// ground, and places to which wishes draw it, as something must hold it there.
  Eigen::MatrixXd held(const std::vector<EndCondition>& ends) const;
  /// A descent ends where it gains less than that.
  double next_to_nothing() const;

 private:
  void find_ground(double height);
  void find_multipliers();
  Eigen::MatrixXd kept_limits() const;

  StripProblem problem_;
  StripParameters p_;
  StripFold fold_;
  std::vector<Twist> twists_;
  std::vector<PointForce> pressed_, ground_;
  SecondOrder model_;
  Eigen::VectorXd multipliers_;
};

}  // namespace planish::slit_detail
