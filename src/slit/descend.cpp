#include "descend.hpp"
#include "reach.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <optional>

// Ceres has no equality constraints, but it minimises on manifolds, and the shapes that meet the end conditions are
// one: its tangent space is the null space of their derivative, and a step along it is brought back by Newton's
// method. So every iterate meets them to rounding, no weight has to be balanced against the objective, and Ceres
// solves for fewer unknowns than there are, not for more (docs/decisions, slit sheets).

namespace planish::slit_detail {
namespace {

using ParametersView = Eigen::Map<const Eigen::VectorXd>;

class ObjectiveCost final : public ceres::CostFunction {
 public:
  explicit ObjectiveCost(const StripProblem& problem) : problem_(problem) {
    set_num_residuals(problem.residuals());
    mutable_parameter_block_sizes()->push_back(problem.parameters());
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const ParametersView p(parameters[0], problem_.parameters());
    Eigen::Map<Eigen::VectorXd> values(residuals, num_residuals());
    if (!jacobians || !jacobians[0]) return evaluate(problem_, p, values, nullptr);
    Eigen::Map<RowMatrix> map(jacobians[0], num_residuals(), problem_.parameters());
    Eigen::Ref<RowMatrix> jacobian(map);
    return evaluate(problem_, p, values, &jacobian);
  }

 private:
  const StripProblem& problem_;
};

class ShapesMeetingEnds final : public ceres::Manifold {
 public:
  explicit ShapesMeetingEnds(const StripProblem& problem) : problem_(problem) {}

  int AmbientSize() const override { return problem_.parameters(); }
  int TangentSize() const override { return problem_.parameters() - static_cast<int>(problem_.ends.size()); }

  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    const ParametersView from(x, AmbientSize());
    const auto moved = moved_on_ends(problem_, from + tangent_at(from).step(ParametersView(delta, TangentSize())));
    if (!moved) return false;
    std::copy_n(moved->data(), moved->size(), x_plus_delta);
    return true;
  }

  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<RowMatrix>(jacobian, AmbientSize(), TangentSize()) = tangent_at(ParametersView(x, AmbientSize())).basis();
    return true;
  }

  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    const ParametersView from(x, AmbientSize());
    Eigen::Map<Eigen::VectorXd>(y_minus_x, TangentSize()) =
        tangent_at(from).basis().transpose() * (ParametersView(y, AmbientSize()) - from);
    return true;
  }

  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<RowMatrix>(jacobian, TangentSize(), AmbientSize()) = tangent_at(ParametersView(x, AmbientSize())).basis().transpose();
    return true;
  }

 private:
  /// Ceres asks for the tangent space of one point several times.
  const EndTangent& tangent_at(const ParametersView& p) const {
    if (!tangent_ || known_at_ != p) {
      known_at_ = p;
      tangent_.emplace(problem_, known_at_);
    }
    return *tangent_;
  }

  const StripProblem& problem_;
  mutable Eigen::VectorXd known_at_;
  mutable std::optional<EndTangent> tangent_;
};

class StopWhenAsked final : public ceres::IterationCallback {
 public:
  explicit StopWhenAsked(const std::function<bool()>& stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return stop_ && stop_() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::function<bool()>& stop_;
};

ceres::Solver::Options solver_options(const DescentOptions& options, ceres::IterationCallback* callback) {
  ceres::Solver::Options result;
  result.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  result.max_num_iterations = options.max_iterations;
  result.function_tolerance = options.function_tolerance;
  result.gradient_tolerance = 1e-12;
  result.parameter_tolerance = 1e-10;
  result.max_num_consecutive_invalid_steps = 50;
  result.logging_type = ceres::SILENT;
  result.callbacks.push_back(callback);
  return result;
}

ceres::Problem::Options borrowing() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

}  // namespace

Descent descend(const StripProblem& problem, const StripParameters& from, const DescentOptions& options) {
  Descent descent{from};
  ObjectiveCost cost(problem);
  ShapesMeetingEnds manifold(problem);
  StopWhenAsked callback(options.stop);
  ceres::Problem ceres_problem(borrowing());
  ceres_problem.AddResidualBlock(&cost, nullptr, descent.p.data());
  if (!problem.ends.empty()) ceres_problem.SetManifold(descent.p.data(), &manifold);
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(options, &callback), &ceres_problem, &summary);
  descent.objective = summary.final_cost;
  descent.iterations = static_cast<int>(summary.iterations.size());
  descent.converged = summary.termination_type == ceres::CONVERGENCE;
  return descent;
}

}  // namespace planish::slit_detail
