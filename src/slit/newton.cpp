// Newton's method on the manifold of shapes that meet the end conditions. The second derivative
// along it is that of the Lagrange function: multipliers of the conditions times their curvature
// are added to the objective's own, and the tangent space is left (math.md#bending-energy). Without
// that term steps converge linearly, near buckling not at all. A step goes along the tangent space,
// within a reach in which the model can be trusted; least steps lead it back to the conditions.
#include "newton.hpp"

#include "bend_energy.hpp"
#include "end_curvature.hpp"
#include "reach.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace planish::slit_detail {
namespace {

constexpr double kFirstReach = 0.2, kMostReach = 2.0;  // of a step, for each ridge
constexpr double kLeastSpacing = 0.2;                  // of a spacing that a step leaves

/// The objective with derivatives by all parameters.
SecondOrder model_of(const StripProblem& problem, const StripParameters& p) {
  SecondOrder model = bend_energy_derivatives(problem, p);
  const double scale = energy_scale(problem.base);
  Eigen::VectorXd residuals(problem.residuals());
  RowMatrix jacobian(problem.residuals(), problem.parameters());
  Eigen::Ref<RowMatrix> ref(jacobian);
  evaluate(problem, p, residuals, &ref);
  model.value = scale * model.value + 0.5 * residuals.squaredNorm();
  model.gradient = scale * model.gradient + jacobian.transpose() * residuals;
  model.hessian *= scale;
  model.hessian.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  model.hessian.triangularView<Eigen::StrictlyUpper>() = model.hessian.transpose();
  return model;
}

/// All that draws at ridge ends or holds the last quad, by what it draws or holds.
std::vector<WeighedVector> weighed(const StripProblem& problem, const StripFold& fold,
                                   const Eigen::VectorXd& multipliers) {
  std::vector<WeighedVector> sum = weighed_conditions(problem, fold, multipliers);
  for (const Pull& pull : pulls(problem, fold))
    sum.push_back({pull.ridge, true, fold.end(pull.side, pull.ridge), pull.gradient, pull.side});
  return sum;
}

/// In steps a fold by one radian and a ridge end moved by a mean spacing are alike.
Eigen::VectorXd units_of(const StripBase& base) {
  Eigen::VectorXd units = Eigen::VectorXd::Constant(parameter_count(base.quads), 1.0 / base.quads);
  units.head(base.quads).setOnes();
  return units;
}

/// The objective along the manifold at a shape, in an orthonormal basis of its tangent space.
struct Tangent {
  SecondOrder model;
  Eigen::HouseholderQR<Eigen::MatrixXd> conditions;  ///< of their derivatives, by columns
  Eigen::Index count = 0;                            ///< of conditions

  /// A step in the basis as one of all parameters, in their units.
  Eigen::VectorXd in_units(const Eigen::VectorXd& step) const {
    if (count == 0) return step;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(count + step.size());
    all.tail(step.size()) = step;
    return conditions.householderQ() * all;
  }
};

Tangent along_manifold(const StripProblem& problem, const StripParameters& p, SecondOrder model) {
  const Eigen::VectorXd units = units_of(problem.base);
  Tangent tangent{{}, {}, static_cast<Eigen::Index>(problem.ends.size())};
  const Eigen::Index free = p.size() - tangent.count;
  const StripFold fold = folded(problem.base, p);
  Eigen::VectorXd multipliers;
  if (tangent.count > 0) {
    const Eigen::MatrixXd derivative = end_derivative(problem, fold) * units.asDiagonal();
    // A flat strip's conditions depend on each other: the least multipliers.
    multipliers = derivative.transpose().completeOrthogonalDecomposition().solve(
        -units.cwiseProduct(model.gradient));
    tangent.conditions.compute(derivative.transpose());
  }
  const std::vector<WeighedVector> sum = weighed(problem, fold, multipliers);
  if (!sum.empty()) model.hessian += second_derivatives(problem.base, p, fold, sum);
  model.gradient.array() *= units.array();
  model.hessian = units.asDiagonal() * model.hessian * units.asDiagonal();
  if (tangent.count > 0) {
    const auto turn = tangent.conditions.householderQ();
    model.gradient.applyOnTheLeft(turn.adjoint());
    model.hessian.applyOnTheLeft(turn.adjoint());
    model.hessian.applyOnTheRight(turn);
  }
  tangent.model = {model.value, model.gradient.tail(free),
                   model.hessian.bottomRightCorner(free, free)};
  return tangent;
}

/// The step that minimises a model within a reach, to a tenth of it: damped by just as much as that
/// takes (Moré and Sorensen). Where the model is concave along a direction the damping outweighs
/// it.
Eigen::VectorXd step_within(const SecondOrder& model, double reach) {
  constexpr double kNearEnough = 0.1, kLeastDamping = 1e-12, kDampingFound = 1e-9;
  constexpr int kMostTried = 40;
  const double largest = model.hessian.cwiseAbs().rowwise().sum().maxCoeff(),
               steepness = model.gradient.norm();
  double too_little = 0.0, enough = largest + steepness / reach, damping = 0.0;
  Eigen::VectorXd step = -model.gradient / std::max(enough, std::numeric_limits<double>::min());
  const auto between = [&] {
    return std::sqrt(std::max(too_little, kLeastDamping * largest) * enough);
  };
  for (int tried = 0; tried < kMostTried && enough - too_little > kDampingFound * enough; ++tried) {
    Eigen::MatrixXd damped = model.hessian;
    damped.diagonal().array() += damping;
    const Eigen::LLT<Eigen::MatrixXd> llt(damped);
    if (llt.info() != Eigen::Success) {
      too_little = damping;
      damping = between();
      continue;
    }
    step = llt.solve(-model.gradient);
    const double length = step.norm();
    const bool is_within = length <= reach * (1.0 + kNearEnough);
    if (is_within && (damping == 0.0 || length >= reach * (1.0 - kNearEnough))) break;
    (is_within ? enough : too_little) = damping;
    // Newton's step for 1/length − 1/reach, which is nearly linear in the damping.
    damping += (length - reach) / reach * length * length / llt.matrixL().solve(step).squaredNorm();
    if (!(damping > too_little && damping < enough)) damping = between();
  }
  return step;
}

/// Back to the end conditions by the least steps.
std::optional<StripParameters> led_back(const StripProblem& problem, StripParameters p) {
  constexpr int kIterations = 12;
  constexpr double kDiverging = 0.1, kAimedAt = 0.01 * kEndsMet;
  const Eigen::VectorXd units = units_of(problem.base);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kIterations; ++i) {
    if (!is_shape(problem.base, p)) return std::nullopt;
    if (problem.ends.empty()) return p;
    const StripFold fold = folded(problem.base, p);
    const Eigen::VectorXd violation = end_violation(problem, fold);
    const double missed = violation.cwiseAbs().maxCoeff();
    if (missed <= kAimedAt || (missed <= kEndsMet && missed >= 0.25 * before)) return p;
    if (missed > before && missed > kDiverging) return std::nullopt;
    before = missed;
    const Eigen::MatrixXd derivative = end_derivative(problem, fold) * units.asDiagonal();
    p -= units.cwiseProduct(derivative.completeOrthogonalDecomposition().solve(violation));
  }
  return std::nullopt;
}

/// Whether a step leaves ridges far enough apart for the model to mean something there.
bool is_near(const StripBase& base, const StripParameters& p, const StripParameters& next) {
  for (int quad = 0; quad < base.quads; ++quad)
    for (int side = 0; side < 2; ++side) {
      const double now = abscissa(base, p, quad + 1, side) - abscissa(base, p, quad, side);
      const double then = abscissa(base, next, quad + 1, side) - abscissa(base, next, quad, side);
      if (then < kLeastSpacing * now) return false;
    }
  return true;
}

/// One step that lowers the objective, or nothing where none does.
class Stepping {
 public:
  Stepping(const StripProblem& problem, const DescentOptions& options, Descent& descent)
      : problem_(problem),
        options_(options),
        descent_(descent),
        reach_(kFirstReach * std::sqrt(problem.base.quads)) {}

  /// False when it is over.
  bool step() {
    const Tangent tangent = along_manifold(problem_, descent_.p, model_of(problem_, descent_.p));
    const SecondOrder& model = tangent.model;
    descent_.objective = model.value;
    const Eigen::VectorXd units = units_of(problem_.base);
    while (reach_ > kNoReach) {
      const Eigen::VectorXd step = step_within(model, reach_);
      const double expected = -(model.gradient.dot(step) + 0.5 * step.dot(model.hessian * step));
      if (expected <= kNothing * model.value) return ended(true);
      if (options_.stop && options_.stop()) return ended(false);
      ++descent_.iterations;
      const auto next = led_back(problem_, descent_.p + units.cwiseProduct(tangent.in_units(step)));
      const bool is_good = next && is_near(problem_.base, descent_.p, *next);
      const double value = is_good ? whole_objective(problem_, *next)
                                   : std::numeric_limits<double>::infinity();
      const double gain = model.value - value;
      if (!(gain > kPoorShare * expected)) reach_ = 0.3 * std::min(reach_, step.norm());
      if (!(gain > kLeastShare * expected)) continue;
      if (gain > kGoodShare * expected)
        reach_ = std::clamp(2.0 * step.norm(), reach_,
                            std::max(reach_, kMostReach * std::sqrt(problem_.base.quads)));
      descent_.p = *next;
      descent_.objective = value;
      return expected > options_.function_tolerance * model.value || ended(true);
    }
    return ended(false);
  }

 private:
  static constexpr double kNothing = 1e-14;  // of the objective: less cannot be seen
  static constexpr double kNoReach = 1e-9;
  static constexpr double kLeastShare = 1e-3, kPoorShare = 0.25,
                          kGoodShare = 0.75;  // of the gain expected

  bool ended(bool converged) {
    descent_.converged = converged;
    return false;
  }

  const StripProblem& problem_;
  const DescentOptions& options_;
  Descent& descent_;
  double reach_;
};

}  // namespace

Descent descend_by_newton(const StripProblem& problem, const StripParameters& from,
                          const DescentOptions& options) {
  Descent descent{from};
  Stepping stepping(problem, options, descent);
  while (descent.iterations < options.max_iterations && stepping.step()) {
  }
  return descent;
}

}  // namespace planish::slit_detail
