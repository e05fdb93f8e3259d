#include "descend.hpp"

#include "newton.hpp"
#include "reach.hpp"
#include "strip_objective.hpp"

#include <Eigen/Cholesky>
#include <ceres/tiny_solver.h>

#include <cmath>
#include <limits>
#include <utility>

// Ceres has no equality constraints, so they are eliminated: as many transformed parameters as
// there are end conditions follow from the others (EndChart), and Ceres sees only those others,
// unconstrained. Every shape it tries meets the conditions to rounding, no weight has to be
// balanced against the objective, and there are fewer unknowns, not more (docs/decisions/0002).

namespace planish::slit_detail {
namespace {

/// Ends a descent: TinySolver is left in no other way before it is satisfied itself.
struct Ended {
  bool converged = false;
};

/// The lowest point so far of a descent in the coordinates about one shape.
struct Lowest {
  Eigen::VectorXd xi;
  double objective = std::numeric_limits<double>::infinity();
  int steps = 0;
};

class Objective {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Objective(const StripProblem& problem, const EndChart& chart, const DescentOptions& options,
            Lowest& lowest)
      : problem_(problem), chart_(chart), options_(options), lowest_(lowest) {}

  int NumResiduals() const { return problem_.residuals(); }
  int NumParameters() const { return chart_.dimensions(); }

  /// TinySolver asks for values where a step leads, and for derivatives where it begins. Where
  /// there is no shape the values are infinite: the next step is shorter.
  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    const Eigen::Map<const Eigen::VectorXd> xi(parameters, NumParameters());
    Eigen::Map<Eigen::VectorXd> values(residuals, NumResiduals());
    const auto shape = chart_.shape(xi);
    if (jacobian) {
      RowMatrix full(NumResiduals(), problem_.parameters());
      Eigen::Ref<RowMatrix> ref(full);
      if (!shape || !evaluate(problem_, *shape, values, &ref)) throw Ended();
      Eigen::Map<Eigen::MatrixXd>(jacobian, NumResiduals(), NumParameters()) = chart_.derivative(
          *shape, std::move(full));
      if (lowest_.steps == 0) lowest_ = {xi, 0.5 * values.squaredNorm()};
      return true;
    }
    if (!shape || !evaluate(problem_, *shape, values, nullptr))
      values.setConstant(std::numeric_limits<double>::infinity());
    note(xi, 0.5 * values.squaredNorm());
    return true;
  }

 private:
  void note(const Eigen::VectorXd& xi, double objective) const {
    const double gain = lowest_.objective - objective;
    if (gain > 0.0) lowest_ = {xi, objective, lowest_.steps};
    ++lowest_.steps;
    if (std::abs(gain) <= options_.function_tolerance * lowest_.objective) throw Ended{true};
    if (options_.stop && options_.stop()) throw Ended();
  }

  const StripProblem& problem_;
  const EndChart& chart_;
  const DescentOptions& options_;
  Lowest& lowest_;
};

using Solver = ceres::TinySolver<Objective, Eigen::LLT<Eigen::MatrixXd>>;

// The gain of a step ends the descent; these only stop it when a gain is too small to see.
constexpr double kLeastGradient = 1e-12, kLeastStep = 1e-10;

Solver::Options solver_options(int most_steps) {
  Solver::Options options;
  options.max_num_iterations = most_steps + 1;  // it counts the start
  options.gradient_tolerance = kLeastGradient;
  options.parameter_tolerance = kLeastStep;
  options.function_tolerance = 0.0;  // absolute, Objective's is a share
  options.cost_threshold = 0.0;
  return options;
}

/// Descends in the coordinates about one shape. Returns how far it went in them.
double descend_in_chart(const StripProblem& problem, const DescentOptions& options,
                        Descent& descent) {
  const EndChart chart(problem, descent.p);
  Lowest lowest;
  Eigen::VectorXd xi = Eigen::VectorXd::Zero(chart.dimensions());
  try {
    Solver solver;
    solver.options = solver_options(options.max_iterations);
    solver.Solve(Objective(problem, chart, options, lowest), &xi);
    descent.converged = solver.summary.status != Solver::HIT_MAX_ITERATIONS;
  } catch (const Ended& ended) {
    descent.converged = ended.converged;
  }
  if (lowest.objective == std::numeric_limits<double>::infinity()) return 0.0;
  if (const auto shape = chart.shape(lowest.xi)) descent.p = *shape;
  descent.objective = lowest.objective;
  descent.iterations += lowest.steps;
  return lowest.xi.size() ? lowest.xi.cwiseAbs().maxCoeff() : 0.0;
}

}  // namespace

double whole_objective(const StripProblem& problem, const StripParameters& p) {
  Eigen::VectorXd residuals(problem.residuals());
  if (!evaluate(problem, p, residuals, nullptr)) return std::numeric_limits<double>::infinity();
  const double wishes = 0.5 * residuals.squaredNorm();
  if (problem.objective == SlitObjective::smooth) return wishes;
  return wishes + energy_scale(problem.base) * bend_energy(problem, p) + load_part(problem, p);
}

Descent descend(const StripProblem& problem, const StripParameters& from,
                const DescentOptions& options) {
  if (problem.objective == SlitObjective::energy) return descend_by_newton(problem, from, options);
  // Far from their centre the coordinates may reach a limit, so a descent that ends there continues
  // about a new shape.
  constexpr double kFar = 0.5;
  Descent descent{from};
  DescentOptions rest = options;
  double moved = std::numeric_limits<double>::infinity();
  while (rest.max_iterations > 0 && moved > kFar) {
    moved = descend_in_chart(problem, rest, descent);
    rest.max_iterations = options.max_iterations - descent.iterations;
    if (options.stop && options.stop()) break;
  }
  return descent;
}

}  // namespace planish::slit_detail
