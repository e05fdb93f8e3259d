// The potential of weight and loads (math.md#standing): minus the work of forces that keep their
// direction. A quad is plane, so what is spread over it acts through two triangles, whose areas are
// bilinear in the ends of its ridges; forces at points act on the middles of ridges. What must
// hold: second derivatives see the load behind a ridge only through its force and its first moment,
// so that their cost does not grow with its points.
#include "load_potential.hpp"

#include "end_curvature.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

namespace planish::slit_detail {

MiddlePoint middle_point(int quads, double at) {
  const double place = at * quads;
  const int ridge = std::clamp(static_cast<int>(std::floor(place)), 0, quads - 1);
  return {ridge, place - ridge};
}

namespace {

/// Of a quad's two triangles, the one at its left edge and the one at its right: which ends of
/// ridges (side, 0 or 1 further on) are its corners, counter-clockwise on the flat sheet.
struct Corner {
  int side = 0, further = 0;
};
using Corners = std::array<Corner, 3>;
constexpr std::array<Corners, 2> kTriangles{
    {{{{0, 0}, {0, 1}, {1, 0}}}, {{{1, 0}, {0, 1}, {1, 1}}}}};

/// A triangle of a quad on the flat sheet.
class Triangle {
 public:
  Triangle(const StripFold& fold, int quad, const Corners& corners) {
    for (std::size_t i = 0; i < 3; ++i)
      places_[i] = fold.flat[corners[i].side][quad + corners[i].further];
  }
  double area() const { return 0.5 * planish::cross(across(0), -across(2)); }
  /// Derivatives of the area by where corners are on their edges.
  double slope(std::size_t i) const {
    return 0.5 * planish::cross(across((i + 1) % 3), places_[i].first);
  }
  double curvature(std::size_t i, std::size_t j) const {
    if (i == j) return 0.5 * planish::cross(across((i + 1) % 3), places_[i].second);
    const double sense = j == (i + 1) % 3 ? 0.5 : -0.5;
    return sense * planish::cross(places_[i].first, places_[j].first);
  }

 private:
  /// From a corner to the next.
  Vec2 across(std::size_t i) const { return places_[(i + 1) % 3].at - places_[i].at; }
  std::array<EdgePlace, 3> places_;
};

Vec3 first_middle(const StripFold& fold) { return 0.5 * (fold.end(0, 0) + fold.end(1, 0)); }

/// No work of the load is more, wherever the strip is.
double most_work(const StripBase& base, const StripLoad& load) {
  double force = load.spread.norm() * base.area();
  for (const StripLoad::Force& one : load.forces)
    force += one.force.norm();
  return force * (base.unit() + base.width());
}

/// Twice the axis of what is skew in Σ x fᵀ: Σ x × f.
Vec3 turning(const Eigen::Matrix3d& moment) {
  return {moment(1, 2) - moment(2, 1), moment(2, 0) - moment(0, 2), moment(0, 1) - moment(1, 0)};
}

/// Less the forces, as what they do is less potential.
std::vector<Behind> behind_ridges(const StripBase& base, const StripFold& fold,
                                  const EndForces& forces) {
  std::vector<Behind> behind(base.quads);
  Behind sum;
  for (int ridge = base.quads - 1; ridge >= 0; --ridge) {
    for (int side = 0; side < 2; ++side) {
      const Vec3& force = forces[side][ridge + 1];
      sum.force -= force;
      sum.moment -= fold.end(side, ridge + 1) * force.transpose();
    }
    behind[ridge] = sum;
  }
  return behind;
}

/// Fills the derivatives of minus the work, piece by piece.
class Work {
 public:
  Work(const StripProblem& problem, const StripParameters& p)
      : base_(problem.base),
        load_(problem.load),
        p_(p),
        fold_(folded(base_, p)),
        twists_(twists(base_, fold_)),
        forces_(end_forces(base_, fold_, load_)),
        behind_(behind_ridges(base_, fold_, forces_)),
        all_{load_potential(problem, p), Eigen::VectorXd(p.size()), {}} {}

  SecondOrder derivatives() {
    all_.hessian = second_derivatives(base_, p_, fold_, twists_, behind_);
    for (std::size_t q = 0; q < twists_.size(); ++q)
      all_.gradient[static_cast<Eigen::Index>(q)] = twists_[q].axis.dot(
          turning(behind_[twists_[q].ridge].about(twists_[q].pole)));
    for (int ridge = 1; ridge < base_.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        add_sliding(ridge, side);
    if (!load_.spread.isZero(0.0)) add_areas();
    return std::move(all_);
  }

 private:
  void add_sliding(int ridge, int side) {
    const int own = abscissa_index(base_.quads, ridge, side);
    const EdgePlace& place = fold_.flat[side][ridge];
    const Vec3 along = base_.unit() * fold_.before(ridge, place.first);
    all_.gradient[own] -= forces_[side][ridge].dot(along);
    all_.hessian(own, own) -= base_.unit() * base_.unit() *
                              fold_.before(ridge, place.second).dot(forces_[side][ridge]);
    for (std::size_t q = 0; q < twists_.size(); ++q)
      if (twists_[q].ridge < ridge)
        add_both(own, static_cast<Eigen::Index>(q),
                 -twists_[q].axis.cross(along).dot(forces_[side][ridge]));
  }

  void add_both(Eigen::Index a, Eigen::Index b, double value) {
    all_.hessian(a, b) += value;
    all_.hessian(b, a) += value;
  }

  /// Areas change with the abscissae.
  void add_areas() {
    const Vec3 from = first_middle(fold_);
    const std::array<Eigen::MatrixXd, 2> of_ends{ends_by_parameters(0), ends_by_parameters(1)};
    for (int quad = 0; quad < base_.quads; ++quad)
      for (const Corners& corners : kTriangles) {
        const Triangle triangle(fold_, quad, corners);
        double work = 0.0;
        Eigen::RowVectorXd by_parameters = Eigen::RowVectorXd::Zero(p_.size());
        for (const Corner& corner : corners) {
          const int ridge = quad + corner.further;
          work -= load_.spread.dot(fold_.end(corner.side, ridge) - from) / 3.0;
          by_parameters -= of_ends[corner.side].row(ridge) / 3.0;
        }
        for (std::size_t i = 0; i < 3; ++i)
          add_corner(triangle, corners, quad, i, work, by_parameters);
      }
  }

  /// What a triangle's area adds as one of its corners slides.
  void add_corner(const Triangle& triangle, const Corners& corners, int quad, std::size_t i,
                  double work, const Eigen::RowVectorXd& by_parameters) {
    const int own = number_of(corners[i], quad);
    if (own < 0) return;
    const double slope = base_.unit() * triangle.slope(i);
    all_.gradient[own] += slope * work;
    all_.hessian.row(own) += slope * by_parameters;
    all_.hessian.col(own) += slope * by_parameters.transpose();
    for (std::size_t j = 0; j < 3; ++j)
      if (const int other = number_of(corners[j], quad); other >= 0)
        all_.hessian(own, other) += base_.unit() * base_.unit() * triangle.curvature(i, j) * work;
  }

  /// Of the abscissa of a corner; −1: it is fixed.
  int number_of(const Corner& corner, int quad) const {
    const int ridge = quad + corner.further;
    if (ridge == 0 || ridge == base_.quads) return -1;
    return abscissa_index(base_.quads, ridge, corner.side);
  }

  /// How far the ends of a side's ridges go along the spread force, a row for each.
  Eigen::MatrixXd ends_by_parameters(int side) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(base_.quads + 1, p_.size());
    for (int ridge = 1; ridge <= base_.quads; ++ridge)
      rows.row(ridge) = load_.spread.transpose() *
                        end_derivative(base_, fold_, twists_, side, ridge);
    return rows;
  }

  const StripBase& base_;
  const StripLoad& load_;
  const StripParameters& p_;
  StripFold fold_;
  std::vector<Twist> twists_;
  EndForces forces_;
  std::vector<Behind> behind_;
  SecondOrder all_;
};

}  // namespace

EndForces end_forces(const StripBase& base, const StripFold& fold, const StripLoad& load) {
  const std::vector<Vec3> none(base.quads + 1, Vec3::Zero());
  EndForces forces{none, none};
  for (int quad = 0; quad < base.quads; ++quad)
    for (const Corners& corners : kTriangles) {
      const Vec3 third = Triangle(fold, quad, corners).area() / 3.0 * load.spread;
      for (const Corner& corner : corners)
        forces[corner.side][quad + corner.further] += third;
    }
  for (const StripLoad::Force& one : load.forces) {
    const MiddlePoint at = middle_point(base.quads, one.at);
    for (auto& side : forces) {
      side[at.ridge] += 0.5 * (1.0 - at.share) * one.force;
      side[at.ridge + 1] += 0.5 * at.share * one.force;
    }
  }
  return forces;
}

double load_potential(const StripProblem& problem, const StripParameters& p) {
  if (problem.load.empty()) return 0.0;
  const StripFold fold = folded(problem.base, p);
  const EndForces forces = end_forces(problem.base, fold, problem.load);
  const Vec3 from = first_middle(fold);
  double potential = most_work(problem.base, problem.load);
  for (int side = 0; side < 2; ++side)
    for (int ridge = 0; ridge <= problem.base.quads; ++ridge)
      potential -= forces[side][ridge].dot(fold.end(side, ridge) - from);
  return potential;
}

SecondOrder load_potential_derivatives(const StripProblem& problem, const StripParameters& p) {
  return Work(problem, p).derivatives();
}

}  // namespace planish::slit_detail
