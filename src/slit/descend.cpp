#include "descend.hpp"

#include "reach.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <limits>
#include <utility>

// Ceres has no equality constraints, so they are eliminated: as many transformed parameters as
// there are end conditions follow from the others (EndChart), and Ceres sees only those others,
// unconstrained. Every shape it tries meets the conditions to rounding, no weight has to be
// balanced against the objective, and there are fewer unknowns, not more (docs/decisions/0002).

namespace planish::slit_detail {
namespace {

class ObjectiveCost final : public ceres::CostFunction {
 public:
  ObjectiveCost(const StripProblem& problem, const EndChart& chart)
      : problem_(problem), chart_(chart) {
    set_num_residuals(problem.residuals());
    mutable_parameter_block_sizes()->push_back(chart.dimensions());
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const auto shape = chart_.shape(
        Eigen::Map<const Eigen::VectorXd>(parameters[0], chart_.dimensions()));
    if (!shape) return false;
    Eigen::Map<Eigen::VectorXd> values(residuals, num_residuals());
    if (!jacobians || !jacobians[0]) return evaluate(problem_, *shape, values, nullptr);
    RowMatrix full(num_residuals(), problem_.parameters());
    Eigen::Ref<RowMatrix> jacobian(full);
    if (!evaluate(problem_, *shape, values, &jacobian)) return false;
    Eigen::Map<RowMatrix>(jacobians[0], num_residuals(), chart_.dimensions()) = chart_.derivative(
        *shape, std::move(full));
    return true;
  }

 private:
  const StripProblem& problem_;
  const EndChart& chart_;
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

// The gain ends the descent; these only stop it when a gain is too small to see.
constexpr double kLeastGradient = 1e-12, kLeastStep = 1e-10;

ceres::Solver::Options solver_options(const DescentOptions& options,
                                      ceres::IterationCallback* callback) {
  ceres::Solver::Options result;
  result.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  result.max_num_iterations = options.max_iterations;
  result.function_tolerance = options.function_tolerance;
  result.gradient_tolerance = kLeastGradient;
  result.parameter_tolerance = kLeastStep;
  result.max_num_consecutive_invalid_steps = 30;
  result.logging_type = ceres::SILENT;
  result.callbacks.push_back(callback);
  return result;
}

ceres::Problem::Options borrowing() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

/// Descends in the coordinates about one shape. Returns how far it went in them.
double descend_in_chart(const StripProblem& problem, const DescentOptions& options,
                        ceres::IterationCallback* callback, Descent& descent) {
  const EndChart chart(problem, descent.p);
  ObjectiveCost cost(problem, chart);
  Eigen::VectorXd xi = Eigen::VectorXd::Zero(chart.dimensions());
  ceres::Problem ceres_problem(borrowing());
  ceres_problem.AddResidualBlock(&cost, nullptr, xi.data());
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(options, callback), &ceres_problem, &summary);
  if (const auto shape = chart.shape(xi)) descent.p = *shape;
  descent.objective = summary.final_cost;
  descent.iterations += static_cast<int>(summary.iterations.size());
  descent.converged = summary.termination_type == ceres::CONVERGENCE;
  return xi.size() ? xi.cwiseAbs().maxCoeff() : 0.0;
}

}  // namespace

Descent descend(const StripProblem& problem, const StripParameters& from,
                const DescentOptions& options) {
  // Far from their centre the coordinates may reach a limit, so a descent that ends there continues
  // about a new shape.
  constexpr double kFar = 0.5;
  Descent descent{from};
  StopWhenAsked callback(options.stop);
  DescentOptions rest = options;
  double moved = std::numeric_limits<double>::infinity();
  while (rest.max_iterations > 0 && moved > kFar) {
    moved = descend_in_chart(problem, rest, &callback, descent);
    rest.max_iterations = options.max_iterations - descent.iterations;
    if (options.stop && options.stop()) break;
  }
  return descent;
}

}  // namespace planish::slit_detail
