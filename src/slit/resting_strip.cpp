// A strip at rest. Along no change of its numbers does it gain, but for what holds it: multipliers
// of conditions are forces and moments at its end, those of the ground push upwards, those of a
// least radius bend it open (math.md#standing).
#include "resting_strip.hpp"

#include "end_curvature.hpp"
#include "load_potential.hpp"
#include "strip_objective.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kTouches = 1e-6;  // of the strip's length: ten times what inequalities keep

/// Forces that act together.
class Wrench {
 public:
  void add(const Vec3& at, const Vec3& force) {
    force_ += force;
    moment_ += at.cross(force);
    weighed_ += force.norm() * at;
    weight_ += force.norm();
  }
  void add_moment(const Vec3& moment) { moment_ += moment; }
  void add(const Wrench& other) {
    force_ += other.force_;
    moment_ += other.moment_;
  }
  bool is_nothing() const { return weight_ == 0.0; }
  Vec3 middle() const { return weighed_ / weight_; }

  SlitReaction reaction(int strip, HeldBy end, const Vec3& at, double scale) const {
    return {strip, end, scale * force_, scale * (moment_ - at.cross(force_)), at};
  }

 private:
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero(), weighed_ = Vec3::Zero();
  double weight_ = 0.0;
};

Wrench wrench_of(const StripFold& fold, const std::vector<PointForce>& forces) {
  Wrench all;
  for (const PointForce& one : forces)
    all.add(one.point.in(fold), one.force);
  return all;
}

Wrench wrench_at_end(const StripProblem& problem, const StripParameters& p, const StripFold& fold,
                     const Eigen::VectorXd& multipliers) {
  Wrench all;
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const Vec3 v = end_vector(condition.of, problem.base, fold);
    const Vec3 pull = -multipliers[static_cast<Eigen::Index>(i)] * condition.gradient;
    if (condition.is_length())
      all.add(v, pull / problem.base.unit());
    else
      all.add_moment(v.cross(pull));
  }
  all.add_moment(energy_scale(problem.base) * far_moment(problem, p));
  return all;
}

Wrench wrench_of_wishes(const StripProblem& problem, const StripFold& fold) {
  Wrench all;
  for (const Pull& pull : pulls(problem, fold))
    all.add(fold.end(pull.side, pull.ridge), -pull.gradient);
  return all;
}

Wrench wrench_of_load(const StripProblem& problem, const StripFold& fold) {
  Wrench all;
  const EndForces forces = end_forces(problem.base, fold, problem.load);
  for (int side = 0; side < 2; ++side)
    for (int ridge = 0; ridge <= problem.base.quads; ++ridge)
      all.add(fold.end(side, ridge), energy_scale(problem.base) * forces[side][ridge]);
  return all;
}

}  // namespace

RestingStrip::RestingStrip(StripProblem problem, StripParameters p, std::vector<PointForce> pressed,
                           std::optional<double> ground)
    : problem_(std::move(problem)),
      p_(std::move(p)),
      fold_(folded(problem_.base, p_)),
      twists_(twists(problem_.base, fold_)),
      pressed_(std::move(pressed)) {
  problem_.penalty = 1.0;  // inequalities that are kept count by their multipliers
  model_ = objective_derivatives(problem_, p_);
  for (const PointForce& one : pressed_)
    model_.gradient -= along(one.point, one.force);
  if (ground) find_ground(*ground);
  find_multipliers();
}

Eigen::VectorXd RestingStrip::along(const StripPoint& point, const Vec3& direction) const {
  Eigen::VectorXd derivative = Eigen::VectorXd::Zero(p_.size());
  for (const StripPoint::Share& share : point.shares)
    derivative += share.weight *
                  end_derivative(problem_.base, fold_, twists_, share.side, share.ridge)
                      .transpose() *
                  direction;
  return derivative;
}

Eigen::Matrix3Xd RestingStrip::turning(int quad, const Vec3& direction) const {
  Eigen::Matrix3Xd turned = Eigen::Matrix3Xd::Zero(3, p_.size());
  for (Eigen::Index q = 0; q < p_.size(); ++q)
    if (twists_[q].ridge <= quad) turned.col(q) = twists_[q].axis.cross(direction);
  return turned;
}

void RestingStrip::find_ground(double height) {
  for (int ridge = 1; ridge <= problem_.base.quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      if (fold_.end(side, ridge).y() < height + kTouches * problem_.base.unit())
        ground_.push_back({StripPoint{0, {{side, ridge, 1.0}}}, Vec3::UnitY()});
}

/// By least squares; ground that would pull is left out, the worst first.
void RestingStrip::find_multipliers() {
  const Eigen::VectorXd units = units_of(problem_.base);
  while (true) {
    const auto ends = static_cast<Eigen::Index>(problem_.ends.size());
    if (ends == 0 && ground_.empty()) return;
    Eigen::MatrixXd of(p_.size(), ends + std::ssize(ground_));
    of.leftCols(ends) = end_derivative(problem_, fold_).transpose();
    for (Eigen::Index i = 0; i < std::ssize(ground_); ++i)
      of.col(ends + i) = -along(ground_[i].point, Vec3::UnitY());
    const Eigen::VectorXd found = (units.asDiagonal() * of)
                                      .eval()
                                      .completeOrthogonalDecomposition()
                                      .solve(-units.cwiseProduct(model_.gradient));
    multipliers_ = found.head(ends);
    for (Eigen::Index i = 0; i < std::ssize(ground_); ++i)
      ground_[i].force = found[ends + i] * Vec3::UnitY();
    const auto worst = std::ranges::min_element(
        ground_, {}, [](const PointForce& one) { return one.force.y(); });
    if (worst == ground_.end() || worst->force.y() >= 0.0) return;
    ground_.erase(worst);
  }
}

std::vector<SlitReaction> RestingStrip::reactions(int strip, double to_newtons) const {
  const StripBase& base = problem_.base;
  const Vec3 first = 0.5 * (fold_.end(0, 0) + fold_.end(1, 0)),
             last = 0.5 * (fold_.end(0, base.quads) + fold_.end(1, base.quads));
  const Wrench end = wrench_at_end(problem_, p_, fold_, multipliers_),
               ground = wrench_of(fold_, ground_), neighbours = wrench_of(fold_, pressed_),
               wishes = wrench_of_wishes(problem_, fold_);
  Wrench rest = wrench_of_load(problem_, fold_);
  for (const Wrench* one : {&end, &ground, &neighbours, &wishes})
    rest.add(*one);
  std::vector<SlitReaction> all{rest.reaction(strip, HeldBy::panel, first, -to_newtons)};
  if (!problem_.ends.empty()) all.push_back(end.reaction(strip, HeldBy::end, last, to_newtons));
  for (const auto& [one, by] :
       {std::pair{&ground, HeldBy::ground}, std::pair{&neighbours, HeldBy::neighbours},
        std::pair{&wishes, HeldBy::wishes}})
    if (!one->is_nothing()) all.push_back(one->reaction(strip, by, one->middle(), to_newtons));
  return all;
}

Eigen::MatrixXd RestingStrip::of_lagrange_function() const {
  std::vector<WeighedVector> sum = weighed_conditions(problem_, fold_, multipliers_);
  for (const Pull& pull : pulls(problem_, fold_))
    sum.push_back({pull.ridge, true, fold_.end(pull.side, pull.ridge), pull.gradient, pull.side});
  for (const auto* forces : {&ground_, &pressed_})
    for (const PointForce& one : *forces)
      for (const StripPoint::Share& share : one.point.shares)
        sum.push_back({share.ridge, true, fold_.end(share.side, share.ridge),
                       -share.weight * one.force, share.side});
  return model_.hessian + second_derivatives(problem_.base, p_, fold_, sum) +
         limit_curvature(problem_, p_);
}

Eigen::MatrixXd RestingStrip::kept_limits() const {
  Eigen::VectorXd residuals(problem_.residuals());
  RowMatrix jacobian(problem_.residuals(), problem_.parameters());
  Eigen::Ref<RowMatrix> ref(jacobian);
  evaluate(problem_, p_, residuals, &ref);
  return jacobian.bottomRows(std::ssize(problem_.inequalities)).transpose();
}

Eigen::MatrixXd RestingStrip::held(const std::vector<EndCondition>& ends) const {
  StripProblem with_ends = problem_;
  with_ends.ends = ends;
  std::vector<Eigen::MatrixXd> parts{end_derivative(with_ends, fold_).transpose(), kept_limits()};
  for (const PointForce& one : ground_)
    parts.emplace_back(along(one.point, Vec3::UnitY()));
  for (const Pull& pull : pulls(problem_, fold_))
    if (!pull.gradient.isZero(0.0))
      parts.emplace_back(
          end_derivative(problem_.base, fold_, twists_, pull.side, pull.ridge).transpose());
  Eigen::Index count = 0;
  for (const Eigen::MatrixXd& part : parts)
    count += part.cols();
  Eigen::MatrixXd all(p_.size(), count);
  count = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(count, part.cols()) = part;
    count += part.cols();
  }
  return all;
}

double RestingStrip::next_to_nothing() const {
  constexpr double kShare = 3e-5;
  return kShare * (model_.value - load_part(problem_, p_));
}

}  // namespace planish::slit_detail
