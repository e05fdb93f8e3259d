#include "strip_problem.hpp"

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
constexpr double kThirtieths = 30.0;      // lengths count in thirtieths of the strip's length

Vec3 end_vector(EndCondition::Of of, const StripFold& fold, int quads) {
  const Frame& last = fold.quad(quads - 1);
  switch (of) {
    case EndCondition::Of::left_end:
      return fold.end(0, quads);
    case EndCondition::Of::right_end:
      return fold.end(1, quads);
    case EndCondition::Of::middle:
      return 0.5 * (fold.end(0, quads) + fold.end(1, quads));
    case EndCondition::Of::along:
      return last.x;
    case EndCondition::Of::across:
      return last.y;
    case EndCondition::Of::normal:
      return last.z;
  }
  return Vec3::Zero();
}

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
    add_smoothness();
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

  void add_spacing() {
    const double scale = std::sqrt(problem_.weights.spacing / base_.quads);
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

/// Calls f(side, neighbouring quad, its abscissa difference) at both sides of a ridge.
template <typename F>
void for_neighbours(const StripBase& base, const StripParameters& p, int ridge, const F& f) {
  for (int side = 0; side < 2; ++side)
    for (int quad = std::max(0, ridge - 1); quad <= ridge; ++quad)
      f(side, quad, abscissa(base, p, quad + 1, side) - abscissa(base, p, quad, side));
}

double fold_radius(const StripBase& base, const StripParameters& p, int ridge, double spacing) {
  const double length = std::hypot(abscissa(base, p, ridge, 1) - abscissa(base, p, ridge, 0),
                                   base.width());
  const double tangent = std::tan(0.5 * std::abs(p[ridge]));
  return tangent > 0.0 ? 0.5 * spacing * base.width() / length / tangent
                       : std::numeric_limits<double>::infinity();
}

}  // namespace

int StripProblem::residuals() const {
  const int places = static_cast<int>(anchors.size()) + (scan ? 2 * base.quads : 0);
  return base.quads - 2 + (mirrored ? 1 : 0) + (far_facet ? 1 : 0) + 2 * base.quads + 3 * places +
         (seat ? 8 : 0) + static_cast<int>(inequalities.size());
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

Eigen::VectorXd end_violation(const StripProblem& problem, const StripFold& fold) {
  Eigen::VectorXd violation(static_cast<Eigen::Index>(problem.ends.size()));
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const double missed = condition.gradient.dot(
                              end_vector(condition.of, fold, problem.base.quads)) -
                          condition.value;
    violation[static_cast<Eigen::Index>(i)] = condition.is_length() ? missed / problem.base.unit()
                                                                    : missed;
  }
  return violation;
}

RowMatrix end_derivative(const StripProblem& problem, const StripFold& fold) {
  const std::vector<Twist> all = twists(problem.base, fold);
  RowMatrix derivative(static_cast<Eigen::Index>(problem.ends.size()), problem.parameters());
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const Vec3 v = end_vector(condition.of, fold, problem.base.quads);
    const double scale = condition.is_length() ? 1.0 / problem.base.unit() : 1.0;
    for (std::size_t q = 0; q < all.size(); ++q) {
      const Vec3 velocity = condition.is_length() ? all[q].velocity(v) : Vec3(all[q].axis.cross(v));
      derivative(static_cast<Eigen::Index>(i),
                 static_cast<Eigen::Index>(q)) = scale * condition.gradient.dot(velocity);
    }
  }
  return derivative;
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

double end_gap(const StripProblem& problem, const StripFold& fold) {
  const Eigen::VectorXd violation = end_violation(problem, fold);
  double largest = 0.0, middle = 0.0;
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const double missed = violation[static_cast<Eigen::Index>(i)] * problem.base.unit();
    if (problem.ends[i].of == EndCondition::Of::middle)
      middle += missed * missed;
    else if (problem.ends[i].is_length())
      largest = std::max(largest, std::abs(missed));
  }
  return std::max(largest, std::sqrt(middle));
}

Angle fold_into(const Frame& last, const Frame& facet) {
  return Angle::radians(std::atan2(-facet.x.dot(last.z), facet.x.dot(last.x)));
}

Tightest far_fold(const StripProblem& problem, const StripParameters& p) {
  Tightest fold{std::numeric_limits<double>::infinity(), problem.base.quads};
  if (!problem.far_facet) return fold;
  const StripBase& base = problem.base;
  const int last = base.quads - 1;
  const double angle = fold_into(folded(base, p).quad(last), *problem.far_facet).radians();
  const double tangent = std::tan(0.5 * std::abs(angle));
  for (int side = 0; side < 2; ++side)
    if (tangent > 0.0)
      fold.radius = std::min(fold.radius,
                             0.5 * (base.end - abscissa(base, p, last, side)) / tangent);
  return fold;
}

Tightest tightest_fold(const StripBase& base, const StripParameters& p) {
  Tightest tightest{std::numeric_limits<double>::infinity(), 0};
  for (int ridge = 0; ridge < base.quads; ++ridge)
    for_neighbours(base, p, ridge, [&](int, int, double spacing) {
      const double radius = fold_radius(base, p, ridge, spacing);
      if (radius < tightest.radius) tightest = {radius, ridge};
    });
  return tightest;
}

std::vector<RadiusLimit> radius_limits(const StripBase& base, const StripParameters& p,
                                       double min_radius) {
  constexpr double kNear = 2.0;
  std::vector<RadiusLimit> limits;
  for (int ridge = 0; ridge < base.quads; ++ridge)
    for_neighbours(base, p, ridge, [&](int side, int quad, double spacing) {
      if (fold_radius(base, p, ridge, spacing) < kNear * min_radius)
        limits.push_back({ridge, side, quad});
    });
  return limits;
}

}  // namespace planish::slit_detail
