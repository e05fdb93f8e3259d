#include "strip_solver.hpp"

#include "first_shape.hpp"
#include "reach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

namespace planish::slit_detail {
namespace {

constexpr double kHolds = 1e-7;        // of an inequality
constexpr double kFirstPenalty = 1.0;  // a tenth of the strip's length then counts as much as its
                                       // smoothness
constexpr double kPenaltyGrowth = 4.0;
constexpr int kRounds = 10, kStepsOfRound = 20;
constexpr double kMargin = 2e-4;  // radii are led to so much more than they need, and then have it
constexpr double kWorth = 20.0;   // times the objective that keeping an inequality may cost
constexpr double kRoughly = 1e-3,
                 kFine = 1e-6;  // gains of an iteration at which a start, a round are left

bool same_place(const RadiusLimit& a, const RadiusLimit& b) {
  return a.ridge == b.ridge && a.side == b.side && a.quad == b.quad;
}
bool same_place(const HalfSpace& a, const HalfSpace& b) {
  return a.ridge == b.ridge && a.side == b.side && a.normal.dot(b.normal) > 0.5;
}

/// Adds what is not yet in the list; planes that moved take over their multiplier.
template <typename Limit>
bool add(std::vector<Inequality>& list, const Limit& limit) {
  for (Inequality& known : list)
    if (auto* other = std::get_if<Limit>(&known.what); other && same_place(*other, limit)) {
      *other = limit;
      return false;
    }
  list.push_back({limit, 0.0});
  return true;
}

/// Whether every other ridge is one that dividing the quads has put in, without a fold.
bool just_divided(const StripBase& base, const StripParameters& p) {
  if (base.quads % 2 != 0) return false;
  bool any = false;
  for (int ridge = 0; ridge < base.quads; ridge += 2) {
    any |= p[ridge] != 0.0;
    if (p[ridge + 1] != 0.0) return false;
  }
  return any;
}

/// New ridges take a quarter of each neighbour's fold: nearly the same shape, and smooth where it
/// was.
StripParameters shared_out(const StripBase& base, const StripParameters& p) {
  StripParameters shared = p;
  shared[0] = 0.75 * p[0];
  for (int ridge = 2; ridge < base.quads; ridge += 2)
    shared[ridge] = 0.5 * p[ridge];
  for (int ridge = 1; ridge < base.quads; ridge += 2)
    shared[ridge] = 0.25 * (p[ridge - 1] + (ridge + 1 < base.quads ? p[ridge + 1] : 0.0));
  return shared;
}

/// Folds evened out between neighbours, none lost.
StripParameters smoothed(const StripBase& base, const StripParameters& p) {
  StripParameters even = p;
  for (int ridge = 0; ridge < base.quads; ++ridge) {
    const double before = p[std::max(ridge - 1, 0)], after = p[std::min(ridge + 1, base.quads - 1)];
    even[ridge] = 0.25 * (before + 2.0 * p[ridge] + after);
  }
  return even;
}

class Solver {
 public:
  Solver(StripProblem problem, const DescentOptions& options, const PlanesBroken& planes_broken)
      : problem_(std::move(problem)),
        options_(options),
        planes_broken_(planes_broken),
        least_radius_(problem_.min_radius) {
    problem_.penalty = kFirstPenalty;
    problem_.min_radius *= 1.0 + kMargin;
  }

  StripSolution run(const StripParameters& from) {
    if (!reach_from_before(from)) begin();
    if (solution_.reached) {
      descend_once();
      hold_inequalities();
    }
    solution_.inequalities = std::move(problem_.inequalities);
    return std::move(solution_);
  }

 private:
  bool reach_from_before(const StripParameters& from) {
    if (from.size() != problem_.parameters()) return false;
    return (just_divided(problem_.base, from) && reach_divided(shared_out(problem_.base, from))) ||
           reach_from(from);
  }

  /// Of the divided shape, evened out more and more, what is nearest to a minimum: of fine strips
  /// the least unevenness weighs more than all else, and getting rid of it step by step would
  /// crease them.
  bool reach_divided(StripParameters from) {
    std::optional<StripSolution> best;
    constexpr int kPasses = 6;
    for (int pass = 0; pass < kPasses; ++pass, from = smoothed(problem_.base, from)) {
      violation_ = std::numeric_limits<double>::infinity();
      if (!reach_from(from)) continue;
      solution_.objective = objective();
      if (!best || solution_.objective < best->objective) best = solution_;
    }
    if (best) solution_ = *best;
    return best.has_value();
  }

  bool reach_from(const StripParameters& from) {
    if (!is_shape(problem_.base, from)) return false;
    const Reach reach = meet_ends(problem_, from);
    solution_.iterations += reach.iterations;
    if (reach.violation < violation_) {
      solution_.p = reach.p;
      violation_ = reach.violation;
      solution_.reached = reach.met();
    }
    return reach.met();
  }

  void begin() {
    for (const StripParameters& shape : first_shapes(problem_))
      if (reach_from(shape)) return descend_softly();
  }

  bool stopped() const { return options_.stop && options_.stop(); }

  /// From a first shape, straight to the places wanted, leads into folds that no later step undoes;
  /// so they first draw weakly, and need not be reached well.
  void descend_softly() {
    constexpr int kSteps = 12;
    const SlitWeights given = problem_.weights;
    for (const double softness : {0.001, 0.1}) {
      problem_.weights.anchors = softness * given.anchors;
      problem_.weights.seat = softness * given.seat;
      problem_.weights.spread = softness * given.spread;
      problem_.weights.scan = softness * given.scan;
      descend_by(kSteps, kRoughly);
    }
    problem_.weights = given;
  }

  void descend_once() { descend_by(options_.max_iterations, options_.function_tolerance); }

  void descend_by(int iterations, double tolerance) {
    DescentOptions rest = options_;
    rest.max_iterations = std::min(options_.max_iterations - descended_, iterations);
    if (rest.max_iterations <= 0) {
      solution_.converged = false;
      return;
    }
    rest.function_tolerance = tolerance;
    const Descent descent = descend(problem_, solution_.p, rest);
    solution_.p = descent.p;
    solution_.objective = descent.objective;
    solution_.converged = descent.converged && !stopped();
    descended_ += descent.iterations;
    solution_.iterations += descent.iterations;
  }

  std::vector<HalfSpace> planes_now_broken() const {
    return planes_broken_ ? planes_broken_(folded_strip(problem_.base, solution_.p))
                          : std::vector<HalfSpace>{};
  }

  /// Without what inequalities add to it.
  double objective() const {
    StripProblem plain = problem_;
    plain.inequalities.clear();
    Eigen::VectorXd residuals(plain.residuals());
    return evaluate(plain, solution_.p, residuals, nullptr)
               ? 0.5 * residuals.squaredNorm()
               : std::numeric_limits<double>::infinity();
  }
  double radius() const { return tightest_fold(problem_.base, solution_.p).radius; }
  bool is_too_tight() const { return least_radius_ > 0.0 && radius() < least_radius_; }

  /// Takes in what the shape breaks.
  bool take_in(const std::vector<HalfSpace>& planes) {
    for (const HalfSpace& plane : planes)
      add(problem_.inequalities, plane);
    const bool tight = is_too_tight();
    if (tight)
      for (const RadiusLimit& limit :
           radius_limits(problem_.base, solution_.p, problem_.min_radius))
        add(problem_.inequalities, limit);
    return tight || !planes.empty();
  }

  /// First the radii alone. A way out of a neighbour that creases the strip is none: then it is
  /// left as it was.
  void hold_inequalities() {
    hold_radii();
    if (!solution_.converged || planes_now_broken().empty()) return;
    const StripSolution before = solution_;
    const double most = kWorth * objective();
    const std::vector<Inequality> needed = problem_.inequalities;
    const bool was_too_tight = is_too_tight();
    hold(Planes::kept);
    const bool creased = (is_too_tight() && !was_too_tight) || objective() > most;
    if (!stopped() && (creased || !planes_now_broken().empty())) take_back(before, needed);
    settle();
  }

  /// Where no shape was found that keeps the radii, the one that is bent least tightly at no great
  /// cost stands.
  void hold_radii() {
    const std::vector<Inequality> none_needed = problem_.inequalities;
    StripSolution widest = solution_;
    double widest_radius = radius();
    const double most = kWorth * objective();
    hold(Planes::left_out, [&] {
      if (radius() <= widest_radius || objective() > most) return;
      widest = solution_;
      widest_radius = radius();
    });
    if (!stopped() && is_too_tight()) take_back(widest, none_needed);
  }

  void take_back(const StripSolution& before, const std::vector<Inequality>& inequalities) {
    solution_.p = before.p;
    solution_.objective = before.objective;
    problem_.inequalities = inequalities;
  }

  /// Rounds end before they converge, on purpose; what counts is that there was time for all of
  /// them.
  void settle() { solution_.converged = !stopped() && descended_ < options_.max_iterations; }

  enum class Planes { left_out, kept };
  void hold(
      Planes which, const std::function<void()>& after_round = [] {}) {
    problem_.penalty = kFirstPenalty;
    for (int round = 0;
         round < kRounds && solution_.converged && descended_ < options_.max_iterations; ++round) {
      const bool any = take_in(which == Planes::kept ? planes_now_broken()
                                                     : std::vector<HalfSpace>{});
      if (problem_.inequalities.empty()) return;
      const Eigen::VectorXd values = inequality_values(problem_, solution_.p);
      if (!any && radius_values_hold(values)) return;
      if (round > 0) {
        problem_.penalty *= kPenaltyGrowth;
        update_multipliers(values);
      }
      descend_by(kStepsOfRound, std::max(options_.function_tolerance, kFine));
      settle();
      after_round();
    }
  }

  bool radius_values_hold(const Eigen::VectorXd& values) const {
    for (std::size_t i = 0; i < problem_.inequalities.size(); ++i)
      if (std::holds_alternative<RadiusLimit>(problem_.inequalities[i].what) &&
          values[static_cast<Eigen::Index>(i)] > kHolds)
        return false;
    return true;
  }

  /// Planes are only there to lead the strip out of what it runs through: a penalty does, and a
  /// multiplier would throw it into another shape.
  void update_multipliers(const Eigen::VectorXd& values) {
    for (std::size_t i = 0; i < problem_.inequalities.size(); ++i) {
      Inequality& inequality = problem_.inequalities[i];
      if (std::holds_alternative<RadiusLimit>(inequality.what))
        inequality.multiplier = std::max(
            0.0, inequality.multiplier + problem_.penalty * values[static_cast<Eigen::Index>(i)]);
    }
  }

  StripProblem problem_;
  const DescentOptions& options_;
  const PlanesBroken& planes_broken_;
  double least_radius_;
  StripSolution solution_;
  int descended_ = 0;
  double violation_ = std::numeric_limits<double>::infinity();
};

}  // namespace

StripSolution solve_strip(StripProblem problem, const StripParameters& from,
                          const DescentOptions& options, const PlanesBroken& planes_broken) {
  return Solver(std::move(problem), options, planes_broken).run(from);
}

}  // namespace planish::slit_detail
