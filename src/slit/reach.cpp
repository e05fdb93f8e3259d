#include "reach.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>

// Shapes that meet the end conditions (math.md#strip-conditions, docs/decisions/0002). Damped
// Gauss–Newton steps of least norm lead to one, none longer than keeps folds and spacings in
// bounds. About it the conditions are eliminated: an orthogonal matrix splits the parameters into
// as many as there are conditions, which follow by Newton's method, and the null space, which is
// free. Derivatives follow by implicit functions.

namespace planish::slit_detail {
namespace {

constexpr double kReadinessOfAbscissae = 0.05;
/// The accuracy that steps aim at, so that the conditions are met with a margin.
constexpr double kAimedAt = 1e-2 * kEndsMet;

double largest(const Eigen::VectorXd& v) { return v.size() ? v.cwiseAbs().maxCoeff() : 0.0; }

Eigen::VectorXd least_step(const StripProblem& problem, const StripFold& fold,
                           const Eigen::VectorXd& violation, double damping) {
  const RowMatrix derivative = end_derivative(problem, fold);
  RowMatrix weighed = derivative;
  weighed.rightCols(weighed.cols() - problem.base.quads) *= kReadinessOfAbscissae;
  Eigen::MatrixXd normal = weighed * derivative.transpose();
  normal.diagonal().array() += damping;
  return -weighed.transpose() * normal.ldlt().solve(violation);
}

/// The largest share of the step that keeps folds and spacings within bounds.
double allowed_share(const StripBase& base, const StripParameters& p, const Eigen::VectorXd& step,
                     double largest_turn, double spacing_kept) {
  double share = std::min(
      1.0,
      largest_turn / std::max(tolerance::kTiniest, step.head(base.quads).cwiseAbs().maxCoeff()));
  const StripParameters after = p + step;
  for (int quad = 0; quad < base.quads; ++quad)
    for (int side = 0; side < 2; ++side) {
      const double now = abscissa(base, p, quad + 1, side) - abscissa(base, p, quad, side);
      const double then = abscissa(base, after, quad + 1, side) - abscissa(base, after, quad, side);
      if (then < spacing_kept * now)
        share = std::min(share, (1.0 - spacing_kept) * now / (now - then));
    }
  return share;
}

}  // namespace

Reach meet_ends(const StripProblem& problem, const StripParameters& from, int max_iterations) {
  Reach reach{from, 0.0, 0};
  StripFold fold = folded(problem.base, reach.p);
  Eigen::VectorXd violation = end_violation(problem, fold);
  constexpr double kFirstDamping = 1e-6, kLeastDamping = 1e-9;
  double damping = kFirstDamping;
  constexpr double kGivenUp = 1e8, kLargestTurn = 0.25, kSpacingKept = 0.5;
  for (; reach.iterations < max_iterations && largest(violation) > kAimedAt && damping < kGivenUp;
       ++reach.iterations) {
    const Eigen::VectorXd step = least_step(problem, fold, violation, damping);
    const StripParameters next = reach.p + allowed_share(problem.base, reach.p, step, kLargestTurn,
                                                         kSpacingKept) *
                                               step;
    StripFold next_fold = folded(problem.base, next);
    Eigen::VectorXd next_violation = end_violation(problem, next_fold);
    if (next_violation.squaredNorm() < violation.squaredNorm() && is_shape(problem.base, next)) {
      reach.p = next;
      fold = std::move(next_fold);
      violation = std::move(next_violation);
      damping *= 0.1;
    } else {
      if (largest(violation) <= kEndsMet) break;
      damping = std::max(10.0 * damping, kLeastDamping);
    }
  }
  reach.violation = largest(violation);
  return reach;
}

namespace {

/// A flat strip turns sideways only to second order, so its conditions do not determine everything:
/// take the solution of least norm.
Eigen::MatrixXd solved(const Eigen::MatrixXd& conditions, const Eigen::MatrixXd& right) {
  return conditions.completeOrthogonalDecomposition().solve(right);
}

}  // namespace

EndChart::EndChart(const StripProblem& problem, const StripParameters& at)
    : problem_(problem),
      origin_(at),
      qr_(end_derivative(problem, folded(problem.base, at)).transpose()) {}

std::optional<StripParameters> EndChart::shape(const Eigen::Ref<const Eigen::VectorXd>& xi) const {
  constexpr int kIterations = 15;
  constexpr double kDiverging = 1e-3;
  const int eliminated = conditions();
  Eigen::VectorXd turned = Eigen::VectorXd::Zero(qr_.rows());
  turned.tail(xi.size()) = xi;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kIterations; ++i) {
    StripParameters p = origin_ + qr_.householderQ() * turned;
    if (!is_shape(problem_.base, p)) return std::nullopt;
    if (eliminated == 0) return p;
    const StripFold fold = folded(problem_.base, p);
    const Eigen::VectorXd violation = end_violation(problem_, fold);
    const double missed = largest(violation);
    if (missed <= kAimedAt || (missed <= kEndsMet && missed >= 0.25 * before)) return p;
    if (missed > before && missed > kDiverging) return std::nullopt;
    before = missed;
    RowMatrix conditions = end_derivative(problem_, fold);
    conditions.applyOnTheRight(qr_.householderQ());
    turned.head(eliminated) -= solved(conditions.leftCols(eliminated), violation);
  }
  return std::nullopt;
}

RowMatrix EndChart::derivative(const StripParameters& shape, RowMatrix jacobian) const {
  const int eliminated = conditions();
  if (eliminated == 0) return jacobian;
  RowMatrix conditions = end_derivative(problem_, folded(problem_.base, shape));
  conditions.applyOnTheRight(qr_.householderQ());
  jacobian.applyOnTheRight(qr_.householderQ());
  const Eigen::MatrixXd following = solved(conditions.leftCols(eliminated),
                                           conditions.rightCols(dimensions()));
  return jacobian.rightCols(dimensions()) - jacobian.leftCols(eliminated) * following;
}

}  // namespace planish::slit_detail
