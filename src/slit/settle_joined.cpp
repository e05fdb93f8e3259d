// Where the uncut sheet beyond slits that end in the middle of it lies (math.md#joined-strips). For
// a given place each strip is solved by itself, its end held there exactly; what remains is a
// function of that place alone, a frame and the turns between facets. By the envelope theorem its
// slope is the wrench with which the facets hold the strips, so quasi-Newton steps (BFGS) over few
// numbers find the least energy, begun with the stiffness of each strip's end. Steps are taken
// along what placed ends leave free, and led back to them.
#include "settle_joined.hpp"

#include "bend_energy.hpp"
#include "design_load.hpp"
#include "resting_strip.hpp"
#include "strip_work.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace planish::slit_detail {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Wrench6 = Eigen::Matrix<double, 6, 1>;  // force, then moment about the origin

constexpr double kStripTolerance = 1e-13;  // strips are solved finer than what they are part of

DescentOptions fine(DescentOptions options) {
  options.function_tolerance = std::min(options.function_tolerance, kStripTolerance);
  return options;
}

/// In newtons and mm for D = 1 N mm: what the facet does to the strip.
Wrench6 wrench_on(const Snapshot& now, int strip) {
  const StripProblem problem = problem_of(now, strip);
  const RestingStrip rest(problem, now.slot(strip).p, {}, least_height(now, strip));
  Wrench6 wrench = Wrench6::Zero();
  for (const SlitReaction& one : rest.reactions(strip, 1.0 / energy_scale(problem.base)))
    if (one.end == HeldBy::end) wrench << one.force, one.moment + one.at.cross(one.force);
  return wrench;
}

double weight_of_facets(const Snapshot& now) {
  const SlitDesign& design = *now.design;
  return design.material
             ? weight_per_area(design) / design.material->rigidity(design.sheet.thickness)
             : 0.0;
}

/// Lengths in which moves are counted, so that all are of one size: those of strips, and 1 of
/// turns.
VectorXd units_of_moves(const Snapshot& now, const JoinedEnds& joined) {
  const bool symmetric = now.design->sheet.symmetric;
  VectorXd units = VectorXd::Ones((symmetric ? 3 : 6) + std::ssize(joined.turns));
  units.head(symmetric ? 2 : 3).setConstant(base_of(now, joined.first).unit());
  return units;
}

Wrench6 as_wrench(const JoinedMove& move) {
  Wrench6 both;
  both << move.move, move.turn;
  return both;
}

/// Placed ends of joined strips: by how much they are missed, and the derivative by the moves, in
/// the units of moves.
struct Missed {
  VectorXd by;
  MatrixXd slope;
};

Missed missed_ends(const Snapshot& now, const JoinedEnds& joined) {
  const SlitSheet& sheet = now.design->sheet;
  const std::vector<PanelFacet> facets = facets_of(sheet, joined);
  const std::vector<JoinedMove> moves = moves_of(facets, sheet.symmetric);
  const VectorXd units = units_of_moves(now, joined);
  std::vector<double> by;
  std::vector<VectorXd> slopes;
  for (const PanelFacet& facet : facets) {
    const StripBase base = base_of(now, facet.strip);
    const Frame turned = base.along_last_ridge(facet.frame);
    for (const EndCondition& end : conditions_of(now.design->ends[facet.strip])) {
      const bool is_point = end.is_length();
      const Vec3 v = is_point ? facet.frame.point(0.5 * (facet.corners[1] + facet.corners[2]))
                     : end.of == EndCondition::Of::along ? facet.frame.x
                                                         : turned.y;
      const double scale = is_point ? 1.0 / base.unit() : 1.0;
      by.push_back(scale * (end.gradient.dot(v) - end.value));
      VectorXd slope = VectorXd::Zero(units.size());
      for (std::size_t k = 0; k < moves.size(); ++k)
        if (moves[k].from <= facet.strip - joined.first)
          slope[static_cast<Eigen::Index>(k)] = scale * units[static_cast<Eigen::Index>(k)] *
                                                end.gradient.dot(
                                                    is_point ? moves[k].at(v)
                                                             : Vec3(moves[k].turn.cross(v)));
      slopes.push_back(std::move(slope));
    }
  }
  Missed all{VectorXd::Map(by.data(), std::ssize(by)), MatrixXd(std::ssize(by), units.size())};
  for (std::size_t i = 0; i < slopes.size(); ++i)
    all.slope.row(static_cast<Eigen::Index>(i)) = slopes[i].transpose();
  return all;
}

/// Led to the placed ends by least steps.
std::optional<JoinedEnds> led_to_ends(const Snapshot& now, JoinedEnds joined) {
  constexpr int kMostSteps = 20;
  constexpr double kThere = 1e-13;
  const SlitSheet& sheet = now.design->sheet;
  const VectorXd units = units_of_moves(now, joined);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    const Missed missed = missed_ends(now, joined);
    if (missed.by.size() == 0) return joined;
    const double most = missed.by.cwiseAbs().maxCoeff();
    if (most <= kThere || (most < 1e3 * kThere && most >= 0.5 * before)) return joined;
    before = most;
    const VectorXd step = missed.slope.completeOrthogonalDecomposition().solve(-missed.by);
    joined = moved(sheet, joined, sheet.symmetric, units.cwiseProduct(step));
  }
  return std::nullopt;
}

/// A shape for each strip, its end free as far as the design leaves it.
int solve_apart(Snapshot& now, const JoinedEnds& joined, const DescentOptions& options) {
  int iterations = 0;
  std::vector<int> strips(joined.last - joined.first + 1);
  std::iota(strips.begin(), strips.end(), joined.first);
  for (const int strip : strips)
    iterations += work_on(now, strip, Clear::of_mirror, options).iterations;
  return iterations + improve_from_neighbours(now, strips, options);
}

/// Near where the strips end by themselves: facets turned as their ends are, in their middle.
JoinedEnds along_ends(const Snapshot& now, JoinedEnds joined) {
  const SlitSheet& sheet = now.design->sheet;
  std::vector<FoldedStrip> strips;
  for (int strip = joined.first; strip <= joined.last; ++strip)
    strips.push_back(folded_of(now, strip));
  const std::size_t from = sheet.symmetric ? 0 : strips.size() / 2;
  joined.frame = strips[from].quads.back();
  const auto turn_between = [&](const Frame& a, const Frame& b) {
    return std::atan2(a.y.dot(-b.z), a.y.dot(b.y));
  };
  for (std::size_t i = 0; i + 1 < strips.size(); ++i)
    joined.turns[i] = turn_between(strips[i].quads.back(), strips[i + 1].quads.back());
  // The frame of the first, so that the one in the middle is where its strip ends; then all where
  // they are off least.
  const auto facet_of = [&](std::size_t i) { return facets_of(sheet, joined)[i].frame; };
  for (int round = 0; round < 2; ++round) {
    const Frame has = facet_of(from), wants = strips[from].quads.back();
    Eigen::Matrix3d a, b;
    a << has.x, has.y, has.z;
    b << wants.x, wants.y, wants.z;
    const Eigen::Matrix3d turn = b * a.transpose();
    Frame& frame = joined.frame;
    frame = {turn * (frame.origin - has.origin) + wants.origin, turn * frame.x, turn * frame.y,
             turn * frame.z};
  }
  const std::vector<PanelFacet> facets = facets_of(sheet, joined);
  Vec3 off = Vec3::Zero();
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side)
      off += strips[i].ridges.back().folded[side] -
             facets[i].frame.point(facets[i].corners[1 + side]);
  if (sheet.symmetric) off.x() = 0.0;
  joined.frame.origin += off / (2.0 * static_cast<double>(facets.size()));
  return joined;
}

/// In symmetric sheets facets are at right angles to the plane to the last bit.
JoinedEnds squared(const Snapshot& now, JoinedEnds joined) {
  if (!now.design->sheet.symmetric) return joined;
  Frame& frame = joined.frame;
  frame.x = -half_sign(now) * Vec3::UnitX();
  frame.y = Vec3(0.0, frame.y.y(), frame.y.z()).normalized();
  frame.z = frame.x.cross(frame.y);
  frame.origin.x() = half_sign(now) * now.design->sheet.far_line();
  return joined;
}

class Settling {
 public:
  Settling(const Snapshot& now, std::size_t run, const DescentOptions& options)
      : run_(run), options_(fine(options)), begun_(now) {}

  int settle(Snapshot& now) {
    auto at = begun();
    const bool led = at && descend(*at);
    if (at) now = at->now;
    for (int strip = joined_of(now).first; strip <= joined_of(now).last; ++strip) {
      Slot slot = now.slot(strip);
      if (!led && slot.state.status == StripStatus::solved) slot.state.status = StripStatus::open;
      if (!at) slot.state.status = StripStatus::out_of_reach;
      now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
    }
    return iterations_;
  }

 private:
  const JoinedEnds& joined_of(const Snapshot& now) const { return now.joined[run_]; }
  bool symmetric() const { return begun_.design->sheet.symmetric; }
  bool stopped() const { return options_.stop && options_.stop(); }

  std::optional<JoinedPlace> place(const Snapshot& from, const JoinedEnds& joined) {
    const auto led = led_to_ends(from, joined);
    if (!led) return std::nullopt;
    JoinedPlace at = joined_place(from, run_, *led, options_);
    iterations_ += at.iterations;
    if (!at.met) return std::nullopt;
    return at;
  }

  /// From where it was, or from where strips end by themselves.
  std::optional<JoinedPlace> begun() {
    if (begun_.placed && begun_.slot(joined_of(begun_).first).p.size() > 0)
      if (auto at = place(begun_, joined_of(begun_))) return at;
    Snapshot apart = begun_;
    apart.second_panel = std::make_shared<const std::vector<PanelFacet>>();
    iterations_ += solve_apart(apart, joined_of(begun_), options_);
    return place(apart, squared(begun_, along_ends(apart, joined_of(begun_))));
  }

  /// Second derivatives by the moves, in their units: of strips by small moves of their ends.
  MatrixXd stiffness(const JoinedPlace& at) {
    constexpr double kSmall = 1e-4;
    const SlitSheet& sheet = begun_.design->sheet;
    const JoinedEnds& joined = joined_of(at.now);
    const std::vector<PanelFacet> facets = facets_of(sheet, joined);
    const std::vector<JoinedMove> moves = moves_of(facets, symmetric());
    const VectorXd units = units_of_moves(at.now, joined);
    const auto count = static_cast<Eigen::Index>(moves.size());
    MatrixXd all = MatrixXd::Zero(count, count);
    for (std::size_t i = 0; i < facets.size() && !stopped(); ++i) {
      const int strip = facets[i].strip;
      const Wrench6 rest = wrench_on(at.now, strip);
      MatrixXd of_strip = MatrixXd::Zero(6, count);
      for (Eigen::Index k = 0; k < count; ++k) {
        if (moves[k].from > static_cast<int>(i)) continue;
        VectorXd step = VectorXd::Zero(count);
        step[k] = kSmall * units[k];
        Snapshot beside = at.now;
        put(beside, moved(sheet, joined, symmetric(), step));
        iterations_ += work_on(beside, strip, Clear::of_mirror, options_).iterations;
        if (beside.slot(strip).state.status == StripStatus::solved)
          of_strip.col(k) = (wrench_on(beside, strip) - rest) / kSmall;
      }
      for (Eigen::Index k = 0; k < count; ++k)
        if (moves[k].from <= static_cast<int>(i))
          all.row(k) += units[k] * as_wrench(moves[k]).transpose() * of_strip;
    }
    const std::vector<double> own = turning_stiffness(sheet, joined);
    for (std::size_t i = 0; i < own.size(); ++i)
      all(count - std::ssize(own) + static_cast<Eigen::Index>(i),
          count - std::ssize(own) + static_cast<Eigen::Index>(i)) += own[i];
    return made_convex(0.5 * (all + all.transpose()));
  }

  static MatrixXd made_convex(const MatrixXd& matrix) {
    constexpr double kLeast = 1e-6;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(matrix);
    const double most = parts.eigenvalues().cwiseAbs().maxCoeff();
    const VectorXd values = parts.eigenvalues().cwiseAbs().cwiseMax(
        std::max(kLeast * most, std::numeric_limits<double>::min()));
    return parts.eigenvectors() * values.asDiagonal() * parts.eigenvectors().transpose();
  }

  void put(Snapshot& now, JoinedEnds joined) const {
    std::vector<JoinedEnds> all = now.joined;
    all[run_] = std::move(joined);
    take_joined(now, std::move(all));
  }

  /// The step that is least along what placed ends leave free, in the units of moves; and by how
  /// much the value would fall.
  struct Step {
    VectorXd by;
    double gain = 0.0;
  };
  Step step_from(const JoinedPlace& at, const MatrixXd& second) const {
    const VectorXd units = units_of_moves(at.now, joined_of(at.now)),
                   slope = units.cwiseProduct(at.slope);
    MatrixXd free = MatrixXd::Identity(slope.size(), slope.size());
    if (const Missed missed = missed_ends(at.now, joined_of(at.now)); missed.by.size() > 0) {
      const Eigen::ColPivHouseholderQR<MatrixXd> split(missed.slope.transpose());
      const MatrixXd turned = split.householderQ();
      free = turned.rightCols(slope.size() - split.rank());
    }
    if (free.cols() == 0) return {VectorXd::Zero(slope.size()), 0.0};
    const MatrixXd reduced = free.transpose() * second * free;
    const VectorXd by = -free * reduced.ldlt().solve(free.transpose() * slope);
    return {by, -slope.dot(by)};
  }

  bool descend(JoinedPlace& at) {
    constexpr int kMostSteps = 200, kMostHalvings = 12;
    constexpr double kGain = 1e-9, kLargest = 0.2, kEnough = 1e-4;
    MatrixXd second = stiffness(at);
    bool is_fresh = true;
    for (int i = 0; i < kMostSteps && !stopped(); ++i) {
      const Step step = step_from(at, second);
      if (step.gain <= kGain * std::abs(at.value) + std::numeric_limits<double>::min()) return true;
      const VectorXd units = units_of_moves(at.now, joined_of(at.now));
      double share = std::min(1.0, kLargest / step.by.cwiseAbs().maxCoeff());
      std::optional<JoinedPlace> next;
      for (int halved = 0; halved < kMostHalvings && !stopped(); ++halved, share *= 0.5) {
        next = place(at.now, moved(begun_.design->sheet, joined_of(at.now), symmetric(),
                                   share * units.cwiseProduct(step.by)));
        if (next && next->value <= at.value - kEnough * share * step.gain) break;
        next.reset();
      }
      if (!next) {
        if (is_fresh) return step.gain <= std::sqrt(kGain) * std::abs(at.value);
        second = stiffness(at), is_fresh = true;
        continue;
      }
      is_fresh = false;
      update(second, share * step.by, units.cwiseProduct(next->slope - at.slope));
      at = std::move(*next);
    }
    return false;
  }

  /// Of BFGS, damped so that it stays convex (Powell).
  static void update(MatrixXd& second, const VectorXd& step, VectorXd change) {
    constexpr double kLeastShare = 0.2;
    const VectorXd pulled = second * step;
    const double bent = step.dot(pulled), found = step.dot(change);
    if (!(bent > 0.0)) return;
    if (found < kLeastShare * bent) {
      const double share = (1.0 - kLeastShare) * bent / (bent - found);
      change = share * change + (1.0 - share) * pulled;
    }
    second += change * change.transpose() / step.dot(change) - pulled * pulled.transpose() / bent;
  }

  std::size_t run_;
  DescentOptions options_;
  Snapshot begun_;
  int iterations_ = 0;
};

}  // namespace

JoinedPlace joined_place(const Snapshot& from, std::size_t run, const JoinedEnds& joined,
                         const DescentOptions& options) {
  JoinedPlace at;
  at.now = from;
  std::vector<JoinedEnds> all = from.joined;
  all[run] = joined;
  take_joined(at.now, std::move(all));
  const SlitSheet& sheet = from.design->sheet;
  const std::vector<PanelFacet> facets = facets_of(sheet, joined);
  const std::vector<JoinedMove> moves = moves_of(facets, sheet.symmetric);
  const std::vector<double> stiffness = turning_stiffness(sheet, joined);
  at.value = turning_energy(sheet, joined);
  at.slope = VectorXd::Zero(static_cast<Eigen::Index>(moves.size()));
  const std::size_t rigid = moves.size() - stiffness.size();
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    at.slope[static_cast<Eigen::Index>(rigid + i)] = stiffness[i] * joined.turns[i];
  const double weight = weight_of_facets(from);
  for (const PanelFacet& facet : facets) {
    at.iterations += work_on(at.now, facet.strip, Clear::of_mirror, options).iterations;
    const StripState& state = at.now.slot(facet.strip).state;
    if (state.status == StripStatus::out_of_reach) return at;
    const Vec3 centroid = centroid_of(facet);
    const double pull = weight * area_of(facet);
    at.value += state.objective / energy_scale(base_of(at.now, facet.strip)) + pull * centroid.y();
    const Wrench6 wrench = wrench_on(at.now, facet.strip);
    for (std::size_t k = 0; k < moves.size(); ++k)
      if (moves[k].from <= facet.strip - joined.first)
        at.slope[static_cast<Eigen::Index>(k)] += wrench.dot(as_wrench(moves[k])) +
                                                  pull * moves[k].at(centroid).y();
  }
  at.met = true;
  return at;
}

int settle_joined(Snapshot& now, std::size_t run, const DescentOptions& options) {
  return Settling(now, run, options).settle(now);
}

}  // namespace planish::slit_detail
