// The potential of weight and loads (math.md#standing): minus the work of forces that keep their
// direction. A quad is plane, so what is spread over it acts through two triangles, whose areas are
// linear in the ends of its ridges; forces at points act on the middles of ridges. So the potential
// is bilinear in places and abscissae. What must hold: second derivatives see the load behind a
// ridge only through its force and its first moment, so that their cost does not grow with its
// points.
#include "load_potential.hpp"

#include "end_curvature.hpp"

#include <algorithm>
#include <cmath>

namespace planish::slit_detail {

MiddlePoint middle_point(int quads, double at) {
  const double place = at * quads;
  const int ridge = std::clamp(static_cast<int>(std::floor(place)), 0, quads - 1);
  return {ridge, place - ridge};
}

namespace {

/// How long the edges of a quad are, left and right.
std::array<double, 2> edges_of(const StripBase& base, const StripParameters& p, int quad) {
  return {abscissa(base, p, quad + 1, 0) - abscissa(base, p, quad, 0),
          abscissa(base, p, quad + 1, 1) - abscissa(base, p, quad, 1)};
}

/// Of a quad's two triangles, the one at its left edge and the one at its right: which ends of
/// ridges (side, 0 or 1 further on) are its corners.
struct Corner {
  int side = 0, further = 0;
};
constexpr std::array<std::array<Corner, 3>, 2> kTriangles{
    {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}}};

Vec3 first_middle(const StripFold& fold) { return 0.5 * (fold.end(0, 0) + fold.end(1, 0)); }

/// No work of the load is more, wherever the strip is.
double most_work(const StripBase& base, const StripLoad& load) {
  double force = load.spread.norm() * base.unit() * base.width();
  for (const StripLoad::Force& one : load.forces)
    force += one.force.norm();
  return force * (base.unit() + base.width());
}

/// What acts behind a ridge: the force, and places times forces, Σ x fᵀ.
struct Behind {
  Vec3 force = Vec3::Zero();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();

  Eigen::Matrix3d about(const Vec3& pole) const { return moment - pole * force.transpose(); }
};

/// Twice the axis of what is skew in Σ x fᵀ: Σ x × f.
Vec3 turning(const Eigen::Matrix3d& moment) {
  return {moment(1, 2) - moment(2, 1), moment(2, 0) - moment(0, 2), moment(0, 1) - moment(1, 0)};
}

std::vector<Behind> behind_ridges(const StripBase& base, const StripFold& fold,
                                  const EndForces& forces) {
  std::vector<Behind> behind(base.quads);
  Behind sum;
  for (int ridge = base.quads - 1; ridge >= 0; --ridge) {
    for (int side = 0; side < 2; ++side) {
      const Vec3& force = forces[side][ridge + 1];
      sum.force += force;
      sum.moment += fold.end(side, ridge + 1) * force.transpose();
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
        forces_(end_forces(base_, p, load_)),
        behind_(behind_ridges(base_, fold_, forces_)),
        all_{load_potential(problem, p), Eigen::VectorXd::Zero(p.size()),
             Eigen::MatrixXd::Zero(p.size(), p.size())} {}

  SecondOrder derivatives() {
    add_turns();
    for (int ridge = 0; ridge < base_.quads; ++ridge)
      add_own(ridge);
    for (int ridge = 1; ridge < base_.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        add_sliding(ridge, side);
    if (!load_.spread.isZero(0.0)) add_areas();
    return std::move(all_);
  }

 private:
  /// Turns about ridges, and by ends of ridges that slide: what lies behind does work, and a turn
  /// before carries along what it does.
  void add_turns() {
    const auto count = static_cast<Eigen::Index>(twists_.size());
    Eigen::Matrix3Xd carried(3, count);
    for (Eigen::Index q = 0; q < count; ++q) {
      const Twist& twist = twists_[q];
      const Eigen::Matrix3d about = behind_[twist.ridge].about(twist.pole);
      all_.gradient[q] = -twist.axis.dot(turning(about));
      carried.col(q) = about.trace() * twist.axis - about * twist.axis;
    }
    for (Eigen::Index a = 0; a < count; ++a)
      for (Eigen::Index b = 0; b <= a; ++b) {
        const bool a_first = twists_[a].ridge < twists_[b].ridge;
        all_.hessian(a, b) = all_.hessian(b, a) = a_first ? twists_[a].axis.dot(carried.col(b))
                                                          : twists_[b].axis.dot(carried.col(a));
      }
  }

  /// All that lies behind a ridge is as one force and three directions.
  void add_own(int ridge) {
    const Vec3& at = fold_.end(0, ridge);
    const Eigen::Matrix3d about = behind_[ridge].about(at);
    std::vector<WeighedVector> sum{{ridge + 1, true, at, -behind_[ridge].force}};
    for (int axis = 0; axis < 3; ++axis)
      sum.push_back({ridge + 1, false, Vec3::Unit(axis), -about.row(axis).transpose()});
    set_of_ridge(all_.hessian, base_, p_, fold_, ridge, sum);
  }

  void add_sliding(int ridge, int side) {
    const int own = abscissa_index(base_.quads, ridge, side);
    const Vec3 along = base_.unit() * fold_.frames[ridge].x;
    all_.gradient[own] -= forces_[side][ridge].dot(along);
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
      for (int edge = 0; edge < 2; ++edge) {
        double work = 0.0;
        Eigen::RowVectorXd by_parameters = Eigen::RowVectorXd::Zero(p_.size());
        for (const Corner& corner : kTriangles[edge]) {
          const int ridge = quad + corner.further;
          work += load_.spread.dot(fold_.end(corner.side, ridge) - from);
          by_parameters += of_ends[corner.side].row(ridge);
        }
        add_edge(quad + 1, edge, -base_.width() / 6.0 * work, -base_.width() / 6.0 * by_parameters);
        add_edge(quad, edge, base_.width() / 6.0 * work, base_.width() / 6.0 * by_parameters);
      }
  }

  void add_edge(int ridge, int side, double slope, const Eigen::RowVectorXd& by_parameters) {
    if (ridge == 0 || ridge == base_.quads) return;
    const int own = abscissa_index(base_.quads, ridge, side);
    all_.gradient[own] += base_.unit() * slope;
    all_.hessian.row(own) += base_.unit() * by_parameters;
    all_.hessian.col(own) += base_.unit() * by_parameters.transpose();
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

EndForces end_forces(const StripBase& base, const StripParameters& p, const StripLoad& load) {
  const std::vector<Vec3> none(base.quads + 1, Vec3::Zero());
  EndForces forces{none, none};
  for (int quad = 0; quad < base.quads; ++quad) {
    const auto edges = edges_of(base, p, quad);
    for (std::size_t edge = 0; edge < 2; ++edge)
      for (const Corner& corner : kTriangles[edge])
        forces[corner.side][quad + corner.further] += base.width() / 6.0 * edges[edge] *
                                                      load.spread;
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
  const EndForces forces = end_forces(problem.base, p, problem.load);
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
