#include "strip_work.hpp"

#include "crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planish::slit_detail {
namespace {

/// Ends that point the wrong way meet their condition as well as those that point the right way.
bool ends_backwards(const StripEnd& end, const FoldedStrip& strip) {
  const Frame& last = strip.quads.back();
  return (end.direction && end.direction->dot(last.x) < 0.0) || (end.across && end.across->dot(last.y) < 0.0);
}

/// What is reported of a strip, measured on its shape.
StripState measured(const Snapshot& now, int strip, const StripProblem& problem, const StripSolution& solution) {
  const FoldedStrip shape = folded_strip(problem.base, solution.p);
  const StripFold fold = folded(problem.base, solution.p);
  StripState state;
  state.gap = end_gap(problem, fold);
  const bool backwards = !now.design->sheet.symmetric && ends_backwards(now.design->ends[static_cast<std::size_t>(strip)], shape);
  state.status = !solution.reached || backwards ? StripStatus::out_of_reach : solution.converged ? StripStatus::solved : StripStatus::open;
  if (!solution.reached) state.shortfall = state.gap;
  const Tightest tightest = tightest_fold(problem.base, solution.p);
  state.min_radius = tightest.radius;
  state.tightest_ridge = tightest.ridge;
  constexpr double kRounding = 1e-6;
  state.too_tight = tightest.radius < problem.min_radius * (1.0 - kRounding);
  if (now.design->sheet.symmetric) state.crosses_plane = depth_behind_mirror(shape, half_sign(now)) > kRounding * problem.base.unit();
  state.objective = solution.objective;
  if (problem.seat)
    for (const Vec3& end : shape.ridges.back().folded)
      state.seat_distance = std::max(state.seat_distance, (problem.seat->nearest(end.tail<2>()).point - end.tail<2>()).norm());
  for (const StripAnchor& anchor : problem.anchors)
    state.anchor_distance = std::max(state.anchor_distance, (fold.end(anchor.side, anchor.ridge) - anchor.at).norm());
  if (problem.scan) {
    double sum = 0.0;
    for (int ridge = 1; ridge <= problem.base.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        sum += (problem.scan->nearest(fold.end(side, ridge)) - fold.end(side, ridge)).squaredNorm();
    state.scan_distance = std::sqrt(sum / (2.0 * problem.base.quads));
  }
  state.iterations = solution.iterations;
  return state;
}

bool stands(const Snapshot& now, int strip) {
  return strip >= 0 && strip < now.count() && now.slot(strip).p.size() && now.slot(strip).state.status != StripStatus::open;
}

/// What the strip must keep clear of: its mirror image, and neighbours that stand.
PlanesBroken clear_of(const Snapshot& now, int strip) {
  std::vector<std::pair<Side, FoldedStrip>> neighbours;
  if (stands(now, strip - 1)) neighbours.emplace_back(Side::left, folded_of(now, strip - 1));
  if (stands(now, strip + 1)) neighbours.emplace_back(Side::right, folded_of(now, strip + 1));
  const bool symmetric = now.design->sheet.symmetric;
  const double sign = half_sign(now);
  return [neighbours = std::move(neighbours), symmetric, sign](const FoldedStrip& shape) {
    std::vector<HalfSpace> planes;
    constexpr double kThrough = 1e-7;
    if (symmetric && depth_behind_mirror(shape, sign) > kThrough * (shape.ridges.back().flat[0].x() - shape.ridges.front().flat[0].x()))
      planes = planes_before_mirror(static_cast<int>(shape.quads.size()), sign);
    for (const auto& [side, neighbour] : neighbours)
      if (cross(shape, neighbour)) {
        const auto beside = planes_beside(shape, neighbour, side);
        planes.insert(planes.end(), beside.begin(), beside.end());
      }
    return planes;
  };
}

}  // namespace

StripSolution work_on(Snapshot& now, int strip, const DescentOptions& options) {
  const StripProblem problem = problem_of(now, strip);
  StripSolution solution = solve_strip(problem, now.slot(strip).p, options, clear_of(now, strip));
  Slot slot = now.slot(strip);
  slot.p = solution.p;
  slot.state = measured(now, strip, problem, solution);
  slot.inequalities = solution.inequalities;
  std::erase_if(slot.inequalities, [](const Inequality& known) { return std::holds_alternative<HalfSpace>(known.what); });
  now.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
  return solution;
}

void note_crossing(Snapshot& now, int strip) {
  if (strip < 0 || strip + 1 >= now.count()) return;
  const bool crosses = cross(folded_of(now, strip), folded_of(now, strip + 1));
  if (crosses == now.slot(strip).state.crosses_next) return;
  Slot slot = now.slot(strip);
  slot.state.crosses_next = crosses;
  now.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
}

}  // namespace planish::slit_detail
