#include "strip_problem.hpp"

#include "second_jet.hpp"

#include <algorithm>
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

/// The terms of a radius limit: 2 R tan(|θ|/2) l/w ≤ Δ, both sides in mean spacings, with
/// derivatives.
class RadiusTerm {
 public:
  RadiusTerm(const StripProblem& problem, const StripParameters& p, const RadiusLimit& limit)
      : base_(problem.base), limit_(limit) {
    const double w = base_.width();
    skew_ = abscissa(base_, p, limit.ridge, 1) - abscissa(base_, p, limit.ridge, 0);
    length_ = std::hypot(skew_, w);
    angle_ = p[limit.ridge];
    tangent_ = std::tan(0.5 * std::abs(angle_));
    factor_ = 2.0 * problem.min_radius / w;
    spacing_ = abscissa(base_, p, limit.quad + 1, limit.side) -
               abscissa(base_, p, limit.quad, limit.side);
    scale_ = base_.quads / base_.unit();
  }

  double value() const { return scale_ * (factor_ * tangent_ * length_ - spacing_); }

  void add_gradient(Eigen::Ref<Eigen::RowVectorXd> row, double by) const {
    by *= scale_;
    row[limit_.ridge] += by * factor_ * length_ * 0.5 * (1.0 + tangent_ * tangent_) *
                         (angle_ < 0.0 ? -1.0 : 1.0);
    add(row, limit_.ridge, 1, by * factor_ * tangent_ * skew_ / length_);
    add(row, limit_.ridge, 0, -by * factor_ * tangent_ * skew_ / length_);
    add(row, limit_.quad + 1, limit_.side, -by);
    add(row, limit_.quad, limit_.side, by);
  }

  /// Of the value by the fold and by both ends of the ridge.
  void add_curvature(Eigen::MatrixXd& to, double by) const {
    using std::sqrt, std::tan;
    using Number = SecondJet<3>;
    const double unit = base_.unit(), half = angle_ < 0.0 ? -0.5 : 0.5;
    const bool slides = limit_.ridge > 0 && limit_.ridge < base_.quads;
    const Number angle = variable<3>(angle_, 0),
                 skew = constant<Number>(skew_) +
                        constant<Number>(unit) * (variable<3>(0.0, 2) - variable<3>(0.0, 1));
    const Number value = constant<Number>(by * scale_ * factor_) *
                         tan(constant<Number>(half) * angle) *
                         sqrt(skew * skew + constant<Number>(base_.width() * base_.width()));
    const std::array<int, 3> at{limit_.ridge,
                                slides ? abscissa_index(base_.quads, limit_.ridge, 0) : -1,
                                slides ? abscissa_index(base_.quads, limit_.ridge, 1) : -1};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (at[i] >= 0 && at[j] >= 0) to(at[i], at[j]) += value.v[i].v[j];
  }

 private:
  void add(Eigen::Ref<Eigen::RowVectorXd> row, int ridge, int side, double by) const {
    if (ridge > 0 && ridge < base_.quads)
      row[abscissa_index(base_.quads, ridge, side)] += by * base_.unit();
  }

  const StripBase& base_;
  RadiusLimit limit_;
  double skew_ = 0.0, length_ = 0.0, angle_ = 0.0, tangent_ = 0.0, factor_ = 0.0, spacing_ = 0.0,
         scale_ = 0.0;
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
    const Frame& quad = fold_.quad(last);
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
                 end = base_.end / base_.unit();
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
      const double mean = (base_.end - base_.start[side]) / base_.quads;
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

bool is_shape(const StripBase& base, const StripParameters& p) {
  for (int ridge = 0; ridge < base.quads; ++ridge) {
    if (!(std::abs(p[ridge]) < std::numbers::pi)) return false;
    for (int side = 0; side < 2; ++side)
      if (!(abscissa(base, p, ridge + 1, side) > abscissa(base, p, ridge, side))) return false;
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
