// The second derivative of a system's objective along the manifold of shapes that meet the end
// conditions is that of the Lagrange function: multipliers of the conditions times their curvature
// are added to the objective's own, and the tangent space is left (math.md#bending-energy). Strips
// that touch, or that bonds couple, share blocks of low rank beside the diagonal only.
#include "newton_model.hpp"

#include "end_curvature.hpp"
#include "strip_objective.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace planish::slit_detail {
namespace {

WeighedVector weighed(const StripFold& fold, const Pull& pull) {
  return {pull.ridge, true, fold.end(pull.side, pull.ridge), pull.gradient, pull.side};
}

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

/// The strip of the lower number first.
Touch in_order(Touch touch) {
  if (touch.here > touch.there) {
    std::swap(touch.here, touch.there);
    std::swap(touch.of_here, touch.of_there);
  }
  return touch;
}

void pull_at(Member& member, const StripPoint& point, const Vec3& force) {
  if (member.is_held) return;
  for (const StripPoint::Share& share : point.shares)
    member.pulled.push_back({share.ridge, share.side, share.weight * force});
}

/// Adds the contacts to the value and to the strips' gradients.
std::vector<Touch> touches(const StripSystem& system, std::vector<Member>& members, double& value) {
  std::vector<Touch> found;
  const ContactMeasure measure(system);
  for (const Contact& contact : system.contacts) {
    Member &here = members[contact.here.strip], &there = members[contact.there.strip];
    const Vec3 apart = contact.here.in(here.fold) - contact.there.in(there.fold);
    const double violated = measure.counted(contact, apart);
    if (violated == 0.0) continue;
    value += 0.5 * system.penalty * violated * violated;
    const Vec3 out = direction_of(contact, apart) / measure.unit;
    Touch touch{contact.here.strip, contact.there.strip, derivative_of(here, contact.here, -out),
                derivative_of(there, contact.there, out)};
    const double force = system.penalty * violated;
    if (!here.is_held) here.model.gradient += force * touch.of_here;
    if (!there.is_held) there.model.gradient += force * touch.of_there;
    pull_at(here, contact.here, -force * out);
    pull_at(there, contact.there, force * out);
    found.push_back(in_order(std::move(touch)));
    if (contact.of_gap != GapLimit::most) continue;
    // The sphere is bent: a share of the force stands against what moves along it.
    const Frame sphere = frame_from_normal(Vec3::Zero(), apart.normalized());
    for (const Vec3& aside : {sphere.x, sphere.y}) {
      const Vec3 along = std::sqrt(violated / (apart.norm() * measure.unit)) * aside;
      found.push_back(in_order({contact.here.strip, contact.there.strip,
                                derivative_of(here, contact.here, along),
                                derivative_of(there, contact.there, -along)}));
    }
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
    Eigen::MatrixXd a(here.p.size(), rank), b(there.p.size(), rank);
    for (Eigen::Index i = 0; i < rank; ++i) {
      a.col(i) = touches[i]->of_here;
      b.col(i) = touches[i]->of_there;
    }
    if (!here.is_held) a = here.along_manifold(a);
    if (!there.is_held) b = there.along_manifold(b);
    if (!here.is_held)
      model.hessian.on_diagonal(strips.first).noalias() += penalty * a * a.transpose();
    if (!there.is_held)
      model.hessian.on_diagonal(strips.second).noalias() += penalty * b * b.transpose();
    if (!here.is_held && !there.is_held)
      model.hessian.couple(strips.first, strips.second, penalty * a, b);
  }
}

Eigen::MatrixXd derivatives_of(const Member& member, const StripPoint& point) {
  Eigen::MatrixXd all(member.p.size(), 3);
  for (int axis = 0; axis < 3; ++axis)
    all.col(axis) = derivative_of(member, point, Vec3::Unit(axis));
  return all;
}

/// Adds what bonds cost to the value and to the strips' gradients.
void pull_by_bonds(const StripSystem& system, std::vector<Member>& members, double& value) {
  if (system.bonds.empty()) return;
  std::vector<StripFold> folds;
  for (const Member& member : members)
    folds.push_back(member.fold);
  for (const Bond& bond : system.bonds) {
    const Vec3 difference = bond.difference(folds);
    value += 0.5 * bond.stiffness * difference.squaredNorm();
    for (std::size_t i = 0; i < bond.points.size(); ++i) {
      Member& member = members[bond.points[i].strip];
      const Vec3 force = bond.stiffness * Bond::kShares[i] * difference;
      if (!member.is_held) member.model.gradient += derivative_of(member, bond.points[i], force);
      pull_at(member, bond.points[i], force);
    }
  }
}

/// Second derivatives of bonds: of squares, as pulls have the rest. Several bonds draw at the same
/// point of a strip, whose columns they share.
void add_bonds(Model& model, const StripSystem& system) {
  std::map<std::pair<int, int>, BlockMatrix::Part> parts;  // by strip and ridge
  std::map<std::pair<int, int>, double> stiffness;
  const auto place = [](const StripPoint& point) {
    return std::pair(point.strip, point.shares.front().ridge);
  };
  for (const Bond& bond : system.bonds)
    for (std::size_t i = 0; i < bond.points.size(); ++i) {
      const Member& member = model.members[bond.points[i].strip];
      if (member.is_held) continue;
      stiffness[place(bond.points[i])] += bond.stiffness * Bond::kShares[i] * Bond::kShares[i];
      if (auto& part = parts[place(bond.points[i])]; part.count == 0)
        part = model.hessian.face_part(
            bond.points[i].strip, member.along_manifold(derivatives_of(member, bond.points[i])));
    }
  for (const auto& [at, part] : parts) {
    const auto columns = model.hessian.face(part.row).middleCols(part.first, part.count);
    model.hessian.on_diagonal(part.row).noalias() += stiffness[at] * columns * columns.transpose();
  }
  for (const Bond& bond : system.bonds)
    for (std::size_t i = 0; i < bond.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (model.members[bond.points[i].strip].is_held ||
            model.members[bond.points[j].strip].is_held)
          continue;
        model.hessian.couple(
            parts[place(bond.points[i])], parts[place(bond.points[j])],
            bond.stiffness * Bond::kShares[i] * Bond::kShares[j] * Eigen::Matrix3d::Identity());
      }
}

}  // namespace

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
  pull_by_bonds(system, members, value);
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
  add_bonds(model, system);
  return model;
}

}  // namespace planish::slit_detail
