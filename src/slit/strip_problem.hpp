#pragma once

#include "nearest_points.hpp"
#include "strip_load.hpp"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace planish::slit_detail {

/// A linear condition that the strip's end must meet: gradient · v = value.
struct EndCondition {
  enum class Of { left_end, right_end, middle, along, across, normal };
  Of of = Of::left_end;  ///< points of the last ridge in units of the strip's length, or directions
                         ///< of the last quad; `across` is that of the last ridge
  Vec3 gradient = Vec3::Zero();
  double value = 0.0;
  bool is_length() const { return of == Of::left_end || of == Of::right_end || of == Of::middle; }
};

/// A ridge's end must stay on one side of a plane: normal · v ≥ offset. `firm`: to `kHolds`, by a
/// multiplier; others only lead the strip away.
struct HalfSpace {
  int ridge = 0;
  int side = 0;
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;
  bool firm = false;
};
/// The arc by which the material that is bent with a fold turns, at one end of its ridge, must have
/// at least the smallest radius.
struct RadiusLimit {
  int ridge = 0;
  int side = 0;
};
/// Inequalities hold if none is broken by more than this (in strip lengths or mean spacings).
constexpr double kHolds = 1e-7;

struct Inequality {
  std::variant<HalfSpace, RadiusLimit> what;
  double multiplier = 0.0;
  bool is_firm() const {
    const auto* space = std::get_if<HalfSpace>(&what);
    return !space || space->firm;
  }
};

struct StripAnchor {
  int ridge = 0;
  int side = 0;
  Vec3 at = Vec3::Zero();
};

/// The problem of one strip: end conditions, inequalities, and the objective of
/// math.md#strip-conditions as a sum of squares. Lengths are divided by the strip's length.
///
/// Second differences of the angles are weighted by (quads/10)⁵: then their sum approximates ∫ κ″²
/// and keeps its value when a strip is divided more finely; at ten quads the weight is that of the
/// paper (bibliography.md#slits). If a strip continues in its mirror image, so do the differences:
/// the last one is that of θ_M−2, θ_M−1 and its image θ_M−1. The barrier Σ 1/Δ of spacings whose
/// sum is given equals Σ (Δ − h)²/(Δ h²) and a constant, h the mean: that is a sum of squares which
/// vanish at equal spacing, so that Gauss–Newton steps converge. Its mean over the quads is taken.
struct StripProblem {
  StripBase base;
  std::vector<EndCondition> ends;
  bool mirrored = false;           ///< the strip continues smoothly in its mirror image
  std::optional<Frame> far_facet;  ///< of the panel at the strip's end, y along the last ridge; the
                                   ///< fold there counts
  SlitObjective objective = SlitObjective::smooth;
  StripLoad load = {};  ///< of `SlitObjective::energy`
  SlitWeights weights;
  std::vector<StripAnchor> anchors;
  std::shared_ptr<const BezierSearch> seat;
  std::array<Vec2, 2> seat_places{};  ///< on the seat curve, of the end's corners
  std::shared_ptr<const ScannedSurface> scan;
  double min_radius = 0.0;
  std::vector<Inequality> inequalities;
  double penalty = 0.0;  ///< of violated inequalities, for the augmented Lagrangian

  int parameters() const { return parameter_count(base.quads); }
  int residuals() const;
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// False if ridges of a quad cross or a fold reaches half a turn: there is no shape. A null
/// Jacobian is not computed. The objective is half the sum of squares and, with
/// `SlitObjective::energy`, the scaled bending energy (bend_energy.hpp).
bool evaluate(const StripProblem& problem, const StripParameters& p,
              Eigen::Ref<Eigen::VectorXd> residuals, Eigen::Ref<RowMatrix>* jacobian);

/// By which a wish or an inequality draws at the end of a ridge: the derivative of the objective by
/// that place.
struct Pull {
  int ridge = 0;
  int side = 0;
  Vec3 gradient = Vec3::Zero();
};
std::vector<Pull> pulls(const StripProblem& problem, const StripFold& fold);

/// Second derivatives of the radius limits, each times what it adds to the objective's slope.
Eigen::MatrixXd limit_curvature(const StripProblem& problem, const StripParameters& p);

/// Ridges in order on both sides, no fold of half a turn.
bool is_shape(const StripBase& base, const StripParameters& p);

/// What a condition is about, in space.
Vec3 end_vector(EndCondition::Of of, const StripBase& base, const StripFold& fold);

/// By how much end conditions are missed, in units of the strip's length or of a unit vector, and
/// the derivative.
Eigen::VectorXd end_violation(const StripProblem& problem, const StripFold& fold);
RowMatrix end_derivative(const StripProblem& problem, const StripFold& fold);

/// Values g ≤ 0 of the inequalities, in strip lengths or mean spacings.
Eigen::VectorXd inequality_values(const StripProblem& problem, const StripParameters& p);

/// Largest distance of the end from where it must be, mm.
double end_gap(const StripProblem& problem, const StripFold& fold);

/// That of the last quad, y along the last ridge.
Frame last_frame(const StripBase& base, const StripParameters& p);

/// Angle of the fold at a strip's end, from its last quad to the panel there; y of both along the
/// last ridge.
Angle fold_into(const Frame& last, const Frame& facet);

/// The tightest fold: radius of the arc on the material that is bent with it (bent_fold.hpp).
struct Tightest {
  double radius = 0.0;
  int ridge = 0;
};
/// The fold into the panel at the strip's end.
Tightest far_fold(const StripProblem& problem, const StripParameters& p);
Tightest tightest_fold(const StripProblem& problem, const StripParameters& p);
/// The limits of a problem that are violated or nearly so.
std::vector<RadiusLimit> radius_limits(const StripProblem& problem, const StripParameters& p);

}  // namespace planish::slit_detail
