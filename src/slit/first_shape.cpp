#include "first_shape.hpp"

#include "bend_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

// Shapes from which a strip's descent begins. Curves in one plane whose angle runs from start to
// end with one bulge are tried on a grid, the best refined in each number in turn, by what they
// cost the objective: smoothness and how far the end misses. Of equally smooth ones the one that
// bends least is better, as curls of evenly growing angles are smooth too. More than one is
// returned, since a first shape may lead into folds that no step undoes.

namespace planish::slit_detail {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;
constexpr double kLargestFold = 2.8;  // radians

/// Requirements on the curve in the plane, in strip lengths: how far it runs away from the panel's
/// plane, how far along it, and the angle to it at the end.
struct Wanted {
  std::optional<double> away, along;
  double along_weight = 1.0;
  std::optional<double> end_angle;
  double direction = 1.0;           ///< sign of the folds that lead there
  double panel_angle = 0.0;         ///< of the panel, from the direction in which `along` counts
  std::optional<double> far_angle;  ///< of the panel at the strip's end, likewise
};

/// Angle of the curve to the direction in which `along` counts, from its start (0) to its end (1).
struct Bow {
  double start = 0.0, end = 0.0, bow = 0.0;
  double at(double s) const { return start + (end - start) * s + 4.0 * bow * s * (1.0 - s); }
};

const EndCondition* condition_of(const StripProblem& problem, EndCondition::Of of) {
  const auto found = std::ranges::find(problem.ends, of, &EndCondition::of);
  return found == problem.ends.end() ? nullptr : &*found;
}

Vec3 middle_of_start(const StripBase& base) {
  const Vec2 middle = base.middle_of_start();
  return base.facet.point(middle);
}

/// The end is to lie in a plane (symmetric sheets). Away from the panel is straight towards the
/// plane, along is upwards, also where the panel leans.
Wanted up_to_plane(const StripProblem& problem, const EndCondition& plane) {
  const Vec3 start = middle_of_start(problem.base);
  const Frame& facet = problem.base.facet;
  const double distance = plane.value - plane.gradient.dot(start);
  const Vec3 towards = (distance < 0.0 ? -1.0 : 1.0) *
                       (plane.gradient - plane.gradient.dot(facet.y) * facet.y);
  constexpr double kStretched = 0.99, kParallel = 0.1;
  const double slope = towards.norm();
  const Vec3 away = slope > 0.0 ? Vec3(towards / slope) : Vec3(-facet.z);
  Vec3 up = away.cross(facet.y);
  if (up.y() < 0.0) up = -up;
  Wanted wanted;
  wanted.direction = up.cross(away).dot(facet.y) < 0.0 ? -1.0 : 1.0;
  wanted.panel_angle = std::atan2(facet.x.dot(away), facet.x.dot(up));
  wanted.away = std::min(kStretched,
                         std::abs(distance) / std::max(kParallel, slope) / problem.base.unit());
  wanted.end_angle = kRightAngle;
  if (problem.seat) {
    wanted.along = up.tail<2>().dot(0.5 * (problem.seat_places[0] + problem.seat_places[1]) -
                                    start.tail<2>()) /
                   problem.base.unit();
    wanted.along_weight = problem.weights.seat /
                          std::max(problem.weights.seat, problem.weights.smooth);
  }
  return wanted;
}

/// The end is to be at a point, or to run in a direction.
Wanted up_to_point(const StripProblem& problem) {
  const StripBase& base = problem.base;
  Wanted wanted;
  Vec3 place = Vec3::Zero(), direction = Vec3::Zero();
  bool placed = false, directed = false;
  for (const EndCondition& condition : problem.ends) {
    if (condition.of == EndCondition::Of::middle)
      place += condition.value * condition.gradient, placed = true;
    directed |= condition.of == EndCondition::Of::along;
  }
  if (directed) {
    std::vector<Vec3> across;
    for (const EndCondition& condition : problem.ends)
      if (condition.of == EndCondition::Of::along) across.push_back(condition.gradient);
    if (across.size() == 2) direction = across[0].cross(across[1]);
  }
  if (placed) {
    const Vec3 way = place - middle_of_start(base);
    wanted.along = way.dot(base.facet.x) / base.unit();
    const double away = -way.dot(base.facet.z) / base.unit();
    wanted.direction = away < 0.0 ? -1.0 : 1.0;
    wanted.away = std::hypot(away, way.dot(base.facet.y) / base.unit());
  }
  if (directed)
    wanted.end_angle = std::atan2(-wanted.direction * direction.dot(base.facet.z),
                                  direction.dot(base.facet.x));
  if (problem.far_facet) {
    const Vec3& beyond = problem.far_facet->x;
    // A strip that turns all the way round to the panel does so on the side where it lies.
    const double angle = std::atan2(-wanted.direction * beyond.dot(base.facet.z),
                                    beyond.dot(base.facet.x));
    wanted.far_angle = angle < -kRightAngle ? angle + 4.0 * kRightAngle : angle;
  }
  return wanted;
}

std::optional<Wanted> wanted_of(const StripProblem& problem) {
  if (problem.ends.empty()) return std::nullopt;
  if (const EndCondition* plane = condition_of(problem, EndCondition::Of::left_end))
    return up_to_plane(problem, *plane);
  return up_to_point(problem);
}

constexpr int kPieces = 10;
using Folds = std::array<double, kPieces>;

/// The energy of folds as the objective has it (bend_energy.hpp). `far`: the fold into a panel.
double energy_of(const Folds& folds, std::optional<double> far, const Wanted& wanted,
                 const StripProblem& problem) {
  const double last_share = wanted.end_angle && !far ? 1.5 : 1.0;
  double squares = 2.0 * folds[0] * folds[0] + folds[kPieces - 1] * folds[kPieces - 1] / last_share;
  for (std::size_t i = 1; i + 1 < folds.size(); ++i)
    squares += folds[i] * folds[i];
  if (far) squares += 2.0 * *far * *far;
  const StripBase& base = problem.base;
  return energy_scale(base) * 0.5 * squares * kPieces * base.width() / base.unit();
}

/// Second differences of folds, as the objective weighs them. Curls whose angles grow evenly are
/// smooth too; of equally smooth curves the one that bends least is wanted.
double unsmoothness_of(const Folds& folds, std::optional<double> far, const StripProblem& problem) {
  constexpr double kBending = 0.01;
  constexpr double kLeastWeight = 1e-6;  // so that it decides if smoothness has no weight
  const double last = folds[kPieces - 1] - folds[kPieces - 2];
  double unsmooth = 0.0;
  for (std::size_t i = 1; i + 1 < folds.size(); ++i) {
    const double second = 2.0 * folds[i] - folds[i - 1] - folds[i + 1];
    unsmooth += second * second;
  }
  if (problem.mirrored) unsmooth += last * last;
  if (far) unsmooth += (last + folds[kPieces - 1] - *far) * (last + folds[kPieces - 1] - *far);
  for (const double fold : folds)
    unsmooth += kBending * fold * fold;
  return std::max(problem.weights.smooth, kLeastWeight) * unsmooth;
}

/// What the objective would be, and squares of misses.
double cost_of(const Bow& bow, const Wanted& wanted, const StripProblem& problem) {
  constexpr double kMissed = 100.0;
  double away = 0.0, along = 0.0, angle = wanted.panel_angle;
  Folds folds{};
  for (int i = 0; i < kPieces; ++i) {
    const double next = bow.at((i + 0.5) / kPieces);
    folds[i] = next - angle;
    if (std::abs(next - angle) > kLargestFold) return std::numeric_limits<double>::infinity();
    angle = next;
    away += std::sin(angle) / kPieces;
    along += std::cos(angle) / kPieces;
  }
  const auto far = wanted.far_angle ? std::optional(*wanted.far_angle - angle) : std::nullopt;
  double cost = problem.objective == SlitObjective::energy ? energy_of(folds, far, wanted, problem)
                                                           : unsmoothness_of(folds, far, problem);
  if (wanted.away) cost += kMissed * (away - *wanted.away) * (away - *wanted.away);
  if (wanted.along)
    cost += kMissed * wanted.along_weight * (along - *wanted.along) * (along - *wanted.along);
  return cost;
}

struct Candidate {
  Bow bow;
  double cost = 0.0;
};

/// Every 30°; the end's angle, if free, every 60°.
std::vector<Candidate> coarse_bows(const StripProblem& problem, const Wanted& wanted) {
  constexpr double kStep = std::numbers::pi / 6.0;
  std::vector<Candidate> candidates;
  for (int end = -3; end <= 9; end += wanted.end_angle ? 13 : 2)
    for (int start = -5; start <= 5; ++start)
      for (int bow = -6; bow <= 6; ++bow) {
        const Bow candidate{start * kStep, wanted.end_angle.value_or(end * kStep), bow * kStep};
        candidates.push_back({candidate, cost_of(candidate, wanted, problem)});
      }
  return candidates;
}

/// Steps in each number in turn, halved if none helps.
Candidate refined(Candidate best, const StripProblem& problem, const Wanted& wanted) {
  constexpr double kFirst = std::numbers::pi / 12.0, kLast = 0.005;
  for (double step = kFirst; step > kLast;) {
    bool lower = false;
    for (double Bow::*number : {&Bow::start, &Bow::bow, &Bow::end})
      for (const double by : {step, -step}) {
        if (number == &Bow::end && wanted.end_angle) continue;
        Bow moved = best.bow;
        moved.*number += by;
        if (const double cost = cost_of(moved, wanted, problem); cost < best.cost)
          best = {moved, cost}, lower = true;
      }
    if (!lower) step *= 0.5;
  }
  return best;
}

bool are_alike(const Bow& a, const Bow& b) {
  constexpr double kAlike = 0.15;  // radians
  return std::abs(a.start - b.start) + std::abs(a.end - b.end) + std::abs(a.bow - b.bow) < kAlike;
}

/// Those that lead to another shape than any before.
std::vector<Candidate> different_ones(const std::vector<Candidate>& candidates, std::size_t most) {
  std::vector<Candidate> different;
  for (const Candidate& candidate : candidates) {
    const bool known = std::ranges::any_of(
        different, [&](const Candidate& other) { return are_alike(candidate.bow, other.bow); });
    if (!known && different.size() < most) different.push_back(candidate);
  }
  return different;
}

/// Several curves reach as far as they must; which is best shows only when each does so exactly.
/// For smoothness one after another of the best is tried until one does; of least energy is the
/// least of all, so that they are to differ.
std::vector<Candidate> best_bows(const StripProblem& problem, const Wanted& wanted) {
  constexpr std::size_t kTried = 8, kRefined = 24;
  const bool of_all = problem.objective == SlitObjective::energy;
  const std::size_t refined_ones = of_all ? kRefined : kTried;
  std::vector<Candidate> candidates = coarse_bows(problem, wanted);
  const auto cheaper = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
  std::partial_sort(candidates.begin(),
                    candidates.begin() + static_cast<std::ptrdiff_t>(refined_ones),
                    candidates.end(), cheaper);
  candidates.resize(refined_ones);
  for (Candidate& candidate : candidates)
    candidate = refined(candidate, problem, wanted);
  std::ranges::sort(candidates, cheaper);
  return of_all ? different_ones(candidates, kTried) : candidates;
}

StripParameters bent(const StripBase& base, const Bow& bow, const Wanted& wanted) {
  StripParameters p = flat_parameters(base);
  double angle = wanted.panel_angle;
  for (int i = 0; i < base.quads; ++i) {
    const double next = i + 1 == base.quads ? bow.end : bow.at((i + 0.5) / base.quads);
    p[i] = wanted.direction * (next - angle);
    angle = next;
  }
  return p;
}

}  // namespace

std::vector<StripParameters> first_shapes(const StripProblem& problem) {
  std::vector<StripParameters> shapes;
  if (const auto wanted = wanted_of(problem))
    for (const Candidate& candidate : best_bows(problem, *wanted))
      shapes.push_back(bent(problem.base, candidate.bow, *wanted));
  shapes.push_back(flat_parameters(problem.base));
  return shapes;
}

}  // namespace planish::slit_detail
