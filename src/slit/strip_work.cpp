#include "strip_work.hpp"

#include "bend_energy.hpp"
#include "crossing.hpp"
#include "strip_start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

// One strip of a snapshot solved and measured, and neighbours parted. What a strip must not cross
// is asked for anew in every round, since it depends on its shape. Of two strips that cross, the
// one gives way for which their total objective is better; pairs are taken by their properties and
// not their numbers, so that a mirrored sheet gives the mirrored result.

namespace planish::slit_detail {
namespace {

/// A limit missed by more (of the radius, of the strip's length) is reported: ten times the
/// solver's tolerance.
constexpr double kReported = 10.0 * kHolds;

/// Ends that point the wrong way meet their condition as well as those that point the right way.
bool ends_backwards(const StripEnd& end, const FoldedStrip& strip) {
  const Frame& last = strip.quads.back();
  return (end.direction && end.direction->dot(last.x) < 0.0) ||
         (end.across && end.across->dot(last.y) < 0.0);
}

Eigen::AlignedBox3d box_of(const StripBase& base, const StripParameters& p) {
  const StripFold fold = folded(base, p);
  Eigen::AlignedBox3d box;
  for (const auto& side : fold.ends)
    for (const Vec3& end : side)
      box.extend(end);
  return box;
}

/// Distance of the ends of the last ridge from the corners of the facet at which they must be.
double gap_to_panel(const PanelFacet* facet, const FoldedStrip& strip) {
  double gap = 0.0;
  for (std::size_t side = 0; facet && side < 2; ++side)
    gap = std::max(
        gap,
        (strip.ridges.back().folded[side] - facet->frame.point(facet->corners[1 + side])).norm());
  return gap;
}

bool is_behind_mirror(const Snapshot& now, int strip, const FoldedStrip& shape) {
  return now.design->sheet.symmetric &&
         depth_behind_mirror(shape, half_sign(now)) > kReported * base_of(now, strip).unit();
}

/// 0 where it is less than is reported.
double depth_in_ground(const Snapshot& now, int strip, const FoldedStrip& shape) {
  const auto height = least_height(now, strip);
  const double depth = height ? depth_below(shape, *height) : 0.0;
  return depth > kReported * base_of(now, strip).unit() ? depth : 0.0;
}

/// The report on a strip, measured on its shape.
StripState measured(const Snapshot& now, int strip, const StripProblem& problem,
                    const StripSolution& solution) {
  const FoldedStrip shape = folded_strip(problem.base, solution.p);
  const StripFold fold = folded(problem.base, solution.p);
  StripState state;
  state.gap = std::max(end_gap(problem, fold), gap_to_panel(far_facet_of(now, strip), shape));
  const bool backwards = !now.design->sheet.symmetric && ends_backwards(end_of(now, strip), shape);
  state.status = !solution.reached || backwards ? StripStatus::out_of_reach
                 : solution.converged           ? StripStatus::solved
                                                : StripStatus::open;
  if (!solution.reached) state.shortfall = state.gap;
  const Tightest folds = tightest_fold(problem, solution.p), far = far_fold(problem, solution.p);
  const Tightest tightest = far.radius < folds.radius ? far : folds;
  state.min_radius = tightest.radius;
  state.tightest_ridge = tightest.ridge;
  state.too_tight = tightest.radius < problem.min_radius * (1.0 - kReported);
  state.crosses_plane = is_behind_mirror(now, strip, shape);
  state.below_ground = depth_in_ground(now, strip, shape);
  state.objective = solution.objective;
  state.energy = bend_energy(problem, solution.p);
  if (problem.seat)
    for (const Vec3& end : shape.ridges.back().folded)
      state.seat_distance = std::max(
          state.seat_distance, (problem.seat->nearest(end.tail<2>()).point - end.tail<2>()).norm());
  for (const StripAnchor& anchor : problem.anchors)
    state.anchor_distance = std::max(state.anchor_distance,
                                     (fold.end(anchor.side, anchor.ridge) - anchor.at).norm());
  if (problem.scan) {
    double sum = 0.0;
    for (int ridge = 1; ridge <= problem.base.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        sum += (problem.scan->nearest(fold.end(side, ridge)).point - fold.end(side, ridge))
                   .squaredNorm();
    state.scan_distance = std::sqrt(sum / (2.0 * problem.base.quads));
  }
  state.iterations = solution.iterations;
  return state;
}

/// Puts a solution in the place of a strip's shape.
void take(Snapshot& now, int strip, const StripProblem& problem, const StripSolution& solution) {
  Slot slot = now.slot(strip);
  slot.p = solution.p;
  const auto runner_up = solution.runner_up ? solution.runner_up : slot.state.runner_up_energy;
  slot.state = measured(now, strip, problem, solution);
  slot.state.runner_up_energy = runner_up;
  slot.inequalities = solution.inequalities;
  slot.box = box_of(problem.base, solution.p);
  slot.touches = false;
  std::erase_if(slot.inequalities, [](const Inequality& known) {
    return std::holds_alternative<HalfSpace>(known.what);
  });
  now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

/// Another shape from which a strip's descent begins.
void take_start(Snapshot& now, int strip, const StripParameters& from) {
  Slot slot = now.slot(strip);
  slot.state.runner_up_energy = slot.state.energy;
  slot.p = from;
  now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

bool is_better(const Slot& tried, const Slot& known, double share) {
  return tried.state.status == StripStatus::solved && !tried.state.crosses_plane &&
         (known.state.status != StripStatus::solved ||
          tried.state.objective < (1.0 - share) * known.state.objective);
}

bool is_folded(const Snapshot& now, int strip) {
  return strip >= 0 && strip < now.count() && now.slot(strip).p.size();
}

}  // namespace

PlanesBroken planes_broken(const Snapshot& now, int strip, Clear clear) {
  std::vector<std::pair<StripEdge, FoldedStrip>> neighbours;
  if (clear == Clear::of_neighbours) {
    if (is_folded(now, strip - 1))
      neighbours.emplace_back(StripEdge::left, folded_of(now, strip - 1));
    if (is_folded(now, strip + 1))
      neighbours.emplace_back(StripEdge::right, folded_of(now, strip + 1));
  }
  const bool symmetric = now.design->sheet.symmetric;
  const double sign = half_sign(now);
  const auto height = least_height(now, strip);
  return [neighbours = std::move(neighbours), symmetric, sign, height](const FoldedStrip& shape) {
    std::vector<HalfSpace> planes;
    const int quads = static_cast<int>(shape.quads.size());
    const double unseen = kHolds *
                          (shape.ridges.back().flat[0].x() - shape.ridges.front().flat[0].x());
    if (symmetric && depth_behind_mirror(shape, sign) > unseen)
      planes = planes_before_mirror(quads, sign);
    if (height && depth_below(shape, *height) > unseen) {
      const auto above = planes_above(quads, *height);
      planes.insert(planes.end(), above.begin(), above.end());
    }
    for (const auto& [side, neighbour] : neighbours)
      if (cross(shape, neighbour)) {
        const auto beside = planes_beside(shape, neighbour, side);
        planes.insert(planes.end(), beside.begin(), beside.end());
      }
    return planes;
  };
}

StripSolution work_on(Snapshot& now, int strip, Clear clear, const DescentOptions& options) {
  const StripProblem problem = problem_of(now, strip);
  StripSolution solution = solve_strip(problem, now.slot(strip).p, options,
                                       planes_broken(now, strip, clear));
  take(now, strip, problem, solution);
  return solution;
}

void take_shape(Snapshot& now, int strip, const StripParameters& p,
                std::vector<Inequality> inequalities, bool touches) {
  const StripProblem problem = problem_of(now, strip);
  const StripState& before = now.slot(strip).state;
  StripSolution solution{p, std::move(inequalities), objective(problem, p)};
  solution.iterations = before.iterations;
  solution.reached = before.status != StripStatus::out_of_reach;
  solution.converged = before.status == StripStatus::solved;
  take(now, strip, problem, solution);
  Slot slot = now.slot(strip);
  slot.touches = touches;
  now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

bool goes_on(Snapshot& now, int strip) {
  const Slot& slot = now.slot(strip);
  if (!slot.touches) return false;
  Found found = met_from_before(problem_of(now, strip), slot.p);
  if (!found.met()) return false;
  take_shape(now, strip, found.solution.p, slot.inequalities, true);
  Slot next = now.slot(strip);
  next.state.status = StripStatus::solved;
  next.state.too_tight = false;  // whether it must be shows when it is solved with those it touches
  now.slots[strip] = std::make_shared<const Slot>(std::move(next));
  return true;
}

int improve_from_neighbours(Snapshot& now, const std::vector<int>& strips,
                            const DescentOptions& options) {
  constexpr double kBetter = 1e-3;
  constexpr int kMostRounds = 8;
  int iterations = 0;
  std::vector<bool> changed(now.count(), true);
  for (int round = 0; round < kMostRounds; ++round) {
    const Snapshot before = now;
    std::vector<bool> changes(now.count());
    for (const int strip : strips)
      for (const int other : {strip - 1, strip + 1}) {
        if (!is_folded(before, other) || !changed[other] ||
            before.slot(other).p.size() != before.slot(strip).p.size())
          continue;
        if (options.stop && options.stop()) return iterations;
        Snapshot tried = before;
        take_start(tried, strip, before.slot(other).p);
        iterations += work_on(tried, strip, Clear::of_mirror, options).iterations;
        if (!is_better(tried.slot(strip), now.slot(strip), kBetter)) continue;
        now.slots[strip] = tried.slots[strip];
        changes[strip] = true;
      }
    if (std::ranges::find(changes, true) == changes.end()) break;
    changed = std::move(changes);
  }
  return iterations;
}

void note_crossings(Snapshot& now, const std::vector<int>& moved) {
  std::vector<bool> has_moved(now.count());
  for (const int strip : moved)
    has_moved[strip] = true;
  const double margin = now.design->objective == SlitObjective::energy
                            ? kPressed * now.design->sheet.thickness
                            : 0.0;
  std::vector<std::vector<int>> crosses;
  for (int strip = 0; strip < now.count(); ++strip) {
    crosses.push_back(now.slot(strip).state.crosses);
    std::erase_if(crosses.back(), [&](int other) { return has_moved[strip] || has_moved[other]; });
  }
  for (const int strip : moved)
    for (int other = 0; other < now.count(); ++other) {
      if (other == strip || (has_moved[other] && other < strip)) continue;
      if (!is_folded(now, other) || !now.slot(strip).box.intersects(now.slot(other).box)) continue;
      const auto [lower, higher] = std::minmax(strip, other);
      if (cross(folded_of(now, lower), folded_of(now, higher), margin))
        crosses[lower].push_back(higher);
    }
  for (int strip = 0; strip < now.count(); ++strip) {
    auto& found = crosses[strip];
    std::ranges::sort(found);
    if (found == now.slot(strip).state.crosses) continue;
    Slot slot = now.slot(strip);
    slot.state.crosses = std::move(found);
    now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
  }
}

int part_neighbours(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options) {
  const auto both = [](const Snapshot& snapshot, int strip) {
    return snapshot.slot(strip).state.objective + snapshot.slot(strip + 1).state.objective;
  };
  std::vector<int> pairs;
  for (int strip = 0; strip + 1 < now.count(); ++strip) {
    const auto& crosses = now.slot(strip).state.crosses;
    if (std::ranges::find(crosses, strip + 1) != crosses.end()) pairs.push_back(strip);
  }
  // By their properties, not their numbers, so that a mirrored sheet gives the mirrored result.
  std::ranges::stable_sort(pairs, [&](int a, int b) { return both(now, a) < both(now, b); });
  int iterations = 0;
  for (const int pair : pairs) {
    std::optional<Snapshot> best;
    for (const int strip : {pair, pair + 1}) {
      if (options.stop && options.stop()) return iterations;
      if (std::ranges::find(moved, strip) == moved.end()) continue;
      Snapshot tried = now;
      iterations += work_on(tried, strip, Clear::of_neighbours, options).iterations;
      if (cross(folded_of(tried, pair), folded_of(tried, pair + 1))) continue;
      if (!best || both(tried, pair) < both(*best, pair)) best = std::move(tried);
    }
    if (best) now = std::move(*best);
  }
  return iterations;
}

}  // namespace planish::slit_detail
