#include "alternatives.hpp"

#include "bend_frame.hpp"
#include "pair_search.hpp"
#include "surface_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// What else joins two plates: the set of bends of which none is both wider and shorter
// (math.md#efficient-bends), over all frames of the pair.

namespace planish::connect_detail {
namespace {

BendKind kind_of(const PairChoice& choice, const EdgeChoice& edges, const FitTask& task,
                 const ConnectOptions& options) {
  if (choice.frame.parallel()) return BendKind::cylinder;
  const auto corners = choice.corners(edges);
  const bool free = leaves_surface_free(task.request) && edges.kind == EdgeKind::facing;
  const auto right = smallest_extension(corners, edges.kind,
                                        given_line(task.request, choice.frame, task.thickness));
  const double area = right ? right->area : HUGE_VAL;
  if (free && less_extended(corners, area, options)) return BendKind::general;
  const double slope = right ? right->line.slope : edges.line.slope;
  return std::abs(slope) < options.smallest_slope ? BendKind::cylinder : BendKind::cone;
}

BendAlternative alternative(const PairChoice& choice, const EdgeChoice& edges, const FitTask& task,
                            const ConnectOptions& options) {
  BendAlternative result{task.request, kind_of(choice, edges, task, options), edges.kind,
                         edges.width, edges.span};
  if (choice.frame.parallel()) result.span += 0.5 * std::numbers::pi * choice.frame.rise.norm();
  auto numbers = choice.edges(edges);
  for (std::size_t side = 0; side < 2; ++side) {
    std::ranges::sort(numbers[side]);
    result.request.edges[side] = std::move(numbers[side]);
  }
  return result;
}

// Widest first; what another one surpasses is left out.
std::vector<BendAlternative> efficient(std::vector<BendAlternative> all) {
  std::ranges::stable_sort(all, [](const BendAlternative& a, const BendAlternative& b) {
    return a.width != b.width ? a.width > b.width : a.span < b.span;
  });
  std::vector<BendAlternative> kept;
  for (BendAlternative& each : all)
    if (kept.empty() || each.span < kept.back().span) kept.push_back(std::move(each));
  return kept;
}

}  // namespace

std::vector<BendAlternative> alternatives_to(const FittedBend& taken, const FitTask& task,
                                             const ConnectOptions& options) {
  std::vector<BendAlternative> all;
  if (options.alternatives <= 0) return all;
  const PlanePair planes = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  const auto kind = natural_kind(task, options);
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], planes)) {
    const auto choice = chains_in(task, frame, kind);
    if (!choice) continue;
    for (const EdgeChoice& edges : efficient_edges(
             choice->chains, frame.beta, search_options(task, frame), options.alternatives + 1))
      all.push_back(alternative(*choice, edges, task, options));
  }
  all = efficient(std::move(all));
  std::erase_if(all, [&](const BendAlternative& each) {
    return each.request.edges[0] == taken.edges[0] && each.request.edges[1] == taken.edges[1];
  });
  const auto most = static_cast<std::size_t>(options.alternatives);
  if (all.size() > most) {
    all[most - 1] = std::move(all.back());
    all.resize(most);
  }
  return all;
}

}  // namespace planish::connect_detail
