#pragma once

#include "bend_energy.hpp"
#include "block_matrix.hpp"
#include "strip_objective.hpp"
#include "strip_system.hpp"

#include <Eigen/QR>

#include <vector>

namespace planish::slit_detail {

/// A strip at a shape, with what its derivatives need.
struct Member {
  const StripProblem& problem;
  const StripParameters& p;
  StripFold fold;
  std::vector<Twist> twists;
  SecondOrder model;
  double load = 0.0;                                      ///< what it adds to the value
  std::vector<Pull> pulled = {};                          ///< by contacts
  Eigen::HouseholderQR<Eigen::MatrixXd> conditions = {};  ///< of their derivatives, by columns
  bool is_held = false;

  Eigen::Index condition_count() const { return static_cast<Eigen::Index>(problem.ends.size()); }
  int dimensions() const { return is_held ? 0 : static_cast<int>(p.size() - condition_count()); }

  /// Derivatives by all parameters as those along the manifold, in an orthonormal basis of its
  /// tangent space.
  Eigen::MatrixXd along_manifold(const Eigen::MatrixXd& by_parameters) const {
    Eigen::MatrixXd v = units_of(problem.base).asDiagonal() * by_parameters;
    if (condition_count() > 0) v.applyOnTheLeft(conditions.householderQ().adjoint());
    return v.bottomRows(dimensions());
  }
  /// A step in that basis as one of all parameters.
  Eigen::VectorXd by_parameters(const Eigen::VectorXd& step) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(p.size());
    all.tail(step.size()) = step;
    if (condition_count() > 0) all.applyOnTheLeft(conditions.householderQ());
    return units_of(problem.base).cwiseProduct(all);
  }
};

/// The model of a system's objective about its shapes, in the tangent spaces of its strips.
struct Model {
  std::vector<Member> members;
  double value = 0.0;
  double load = 0.0;  ///< of that the part of loads, whose level is arbitrary
  Eigen::VectorXd gradient;
  BlockMatrix hessian;

  /// A step as shapes.
  Shapes moved(const Shapes& from, const Eigen::VectorXd& step) const {
    Shapes shapes = from;
    for (int i = 0; i < std::ssize(members); ++i)
      if (!members[i].is_held)
        shapes[i] += members[i].by_parameters(step.segment(hessian.begin(i), hessian.size(i)));
    return shapes;
  }
};

/// Contacts and bonds counted.
Model model_of(const StripSystem& system, const Shapes& shapes);

}  // namespace planish::slit_detail
