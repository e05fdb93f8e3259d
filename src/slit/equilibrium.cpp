// What a strip at rest bears and what holds it (math.md#standing). Along no change of its numbers
// does a strip at rest gain, but for its conditions: their multipliers are forces and moments at
// its end, those of the ground push upwards. They are found anew from the shape, by least squares,
// and owe nothing to how it was found. The panel bears the rest. The strip stays where the second
// derivative of the Lagrange function is positive for all that conditions and contacts leave free;
// in a symmetric sheet also for what is not symmetric, as arches sway.
#include "equilibrium.hpp"

#include "bend_energy.hpp"
#include "design_load.hpp"
#include "end_curvature.hpp"
#include "load_potential.hpp"
#include "strip_objective.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kTouches = 1e-6;  // of the strip's length: ten times what inequalities keep

/// A force in the unit of the objective, per mm, at a point that is a mix of ends of ridges.
struct PointForce {
  StripPoint point;
  Vec3 force = Vec3::Zero();
};

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

std::vector<PointForce> pressed_on(const Snapshot& now, int strip) {
  std::vector<PointForce> all;
  for (const Contact& contact : now.pressing.contacts) {
    const Vec3 force = contact.multiplier / now.pressing.unit * contact.normal;
    if (contact.here.strip == strip) all.push_back({contact.here, force});
    if (contact.there.strip == strip) all.push_back({contact.there, -force});
  }
  return all;
}

/// What the other half of a sheet leaves free to the one half while it does the opposite.
std::vector<EndCondition> swaying(const Frame& last) {
  using Of = EndCondition::Of;
  return {{Of::middle, Vec3::UnitY(), 0.0},
          {Of::middle, Vec3::UnitZ(), 0.0},
          {Of::across, Vec3::UnitX().cross(last.y), 0.0}};
}

/// One strip at rest.
class Strip {
 public:
  Strip(const Snapshot& now, int strip)
      : strip_(strip),
        symmetric_(now.design->sheet.symmetric),
        problem_(problem_of(now, strip)),
        p_(now.slot(strip).p),
        fold_(folded(problem_.base, p_)),
        twists_(twists(problem_.base, fold_)),
        pressed_(pressed_on(now, strip)) {
    problem_.penalty = 1.0;  // inequalities that are kept count by their multipliers
    to_newtons_ = now.design->material->rigidity(now.design->sheet.thickness) /
                  energy_scale(problem_.base);
    model_ = objective_derivatives(problem_, p_);
    for (const PointForce& one : pressed_)
      model_.gradient -= along(one.point, one.force);
    if (const auto height = least_height(now, strip)) find_ground(*height);
    find_multipliers();
  }

  std::vector<SlitReaction> reactions() const {
    const StripBase& base = problem_.base;
    const Vec3 first = 0.5 * (fold_.end(0, 0) + fold_.end(1, 0)),
               last = 0.5 * (fold_.end(0, base.quads) + fold_.end(1, base.quads));
    const Wrench end = at_end(), ground = from_ground(), neighbours = from_neighbours(),
                 wishes = from_wishes();
    Wrench rest = from_load();
    for (const Wrench* one : {&end, &ground, &neighbours, &wishes})
      rest.add(*one);
    std::vector<SlitReaction> all{rest.reaction(strip_, HeldBy::panel, first, -to_newtons_)};
    if (!problem_.ends.empty()) all.push_back(end.reaction(strip_, HeldBy::end, last, to_newtons_));
    for (const auto& [one, by] :
         {std::pair{&ground, HeldBy::ground}, std::pair{&neighbours, HeldBy::neighbours},
          std::pair{&wishes, HeldBy::wishes}})
      if (!one->is_nothing()) all.push_back(one->reaction(strip_, by, one->middle(), to_newtons_));
    return all;
  }

  /// Of a strip that leans on others, or is kept from bending further, nothing is said against it.
  bool is_stable() const {
    if (!pressed_.empty() || !kept_limits().isZero(0.0)) return true;
    const Eigen::MatrixXd hessian = of_lagrange_function();
    if (!is_positive(hessian, problem_.ends)) return false;
    return !symmetric_ || is_positive(hessian, swaying(fold_.quad(problem_.base.quads - 1)));
  }

 private:
  Eigen::VectorXd along(const StripPoint& point, const Vec3& direction) const {
    Eigen::VectorXd derivative = Eigen::VectorXd::Zero(p_.size());
    for (const StripPoint::Share& share : point.shares)
      derivative += share.weight *
                    end_derivative(problem_.base, fold_, twists_, share.side, share.ridge)
                        .transpose() *
                    direction;
    return derivative;
  }

  void find_ground(double height) {
    for (int ridge = 1; ridge <= problem_.base.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        if (fold_.end(side, ridge).y() < height + kTouches * problem_.base.unit())
          ground_.push_back({StripPoint{strip_, {{side, ridge, 1.0}}}, Vec3::UnitY()});
  }

  /// By least squares; ground that would pull is left out, the worst first.
  void find_multipliers() {
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

  Wrench at_end() const {
    Wrench all;
    for (std::size_t i = 0; i < problem_.ends.size(); ++i) {
      const EndCondition& condition = problem_.ends[i];
      const Vec3 v = end_vector(condition.of, fold_, problem_.base.quads);
      const Vec3 pull = -multipliers_[static_cast<Eigen::Index>(i)] * condition.gradient;
      if (condition.is_length())
        all.add(v, pull / problem_.base.unit());
      else
        all.add_moment(v.cross(pull));
    }
    all.add_moment(energy_scale(problem_.base) * far_moment(problem_, p_));
    return all;
  }
  Wrench of(const std::vector<PointForce>& forces) const {
    Wrench all;
    for (const PointForce& one : forces)
      all.add(one.point.in(fold_), one.force);
    return all;
  }
  Wrench from_ground() const { return of(ground_); }
  Wrench from_neighbours() const { return of(pressed_); }
  Wrench from_wishes() const {
    Wrench all;
    for (const Pull& pull : pulls(problem_, fold_))
      all.add(fold_.end(pull.side, pull.ridge), -pull.gradient);
    return all;
  }
  Wrench from_load() const {
    Wrench all;
    const EndForces forces = end_forces(problem_.base, p_, problem_.load);
    for (int side = 0; side < 2; ++side)
      for (int ridge = 0; ridge <= problem_.base.quads; ++ridge)
        all.add(fold_.end(side, ridge), energy_scale(problem_.base) * forces[side][ridge]);
    return all;
  }

  Eigen::MatrixXd of_lagrange_function() const {
    std::vector<WeighedVector> sum = weighed_conditions(problem_, fold_, multipliers_);
    for (const Pull& pull : pulls(problem_, fold_))
      sum.push_back({pull.ridge, true, fold_.end(pull.side, pull.ridge), pull.gradient, pull.side});
    for (const auto* forces : {&ground_, &pressed_})
      for (const PointForce& one : *forces)
        for (const StripPoint::Share& share : one.point.shares)
          sum.push_back({share.ridge, true, fold_.end(share.side, share.ridge),
                         -share.weight * one.force, share.side});
    return model_.hessian + second_derivatives(problem_.base, p_, fold_, sum);
  }

  /// Derivatives of the limits that are kept, a column for each.
  Eigen::MatrixXd kept_limits() const {
    Eigen::VectorXd residuals(problem_.residuals());
    RowMatrix jacobian(problem_.residuals(), problem_.parameters());
    Eigen::Ref<RowMatrix> ref(jacobian);
    evaluate(problem_, p_, residuals, &ref);
    return jacobian.bottomRows(std::ssize(problem_.inequalities)).transpose();
  }

  /// Along what an end's conditions, limits, the ground and pressed neighbours leave free.
  bool is_positive(const Eigen::MatrixXd& hessian, const std::vector<EndCondition>& ends) const {
    StripProblem with_ends = problem_;
    with_ends.ends = ends;
    const Eigen::VectorXd units = units_of(problem_.base);
    const auto count = static_cast<Eigen::Index>(ends.size());
    const Eigen::MatrixXd limits = kept_limits();
    Eigen::MatrixXd held(p_.size(),
                         count + limits.cols() + std::ssize(ground_) + std::ssize(pressed_));
    held.leftCols(count) = end_derivative(with_ends, fold_).transpose();
    held.middleCols(count, limits.cols()) = limits;
    Eigen::Index column = count + limits.cols();
    for (const auto* forces : {&ground_, &pressed_})
      for (const PointForce& one : *forces)
        held.col(column++) = along(one.point, one.force);
    Eigen::MatrixXd turned = units.asDiagonal() * hessian * units.asDiagonal();
    Eigen::Index rank = 0;
    if (held.cols() > 0) {
      held = units.asDiagonal() * held;
      for (Eigen::Index i = 0; i < held.cols(); ++i)
        held.col(i).normalize();  // one that is zero stays so
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> split(held);
      rank = split.rank();
      turned.applyOnTheLeft(split.householderQ().adjoint());
      turned.applyOnTheRight(split.householderQ());
    }
    const Eigen::Index free = p_.size() - rank;
    Eigen::MatrixXd left = turned.bottomRightCorner(free, free);
    // A descent ends where it gains next to nothing, so less than that is no loss of stability.
    constexpr double kNextToNothing = 3e-5;
    left.diagonal().array() += kNextToNothing * (model_.value - load_part(problem_, p_)) +
                               tolerance::kRounding * turned.diagonal().cwiseAbs().maxCoeff();
    return left.llt().info() == Eigen::Success;
  }

  int strip_;
  bool symmetric_;
  StripProblem problem_;
  StripParameters p_;
  StripFold fold_;
  std::vector<Twist> twists_;
  std::vector<PointForce> pressed_, ground_;
  SecondOrder model_;
  Eigen::VectorXd multipliers_;
  double to_newtons_ = 0.0;
};

void add_strip(SlitEquilibrium& all, const Snapshot& now, int strip) {
  const SlitDesign& design = *now.design;
  const double thickness = design.sheet.thickness;
  const bool is_bent = now.slot(strip).p.size() > 0;
  const double curvature = is_bent ? largest_curvature(problem_of(now, strip), now.slot(strip).p)
                                   : 0.0;
  all.stress.push_back(design.material->stress(thickness, curvature));
  const double kept = design.material->yield && curvature > 0.0
                          ? design.material->kept_curvature(thickness, curvature)
                          : 0.0;
  all.kept_radius.push_back(kept > 0.0 ? std::optional(1.0 / kept) : std::nullopt);
  if (design.objective != SlitObjective::energy) return;
  if (!is_bent) return all.is_stable.push_back(true);
  const Strip one(now, strip);
  all.is_stable.push_back(one.is_stable());
  for (SlitReaction& reaction : one.reactions())
    all.reactions.push_back(std::move(reaction));
}

}  // namespace

std::optional<SlitEquilibrium> equilibrium_of(const Snapshot& now) {
  if (!now.design->material) return std::nullopt;
  SlitEquilibrium all;
  for (int strip = 0; strip < now.count(); ++strip)
    add_strip(all, now, strip);
  all.standing = standing_of(folded_sheet(now), *now.design);
  return all;
}

}  // namespace planish::slit_detail
