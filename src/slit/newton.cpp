// Newton's method on the manifold of shapes that meet the end conditions, for one strip or several
// that touch. The second derivative along it is that of the Lagrange function: multipliers of the
// conditions times their curvature are added to the objective's own, and the tangent space is left
// (math.md#bending-energy). Without that term steps converge linearly, near buckling not at all. A
// step goes along the tangent space, within a reach in which the model can be trusted; least steps
// lead it back to the conditions. Strips that touch share blocks beside the diagonal only.
#include "newton.hpp"

#include "newton_model.hpp"
#include "reach.hpp"
#include "strip_objective.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kFirstReach = 0.2, kMostReach = 2.0;  // of a step, for each ridge
constexpr double kLeastSpacing = 0.2;                  // of a spacing that a step leaves

/// The step that minimises a model within a reach, nearly: damped by just as much as that takes
/// (Moré and Sorensen). Where the model is concave along a direction the damping outweighs it.
/// `damping` is what to begin with, and what was found.
Eigen::VectorXd step_within(const Model& model, double reach, double& damping) {
  constexpr double kBeyond = 1.25, kShort = 0.5, kLeastDamping = 1e-6, kDampingFound = 1e-9,
                   kFaster = 16.0, kJustEnough = 1.5;
  constexpr int kMostTried = 40;
  const double largest = model.hessian.bound(), steepness = model.gradient.norm();
  double too_little = -1.0, enough = largest + steepness / reach;
  damping = std::min(damping, enough);
  Eigen::VectorXd step = -model.gradient / std::max(enough, std::numeric_limits<double>::min());
  const auto between = [&] {
    const double least = std::max(too_little, kLeastDamping * largest);
    return std::min(kFaster * least, std::sqrt(least * enough));
  };
  for (int tried = 0; tried < kMostTried && enough - too_little > kDampingFound * enough; ++tried) {
    const auto factors = BlockCholesky::of(model.hessian, damping);
    if (!factors) {
      too_little = damping;
      damping = between();
      continue;
    }
    step = factors->solve(-model.gradient);
    const double length = step.norm();
    const bool is_within = length <= kBeyond * reach;
    if (is_within && (damping == 0.0 || length >= kShort * reach)) break;
    // Less does not make a model convex that is concave where it has no slope: the step stays
    // short.
    if (is_within && too_little >= 0.0 &&
        damping <= kJustEnough * std::max(too_little, kLeastDamping * largest))
      break;
    (is_within ? enough : too_little) = damping;
    // Newton's step for 1/length − 1/reach, which is nearly linear in the damping.
    damping += (length - reach) / reach * length * length /
               factors->half_solved(step).squaredNorm();
    if (too_little < 0.0)
      damping = std::max(damping, 0.0);
    else if (!(damping > too_little && damping < enough))
      damping = between();
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

std::optional<Shapes> led_back(const StripSystem& system, const Shapes& from, Shapes shapes) {
  for (int strip = 0; strip < system.count(); ++strip) {
    if (system.held[strip]) continue;
    auto back = led_back(system.strips[strip], std::move(shapes[strip]));
    if (!back || !is_near(system.strips[strip].base, from[strip], *back)) return std::nullopt;
    shapes[strip] = std::move(*back);
  }
  return shapes;
}

/// One step that lowers the objective, or nothing where none does.
class Stepping {
 public:
  Stepping(const StripSystem& system, const DescentOptions& options, SystemDescent& descent)
      : system_(system), options_(options), descent_(descent) {
    for (int strip = 0; strip < system.count(); ++strip)
      if (!system.held[strip]) ridges_ += system.strips[strip].base.quads;
    reach_ = kFirstReach * std::sqrt(ridges_);
  }

  /// False when it is over.
  bool step() {
    const Model model = model_of(system_, descent_.shapes);
    descent_.objective = model.value;
    while (reach_ > kNoReach) {
      const Eigen::VectorXd step = step_within(model, reach_, damping_);
      const double expected = -(model.gradient.dot(step) +
                                0.5 * step.dot(model.hessian.times(step)));
      const double bent = model.value - model.load;
      if (expected <= kNothing * model.value || model.value <= kUnbent) return ended(true);
      if (options_.stop && options_.stop()) return ended(false);
      ++descent_.iterations;
      const auto next = led_back(system_, descent_.shapes, model.moved(descent_.shapes, step));
      const double value = next ? objective_of(system_, *next)
                                : std::numeric_limits<double>::infinity();
      const double gain = model.value - value;
      if (!(gain > kPoorShare * expected)) reach_ = 0.3 * std::min(reach_, step.norm());
      if (!(gain > kLeastShare * expected)) continue;
      if (gain > kGoodShare * expected)
        reach_ = std::clamp(2.0 * step.norm(), reach_,
                            std::max(reach_, kMostReach * std::sqrt(ridges_)));
      descent_.shapes = *next;
      descent_.objective = value;
      return expected > options_.function_tolerance * bent || ended(true);
    }
    return ended(false);
  }

 private:
  static constexpr double kNothing = 1e-14;  // of the objective: less cannot be seen
  static constexpr double kUnbent = 1e-20;   // of a quarter turn it is a thousandth
  static constexpr double kNoReach = 1e-9;
  static constexpr double kLeastShare = 1e-3, kPoorShare = 0.25,
                          kGoodShare = 0.75;  // of the gain expected

  bool ended(bool converged) {
    descent_.converged = converged;
    return false;
  }

  const StripSystem& system_;
  const DescentOptions& options_;
  SystemDescent& descent_;
  int ridges_ = 0;
  double reach_ = 0.0, damping_ = 0.0;
};

}  // namespace

SystemDescent descend_by_newton(const StripSystem& system, Shapes from,
                                const DescentOptions& options) {
  SystemDescent descent{std::move(from)};
  Stepping stepping(system, options, descent);
  while (descent.iterations < options.max_iterations && stepping.step()) {
  }
  return descent;
}

Descent descend_by_newton(const StripProblem& problem, const StripParameters& from,
                          const DescentOptions& options) {
  SystemDescent descent = descend_by_newton(StripSystem{{problem}, {false}, {}}, Shapes{from},
                                            options);
  return {std::move(descent.shapes.front()), descent.objective, descent.iterations,
          descent.converged};
}

}  // namespace planish::slit_detail
