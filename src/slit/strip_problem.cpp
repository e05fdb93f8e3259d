#include "strip_problem.hpp"

#include "bent_fold.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

// The objective of a strip as a sum of squares, with derivatives, and its inequalities
// (math.md#strip-conditions). Residuals are written row by row, in strip lengths, and weighted so
// that the sum keeps its value when quads are divided (math.md#subdivision). The barrier of
// spacings [slits 4] is rewritten as squares that vanish at equal spacing, so that Gauss–Newton
// steps converge.

namespace planish::slit_detail {
namespace {

constexpr double kReferenceQuads = 10.0;  // as in the paper (bibliography.md#slits) for the same
                                          // weights
constexpr double kEvenMiddles = 1.0;      // a thousand times as firm as the energy
constexpr double kOfSpacing = 0.1;        // as firm as the energy, so that ridges do not meet
constexpr double kThirtieths = 30.0;      // lengths count in thirtieths of the strip's length

/// The terms of a radius limit: 2 R tan(|θ|/2) ≤ h, the width that is bent, both times the length
/// of the ridge and in mean spacings of the strip's mean width, with derivatives.
class RadiusTerm {
 public:
  RadiusTerm(const StripProblem& problem, const StripParameters& p, const RadiusLimit& limit)
      : base_(problem.base),
        ridge_(limit.ridge),
        fold_(fold_at(problem, p, limit.ridge)),
        side_(limit.side),
        angle_(p[limit.ridge]),
        tangent_(std::tan(0.5 * std::abs(angle_))),
        twice_radius_(2.0 * problem.min_radius),
        scale_(base_.quads / base_.area()) {}

  double value() const {
    return scale_ * (twice_radius_ * tangent_ * fold_.along().norm() - fold_.swept(side_));
  }

  void add_gradient(Eigen::Ref<Eigen::RowVectorXd> row, double by) const {
    const OfFold gradient = by * derivatives().gradient;
    each([&](int i, int at, double unit) { row[at] += unit * gradient[i]; });
  }

  void add_curvature(Eigen::MatrixXd& to, double by) const {
    const TwiceOfFold hessian = by * derivatives().hessian;
    each([&](int i, int row, double a) {
      each([&](int j, int column, double b) { to(row, column) += a * b * hessian(i, j); });
    });
  }

 private:
  template <typename F>
  void each(const F& f) const {
    const auto numbers = numbers_of_fold(base_, ridge_);
    for (int i = 0; i < kOfFold; ++i)
      if (numbers[i] >= 0) f(i, numbers[i], i == 0 ? 1.0 : base_.unit());
  }

  OfPlaces derivatives() const {
    const OfPlaces square = fold_.square_of_length(), swept = fold_.swept_by(side_);
    const double length = std::sqrt(square.value), sense = angle_ < 0.0 ? -1.0 : 1.0;
    const OfFold of_length = square.gradient / (2.0 * length);
    const TwiceOfFold twice_of_length = square.hessian / (2.0 * length) -
                                        of_length * of_length.transpose() / length;
    const double slope = 0.5 * (1.0 + tangent_ * tangent_) * sense;
    OfPlaces all{value(), scale_ * (twice_radius_ * tangent_ * of_length - swept.gradient),
                 scale_ * (twice_radius_ * tangent_ * twice_of_length - swept.hessian)};
    all.gradient[0] = scale_ * twice_radius_ * slope * length;
    all.hessian(0, 0) = scale_ * twice_radius_ * std::abs(slope) * tangent_ * length;
    all.hessian.row(0).tail<6>() = scale_ * twice_radius_ * slope * of_length.tail<6>().transpose();
    all.hessian.col(0).tail<6>() = all.hessian.row(0).tail<6>().transpose();
    return all;
  }

  const StripBase& base_;
  int ridge_ = 0;
  BentFold fold_;
  int side_ = 0;
  double angle_ = 0.0, tangent_ = 0.0, twice_radius_ = 0.0, scale_ = 0.0;
};

/// Fills residuals and Jacobian row by row.
class Rows {
 public:
  Rows(const StripProblem& problem, const StripParameters& p, Eigen::Ref<Eigen::VectorXd> residuals,
       Eigen::Ref<RowMatrix>* jacobian)
      : problem_(problem),
        base_(problem.base),
        p_(p),
        residuals_(residuals),
        jacobian_(jacobian),
        fold_(folded(base_, p)) {
    if (jacobian_) {
      jacobian_->setZero();
      twists_ = twists(base_, fold_);
    }
  }

  void fill() {
    if (problem_.objective == SlitObjective::smooth)
      add_smoothness();
    else
      add_middles();
    add_spacing();
    for (const StripAnchor& anchor : problem_.anchors)
      add_place(anchor.side, anchor.ridge, anchor.at, position_scale(problem_.weights.anchors));
    if (problem_.seat) {
      add_seat(0);
      add_seat(1);
    }
    if (problem_.scan) add_scan();
    for (const Inequality& inequality : problem_.inequalities)
      add_inequality(inequality);
  }

 private:
  double position_scale(double weight) const {
    return std::sqrt(weight) * kThirtieths / base_.unit();
  }

  void add_smoothness() {
    const double scale = std::sqrt(problem_.weights.smooth) *
                         std::pow(base_.quads / kReferenceQuads, 2.5);
    for (int i = 1; i + 1 < base_.quads; ++i) {
      residuals_[row_] = scale * (2.0 * p_[i] - p_[i - 1] - p_[i + 1]);
      if (jacobian_) {
        (*jacobian_)(row_, i - 1) = (*jacobian_)(row_, i + 1) = -scale;
        (*jacobian_)(row_, i) = 2.0 * scale;
      }
      ++row_;
    }
    if (problem_.mirrored) {
      const int last = base_.quads - 1;
      residuals_[row_] = scale * (p_[last] - p_[last - 1]);
      if (jacobian_) (*jacobian_)(row_, last) = scale, (*jacobian_)(row_, last - 1) = -scale;
      ++row_;
    }
    if (problem_.far_facet) add_far_fold(scale, *problem_.far_facet);
  }

  /// θ_M−2, θ_M−1 and the fold into the panel, whose derivative is that of the last quad's turn.
  void add_far_fold(double scale, const Frame& facet) {
    const int last = base_.quads - 1;
    const Frame quad = base_.along_last_ridge(fold_.quad(last));
    residuals_[row_] = scale * (2.0 * p_[last] - p_[last - 1] - fold_into(quad, facet).radians());
    if (jacobian_) {
      const double sine = -facet.x.dot(quad.z), cosine = facet.x.dot(quad.x);
      for (std::size_t q = 0; q < twists_.size(); ++q) {
        const double of_sine = -facet.x.dot(twists_[q].axis.cross(quad.z)),
                     of_cosine = facet.x.dot(twists_[q].axis.cross(quad.x));
        (*jacobian_)(row_, static_cast<Eigen::Index>(q)) = -scale *
                                                           (cosine * of_sine - sine * of_cosine) /
                                                           (sine * sine + cosine * cosine);
      }
      (*jacobian_)(row_, last) += 2.0 * scale;
      (*jacobian_)(row_, last - 1) -= scale;
    }
    ++row_;
  }

  /// Where ridges lie along a strip does not matter to its energy but for the error of replacing an
  /// arc by folds, which would be least in few large folds. So their middles are held evenly
  /// spaced, and only their directions are sought.
  void add_middles() {
    const double scale = std::sqrt(kEvenMiddles * base_.quads);
    const double start = 0.5 * (base_.start[0] + base_.start[1]) / base_.unit(),
                 end = 0.5 * (base_.end[0] + base_.end[1]) / base_.unit();
    for (int ridge = 1; ridge < base_.quads; ++ridge) {
      const int left = abscissa_index(base_.quads, ridge, 0);
      const double even = start + ridge * (end - start) / base_.quads;
      residuals_[row_] = scale * (0.5 * (p_[left] + p_[left + 1]) - even);
      if (jacobian_) (*jacobian_)(row_, left) = (*jacobian_)(row_, left + 1) = 0.5 * scale;
      ++row_;
    }
  }

  void add_spacing() {
    const double share_of_weight = problem_.objective == SlitObjective::energy ? kOfSpacing : 1.0;
    const double scale = std::sqrt(share_of_weight * problem_.weights.spacing / base_.quads);
    for (int side = 0; side < 2; ++side) {
      const double mean = (base_.end[side] - base_.start[side]) / base_.quads;
      for (int quad = 0; quad < base_.quads; ++quad) {
        const double share = (abscissa(base_, p_, quad + 1, side) -
                              abscissa(base_, p_, quad, side)) /
                             mean;
        residuals_[row_] = scale * (share - 1.0) / std::sqrt(share);
        if (jacobian_) {
          const double slope = scale * 0.5 * (share + 1.0) / (share * std::sqrt(share)) *
                               base_.unit() / mean;
          if (quad + 1 < base_.quads)
            (*jacobian_)(row_, abscissa_index(base_.quads, quad + 1, side)) = slope;
          if (quad > 0) (*jacobian_)(row_, abscissa_index(base_.quads, quad, side)) = -slope;
        }
        ++row_;
      }
    }
  }

  void add_place(int side, int ridge, const Vec3& at, double scale) {
    residuals_.segment<3>(row_) = scale * (fold_.end(side, ridge) - at);
    if (jacobian_)
      jacobian_->middleRows<3>(row_) = scale * slit_detail::end_derivative(base_, fold_, twists_,
                                                                           side, ridge);
    row_ += 3;
  }

  void add_seat(int side) {
    const double scale = position_scale(problem_.weights.seat);
    const Vec2 section = fold_.end(side, base_.quads).tail<2>();
    const BezierSearch::Foot foot = problem_.seat->nearest(section);
    const double place_scale = position_scale(problem_.weights.spread);
    residuals_.segment<2>(row_) = scale * (section - foot.point);
    residuals_.segment<2>(row_ + 2) = place_scale * (section - problem_.seat_places[side]);
    if (jacobian_) {
      const auto derivative = slit_detail::end_derivative(base_, fold_, twists_, side, base_.quads)
                                  .bottomRows<2>()
                                  .eval();
      jacobian_->middleRows<2>(row_) = scale * (Eigen::Matrix2d::Identity() - foot.derivative) *
                                       derivative;
      jacobian_->middleRows<2>(row_ + 2) = place_scale * derivative;
    }
    row_ += 4;
  }

  void add_scan() {
    const double scale = position_scale(problem_.weights.scan * kReferenceQuads / base_.quads);
    for (int side = 0; side < 2; ++side)
      for (int ridge = 1; ridge <= base_.quads; ++ridge)
        add_scanned(side, ridge, scale);
  }

  void add_scanned(int side, int ridge, double scale) {
    const ScannedSurface::Foot foot = problem_.scan->nearest(fold_.end(side, ridge));
    residuals_.segment<3>(row_) = scale * (fold_.end(side, ridge) - foot.point);
    if (jacobian_)
      jacobian_->middleRows<3>(row_) = scale * (Eigen::Matrix3d::Identity() - foot.derivative) *
                                       slit_detail::end_derivative(base_, fold_, twists_, side,
                                                                   ridge);
    row_ += 3;
  }

  void add_inequality(const Inequality& inequality) {
    const double root = std::sqrt(problem_.penalty),
                 shift = inequality.multiplier / problem_.penalty;
    if (const auto* space = std::get_if<HalfSpace>(&inequality.what)) {
      const double value = (space->offset -
                            space->normal.dot(fold_.end(space->side, space->ridge))) /
                               base_.unit() +
                           shift;
      residuals_[row_] = root * std::max(0.0, value);
      if (jacobian_ && value > 0.0)
        jacobian_->row(row_) = -root / base_.unit() * space->normal.transpose() *
                               slit_detail::end_derivative(base_, fold_, twists_, space->side,
                                                           space->ridge);
    } else {
      const RadiusTerm term(problem_, p_, std::get<RadiusLimit>(inequality.what));
      const double value = term.value() + shift;
      residuals_[row_] = root * std::max(0.0, value);
      if (jacobian_ && value > 0.0) term.add_gradient(jacobian_->row(row_), root);
    }
    ++row_;
  }

  const StripProblem& problem_;
  const StripBase& base_;
  const StripParameters& p_;
  Eigen::Ref<Eigen::VectorXd> residuals_;
  Eigen::Ref<RowMatrix>* jacobian_;
  StripFold fold_;
  std::vector<Twist> twists_;
  Eigen::Index row_ = 0;
};

}  // namespace

int StripProblem::residuals() const {
  const int places = static_cast<int>(anchors.size()) + (scan ? 2 * base.quads : 0);
  const int smooth = objective == SlitObjective::energy
                         ? base.quads - 1
                         : base.quads - 2 + (mirrored ? 1 : 0) + (far_facet ? 1 : 0);
  return smooth + 2 * base.quads + 3 * places + (seat ? 8 : 0) +
         static_cast<int>(inequalities.size());
}

std::vector<Pull> pulls(const StripProblem& problem, const StripFold& fold) {
  const StripBase& base = problem.base;
  const auto stiffness = [&](double weight) {
    return weight * kThirtieths * kThirtieths / (base.unit() * base.unit());
  };
  std::vector<Pull> all;
  for (const StripAnchor& anchor : problem.anchors)
    all.push_back(
        {anchor.ridge, anchor.side,
         stiffness(problem.weights.anchors) * (fold.end(anchor.side, anchor.ridge) - anchor.at)});
  for (int side = 0; problem.seat && side < 2; ++side) {
    const Vec2 section = fold.end(side, base.quads).tail<2>();
    const Vec2 pull = stiffness(problem.weights.seat) *
                          (section - problem.seat->nearest(section).point) +
                      stiffness(problem.weights.spread) * (section - problem.seat_places[side]);
    all.push_back({base.quads, side, {0.0, pull.x(), pull.y()}});
  }
  for (int side = 0; problem.scan && side < 2; ++side)
    for (int ridge = 1; ridge <= base.quads; ++ridge) {
      const Vec3& at = fold.end(side, ridge);
      const ScannedSurface::Foot foot = problem.scan->nearest(at);
      all.push_back({ridge, side,
                     stiffness(problem.weights.scan * kReferenceQuads / base.quads) *
                         (Eigen::Matrix3d::Identity() - foot.derivative).transpose() *
                         (at - foot.point)});
    }
  for (const Inequality& inequality : problem.inequalities) {
    const auto* space = std::get_if<HalfSpace>(&inequality.what);
    if (!space) continue;
    const double broken = (space->offset - space->normal.dot(fold.end(space->side, space->ridge))) /
                              base.unit() +
                          inequality.multiplier / problem.penalty;
    if (broken > 0.0)
      all.push_back(
          {space->ridge, space->side, -problem.penalty * broken / base.unit() * space->normal});
  }
  return all;
}

namespace {

/// Whether the ends of a ridge lie on the right side of the next one and the other way round: what
/// follows for lines along the sheet from the order of their abscissae.
bool is_before(const StripBase& base, const StripParameters& p, int ridge) {
  if (base.sides[0].is_line() && base.sides[1].is_line()) return true;
  const std::array<Vec2, 2> near{place_of(base, p, ridge, 0).at, place_of(base, p, ridge, 1).at},
      far{place_of(base, p, ridge + 1, 0).at, place_of(base, p, ridge + 1, 1).at};
  for (std::size_t side = 0; side < 2; ++side)
    if (!(planish::cross(far[side] - near[side], near[1] - near[0]) > 0.0 &&
          planish::cross(far[side] - near[side], far[1] - far[0]) > 0.0))
      return false;
  return true;
}

}  // namespace

bool is_shape(const StripBase& base, const StripParameters& p) {
  for (int ridge = 0; ridge < base.quads; ++ridge) {
    if (!(std::abs(p[ridge]) < std::numbers::pi)) return false;
    for (int side = 0; side < 2; ++side)
      if (!(abscissa(base, p, ridge + 1, side) > abscissa(base, p, ridge, side))) return false;
    if (!is_before(base, p, ridge)) return false;
  }
  return true;
}

bool evaluate(const StripProblem& problem, const StripParameters& p,
              Eigen::Ref<Eigen::VectorXd> residuals, Eigen::Ref<RowMatrix>* jacobian) {
  if (!is_shape(problem.base, p)) return false;
  Rows(problem, p, residuals, jacobian).fill();
  return true;
}

Eigen::MatrixXd limit_curvature(const StripProblem& problem, const StripParameters& p) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(p.size(), p.size());
  for (const Inequality& inequality : problem.inequalities) {
    const auto* limit = std::get_if<RadiusLimit>(&inequality.what);
    if (!limit) continue;
    const RadiusTerm term(problem, p, *limit);
    const double pressed = problem.penalty * term.value() + inequality.multiplier;
    if (pressed > 0.0) term.add_curvature(sum, pressed);
  }
  return sum;
}

Eigen::VectorXd inequality_values(const StripProblem& problem, const StripParameters& p) {
  const StripFold fold = folded(problem.base, p);
  Eigen::VectorXd values(static_cast<Eigen::Index>(problem.inequalities.size()));
  for (std::size_t i = 0; i < problem.inequalities.size(); ++i) {
    const auto& what = problem.inequalities[i].what;
    const auto* space = std::get_if<HalfSpace>(&what);
    values[static_cast<Eigen::Index>(
        i)] = space ? (space->offset - space->normal.dot(fold.end(space->side, space->ridge))) /
                          problem.base.unit()
                    : RadiusTerm(problem, p, std::get<RadiusLimit>(what)).value();
  }
  return values;
}

}  // namespace planish::slit_detail
