#include "reach.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace planish::slit_detail {
namespace {

constexpr double kReadinessOfAbscissae = 0.05;
constexpr double kLargestTurn = 0.25;  // radians in one step

double largest(const Eigen::VectorXd& v) { return v.size() ? v.cwiseAbs().maxCoeff() : 0.0; }

Eigen::VectorXd least_step(const StripProblem& problem, const StripFold& fold, const Eigen::VectorXd& violation, double damping) {
  const RowMatrix derivative = end_derivative(problem, fold);
  RowMatrix weighed = derivative;
  weighed.rightCols(weighed.cols() - problem.base.quads) *= kReadinessOfAbscissae;
  Eigen::MatrixXd normal = weighed * derivative.transpose();
  normal.diagonal().array() += damping;
  return -weighed.transpose() * normal.ldlt().solve(violation);
}

/// The largest share of the step that keeps folds and spacings within bounds.
double allowed_share(const StripBase& base, const StripParameters& p, const Eigen::VectorXd& step) {
  constexpr double kSpacingKept = 0.5;
  double share = std::min(1.0, kLargestTurn / std::max(1e-300, step.head(base.quads).cwiseAbs().maxCoeff()));
  const StripParameters after = p + step;
  for (int quad = 0; quad < base.quads; ++quad)
    for (int side = 0; side < 2; ++side) {
      const double now = abscissa(base, p, quad + 1, side) - abscissa(base, p, quad, side);
      const double then = abscissa(base, after, quad + 1, side) - abscissa(base, after, quad, side);
      if (then < kSpacingKept * now) share = std::min(share, (1.0 - kSpacingKept) * now / (now - then));
    }
  return share;
}

}  // namespace

Reach meet_ends(const StripProblem& problem, const StripParameters& from, int max_iterations) {
  Reach reach{from, 0.0, 0};
  StripFold fold = folded(problem.base, reach.p);
  Eigen::VectorXd violation = end_violation(problem, fold);
  double damping = 1e-6;
  constexpr double kGivenUp = 1e8;
  for (; reach.iterations < max_iterations && largest(violation) > 1e-2 * kEndsMet && damping < kGivenUp; ++reach.iterations) {
    const Eigen::VectorXd step = least_step(problem, fold, violation, damping);
    const StripParameters next = reach.p + allowed_share(problem.base, reach.p, step) * step;
    StripFold next_fold = folded(problem.base, next);
    Eigen::VectorXd next_violation = end_violation(problem, next_fold);
    if (next_violation.squaredNorm() < violation.squaredNorm()) {
      reach.p = next;
      fold = std::move(next_fold);
      violation = std::move(next_violation);
      damping *= 0.1;
    } else {
      if (largest(violation) <= kEndsMet) break;
      damping = std::max(10.0 * damping, 1e-9);
    }
  }
  reach.violation = largest(violation);
  return reach;
}

EndTangent::EndTangent(const StripProblem& problem, const StripParameters& p)
    : qr_(end_derivative(problem, folded(problem.base, p)).transpose()) {}

Eigen::VectorXd EndTangent::step(const Eigen::VectorXd& tangent) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(qr_.rows());
  all.tail(tangent.size()) = tangent;
  return qr_.householderQ() * all;
}

Eigen::MatrixXd EndTangent::basis() const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(qr_.rows(), dimensions());
  all.bottomRows(dimensions()).setIdentity();
  return qr_.householderQ() * all;
}

std::optional<StripParameters> moved_on_ends(const StripProblem& problem, const StripParameters& moved) {
  constexpr int kIterations = 12;
  StripParameters p = moved;
  double before = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    if (!is_shape(problem.base, p)) return std::nullopt;
    const StripFold fold = folded(problem.base, p);
    const Eigen::VectorXd violation = end_violation(problem, fold);
    const double missed = largest(violation);
    const bool at_rounding = i > 0 && missed >= 0.25 * before;
    if (missed <= 1e-2 * kEndsMet || (missed <= kEndsMet && at_rounding)) return p;
    if (at_rounding && i > 3) return std::nullopt;
    before = missed;
    p += least_step(problem, fold, violation, 0.0);
  }
  return std::nullopt;
}

}  // namespace planish::slit_detail
