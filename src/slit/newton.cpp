// Newton's method on the manifold of shapes that meet the end conditions, for one strip or several
// that touch. The second derivative along it is that of the Lagrange function: multipliers of the
// conditions times their curvature are added to the objective's own, and the tangent space is left
// (math.md#bending-energy). Without that term steps converge linearly, near buckling not at all. A
// step goes along the tangent space, within a reach in which the model can be trusted; least steps
// lead it back to the conditions. Strips that touch share blocks beside the diagonal only.
#include "newton.hpp"

#include "block_matrix.hpp"
#include "end_curvature.hpp"
#include "reach.hpp"
#include "strip_objective.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kFirstReach = 0.2, kMostReach = 2.0;  // of a step, for each ridge
constexpr double kLeastSpacing = 0.2;                  // of a spacing that a step leaves

WeighedVector weighed(const StripFold& fold, const Pull& pull) {
  return {pull.ridge, true, fold.end(pull.side, pull.ridge), pull.gradient, pull.side};
}

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
  Eigen::VectorXd along_manifold(const Eigen::VectorXd& by_parameters) const {
    Eigen::VectorXd v = units_of(problem.base).cwiseProduct(by_parameters);
    if (condition_count() > 0) v.applyOnTheLeft(conditions.householderQ().adjoint());
    return v.tail(dimensions());
  }
  /// A step in that basis as one of all parameters.
  Eigen::VectorXd by_parameters(const Eigen::VectorXd& step) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(p.size());
    all.tail(step.size()) = step;
    if (condition_count() > 0) all.applyOnTheLeft(conditions.householderQ());
    return units_of(problem.base).cwiseProduct(all);
  }
};

Member member_of(const StripSystem& system, const Shapes& shapes, int strip) {
  const StripProblem& problem = system.strips[strip];
  Member member{problem, shapes[strip], folded(problem.base, shapes[strip]), {}, {}};
  member.is_held = system.held[strip];
  member.twists = twists(problem.base, member.fold);
  if (member.is_held) return member;
  member.model = objective_derivatives(problem, shapes[strip]);
  member.load = load_part(problem, shapes[strip]);
  return member;
}

/// The objective's second derivatives along the manifold. The gradient, by all parameters, must be
/// complete: it gives the multipliers of the conditions.
Eigen::MatrixXd hessian_along_manifold(Member& member) {
  const StripProblem& problem = member.problem;
  const Eigen::VectorXd units = units_of(problem.base);
  std::vector<WeighedVector> sum;
  if (member.condition_count() > 0) {
    const Eigen::MatrixXd derivative = end_derivative(problem, member.fold) * units.asDiagonal();
    // A flat strip's conditions depend on each other: the least multipliers.
    const Eigen::VectorXd multipliers = derivative.transpose()
                                            .completeOrthogonalDecomposition()
                                            .solve(-units.cwiseProduct(member.model.gradient));
    member.conditions.compute(derivative.transpose());
    sum = weighed_conditions(problem, member.fold, multipliers);
  }
  for (const Pull& pull : pulls(problem, member.fold))
    sum.push_back(weighed(member.fold, pull));
  for (const Pull& pull : member.pulled)
    sum.push_back(weighed(member.fold, pull));
  Eigen::MatrixXd hessian = std::move(member.model.hessian);
  if (!sum.empty()) hessian += second_derivatives(problem.base, member.p, member.fold, sum);
  hessian = units.asDiagonal() * hessian * units.asDiagonal();
  if (member.condition_count() > 0) {
    const auto turn = member.conditions.householderQ();
    hessian.applyOnTheLeft(turn.adjoint());
    hessian.applyOnTheRight(turn);
  }
  return hessian.bottomRightCorner(member.dimensions(), member.dimensions());
}

/// A violated contact and the derivatives of its value by the parameters of its strips.
struct Touch {
  int here = 0, there = 0;
  Eigen::VectorXd of_here, of_there;
};

/// Derivative of a point along a direction.
Eigen::VectorXd derivative_of(const Member& member, const StripPoint& point, const Vec3& along) {
  Eigen::VectorXd derivative = Eigen::VectorXd::Zero(member.p.size());
  for (const StripPoint::Share& share : point.shares)
    derivative += share.weight *
                  end_derivative(member.problem.base, member.fold, member.twists, share.side,
                                 share.ridge)
                      .transpose() *
                  along;
  return derivative;
}

void pull_at(Member& member, const StripPoint& point, const Vec3& force) {
  if (member.is_held) return;
  for (const StripPoint::Share& share : point.shares)
    member.pulled.push_back({share.ridge, share.side, share.weight * force});
}

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

/// Adds the contacts to the value and to the strips' gradients.
std::vector<Touch> touches(const StripSystem& system, std::vector<Member>& members, double& value) {
  std::vector<Touch> found;
  for (const Contact& contact : system.contacts) {
    Member &here = members[contact.here.strip], &there = members[contact.there.strip];
    const double violated = counted(system, contact,
                                    contact.here.in(here.fold) - contact.there.in(there.fold));
    if (violated == 0.0) continue;
    value += 0.5 * system.penalty * violated * violated;
    const Vec3 out = contact.normal / system.unit();
    Touch touch{contact.here.strip, contact.there.strip, derivative_of(here, contact.here, -out),
                derivative_of(there, contact.there, out)};
    const double force = system.penalty * violated;
    if (!here.is_held) here.model.gradient += force * touch.of_here;
    if (!there.is_held) there.model.gradient += force * touch.of_there;
    pull_at(here, contact.here, -force * out);
    pull_at(there, contact.there, force * out);
    if (touch.here > touch.there) {
      std::swap(touch.here, touch.there);
      std::swap(touch.of_here, touch.of_there);
    }
    found.push_back(std::move(touch));
  }
  return found;
}

/// Second derivatives of what touches, strip beside strip.
void add_touches(Model& model, double penalty, const std::vector<Touch>& touching) {
  std::map<std::pair<int, int>, std::vector<const Touch*>> by_strips;
  for (const Touch& touch : touching)
    by_strips[{touch.here, touch.there}].push_back(&touch);
  for (const auto& [strips, touches] : by_strips) {
    const Member &here = model.members[strips.first], &there = model.members[strips.second];
    const auto rank = static_cast<Eigen::Index>(touches.size());
    Eigen::MatrixXd a(here.dimensions(), rank), b(there.dimensions(), rank);
    for (Eigen::Index i = 0; i < rank; ++i) {
      if (!here.is_held) a.col(i) = here.along_manifold(touches[i]->of_here);
      if (!there.is_held) b.col(i) = there.along_manifold(touches[i]->of_there);
    }
    model.hessian.on_diagonal(strips.first).noalias() += penalty * a * a.transpose();
    model.hessian.on_diagonal(strips.second).noalias() += penalty * b * b.transpose();
    if (!here.is_held && !there.is_held)
      model.hessian.couple(strips.first, strips.second, penalty * a, std::move(b));
  }
}

Model model_of(const StripSystem& system, const Shapes& shapes) {
  std::vector<Member> members;
  std::vector<int> sizes;
  double value = 0.0, load = 0.0;
  for (int strip = 0; strip < system.count(); ++strip) {
    members.push_back(member_of(system, shapes, strip));
    sizes.push_back(members.back().dimensions());
    value += members.back().model.value;
    load += members.back().load;
  }
  const std::vector<Touch> touching = touches(system, members, value);
  BlockMatrix hessian(std::move(sizes));
  Model model{std::move(members), value, load, Eigen::VectorXd(hessian.dimensions()),
              std::move(hessian)};
  for (int strip = 0; strip < system.count(); ++strip) {
    Member& member = model.members[strip];
    if (member.is_held) continue;
    model.hessian.on_diagonal(strip) = hessian_along_manifold(member);
    model.gradient.segment(model.hessian.begin(strip),
                           member.dimensions()) = member.along_manifold(member.model.gradient);
  }
  add_touches(model, system.penalty, touching);
  return model;
}

/// The step that minimises a model within a reach, nearly: damped by just as much as that takes
/// (Moré and Sorensen). Where the model is concave along a direction the damping outweighs it.
/// `damping` is what to begin with, and what was found.
Eigen::VectorXd step_within(const Model& model, double reach, double& damping) {
  constexpr double kBeyond = 1.25, kShort = 0.5, kLeastDamping = 1e-5, kDampingFound = 1e-9,
                   kFaster = 16.0;
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
