#include "pair_search.hpp"

#include "better_edges.hpp"
#include "corners.hpp"
#include "outline_run.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

// The edges and the frame of one bend: all frames of the two plates are searched, and the one with
// the shortest reference bend is taken (math.md#shortest-bend). What a request gives of the tangent
// line takes part if it does not depend on the edges chosen. An inside radius that the edges miss
// by a micrometre is reduced to what they allow, since files of real parts are rounded.

namespace planish::connect_detail {
namespace {

// Chains without some of their edges.
std::vector<Chain> without(const std::vector<Chain>& chains, const std::set<int>& taken) {
  std::vector<Chain> left;
  for (const Chain& chain : chains) {
    ChainParts part(chain.kind, left);
    for (std::size_t j = 0; j < chain.edges.size(); ++j)
      if (taken.contains(chain.edges[j]))
        part.end();
      else
        part.add(chain.corners[j], chain.corners[j + 1], chain.edges[j]);
    part.end();
  }
  return left;
}

// Edges too near the intersection line for the thickness cannot carry a bend with any tangent line.
std::set<int> too_near(const std::vector<Chain>& chains, double height) {
  std::set<int> edges;
  for (const Chain& chain : chains)
    for (std::size_t j = 0; j < chain.edges.size() && chain.kind == EdgeKind::facing; ++j)
      if (std::min(chain.corners[j].y(), chain.corners[j + 1].y()) < height)
        edges.insert(chain.edges[j]);
  return edges;
}

// Whether plates lie beside each other in projection, so that a half-turn would have to pass under
// one.
bool beside(const std::array<std::vector<Vec2>, 2>& outlines) {
  const Box2 a = box_of(outlines[0]), b = box_of(outlines[1]);
  return a.hi.y() <= b.lo.y() || b.hi.y() <= a.lo.y();
}

// Whether the best edges reach so near the intersection line that the bend there would be too
// sharp.
bool is_too_near(const FitTask& task, const PairChoice& choice) {
  if (choice.search.best.kind == EdgeKind::averted) return false;
  return lowest(choice.corners(choice.search.best)) < least_height(task, choice.frame);
}

std::set<int> cut_corners(const PlacedPlate& plate) {
  return {plate.cut_corners.begin(), plate.cut_corners.end()};
}

// Whether a side of the bend would hang on edges at corners that were cut off: some millimetres.
bool is_on_cut_corners(const FitTask& task, const PairChoice& choice) {
  const auto edges = choice.edges(choice.search.best);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::set<int> cut = cut_corners(*task.plates[i]);
    if (!task.request.edges[i] &&
        std::ranges::all_of(edges[i], [&](int edge) { return cut.contains(edge); }))
      return true;
  }
  return false;
}

// The best edges of the chains; where width counts for nothing, the shortest.
Result<PairChoice> best_within(PairChoice choice, const EdgeSearchOptions& wanted) {
  if (auto searched = search(choice, wanted); !searched) return pass_on(searched);
  if (wanted.trade_off > 0.0) return choice;
  auto efficient = efficient_edges(choice.chains, choice.frame.beta, wanted, 1);
  if (!efficient.empty()) choice.search.best = std::move(efficient.back());
  return choice;
}

Result<PairChoice> search_frame(const FitTask& task, const BendFrame& frame,
                                std::optional<EdgeKind> kind) {
  auto chains = chains_in(task, frame, kind);
  if (!chains) return chains;
  const EdgeSearchOptions wanted = search_options(task, frame);
  auto choice = best_within(std::move(*chains), wanted);
  if (!choice) return choice;
  if (wanted.trade_off > 0.0) choice = with_better_edges(std::move(*choice), wanted);
  if (is_on_cut_corners(task, *choice)) {
    PairChoice whole = *choice;
    for (std::size_t i = 0; i < 2; ++i)
      if (!task.request.edges[i])
        whole.chains[i] = without(whole.chains[i], cut_corners(*task.plates[i]));
    if (auto best = best_within(std::move(whole), wanted)) choice = std::move(best);
  }
  if (is_too_near(task, *choice)) {
    PairChoice farther = *choice;
    for (std::size_t i = 0; i < 2; ++i) {
      farther.chains[i] = of_kind(std::move(farther.chains[i]), EdgeKind::facing);
      if (!task.request.edges[i])
        farther.chains[i] = without(farther.chains[i],
                                    too_near(farther.chains[i], least_height(task, frame)));
    }
    if (auto best = best_within(std::move(farther), wanted)) choice = std::move(best);
  }
  return with_used_parts(std::move(*choice), task, wanted);
}

bool better(const PairChoice& a, const PairChoice& b) {
  return a.search.reference_length < b.search.reference_length;
}

}  // namespace

std::array<std::vector<Vec2>, 2> PairChoice::corners(const EdgeChoice& choice) const {
  std::array<std::vector<Vec2>, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    const Run& run = choice.runs[side];
    const auto& all = chains[side][run.chain].corners;
    result[side].assign(all.begin() + run.first, all.begin() + run.last + 2);
  }
  return result;
}

std::array<std::vector<int>, 2> PairChoice::edges(const EdgeChoice& choice) const {
  std::array<std::vector<int>, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    const Run& run = choice.runs[side];
    const auto& all = chains[side][run.chain].edges;
    result[side].assign(all.begin() + run.first, all.begin() + run.last + 1);
  }
  return result;
}

std::vector<Chain> open_chains(const FitTask& task, const BendFrame& frame, int side) {
  const PlacedPlate& plate = *task.plates[side];
  return free_chains(without(side_chains(plate, frame, side), task.taken[side].whole),
                     task.taken[side].parts, plate, frame, side, task.thickness);
}

bool is_conical(const BendRequest& request) {
  return request.surface == SurfaceChoice::cone || request.slope.value_or(0.0) != 0.0;
}

double least_height(const FitTask& task, const BendFrame& frame) {
  return tangent_distance(frame, kSmallestInsideRadius + 0.5 * task.thickness);
}

double tangent_distance(const BendFrame& frame, double mid_radius) {
  return mid_radius / std::tan(0.5 * frame.beta.radians());
}

GivenLine given_line(const BendRequest& request, const BendFrame& frame, double thickness) {
  GivenLine line;
  if (frame.parallel()) {
    line.slope = 0.0;
    return line;
  }
  // Each side of a general cone has a slope of its own.
  if (request.surface == SurfaceChoice::general) return line;
  line.slope = request.slope;
  line.apex = request.apex;
  const bool rolled = request.inside_radius && !is_conical(request);
  if (request.surface == SurfaceChoice::cylinder || rolled) line.slope = 0.0;
  if (rolled) line.offset = -tangent_distance(frame, *request.inside_radius + 0.5 * thickness);
  return line;
}

FitTask at_limit_of_edges(FitTask task, const ConnectOptions& options) {
  constexpr double kAtLimit = 1e-3;  // mm, of the radius
  auto& radius = task.request.inside_radius;
  if (!radius || is_conical(task.request)) return task;
  const PlanePair kind = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], kind)) {
    if (frame.parallel()) continue;
    const double per_radius = tangent_distance(frame, 1.0);
    const double wanted = tangent_distance(frame, *radius + 0.5 * task.thickness);
    double nearest = wanted;
    for (int side = 0; side < 2; ++side)
      for (const Chain& chain : side_chains(*task.plates[side], frame, side))
        for (std::size_t j = 0; j < chain.edges.size(); ++j) {
          const double y = std::min(chain.corners[j].y(), chain.corners[j + 1].y());
          if (chain.kind == EdgeKind::facing && y >= wanted - kAtLimit * per_radius)
            nearest = std::min(nearest, y);
        }
    const double allowed = nearest / per_radius - 0.5 * task.thickness;
    if (nearest < wanted && allowed >= kSmallestInsideRadius) radius = allowed;
  }
  return task;
}

Result<PairChoice> chains_in(const FitTask& task, const BendFrame& frame,
                             std::optional<EdgeKind> kind) {
  PairChoice choice{frame, {}, {}};
  std::array<std::vector<Vec2>, 2> outlines;
  for (int side = 0; side < 2; ++side) {
    outlines[side] = side_outline(*task.plates[side], frame, side);
    std::vector<Chain>& chains = choice.chains[side] = open_chains(task, frame, side);
    if (kind) chains = of_kind(std::move(chains), *kind);
    if (frame.parallel()) chains = of_kind(std::move(chains), EdgeKind::averted);
  }
  if (frame.parallel() && beside(outlines))
    return fail(refuse::beside_each_other,
                about(task, {{"distance", frame.rise.norm(), unit::mm}}));
  return choice;
}

EdgeSearchOptions search_options(const FitTask& task, const BendFrame& frame) {
  return {.trade_off = task.request.trade_off,
          .line = given_line(task.request, frame, task.thickness),
          .edges = task.request.edges,
          .alternatives = 0};
}

// It must not move the bend to the back of the plates: the kind is that without it.
std::optional<EdgeKind> natural_kind(const FitTask& task, const ConnectOptions& options) {
  const BendRequest& asked = task.request;
  if (!asked.slope && !asked.apex && !asked.aperture && !asked.inside_radii) return std::nullopt;
  FitTask free = task;
  free.request.aperture.reset();
  free.request.inside_radii.reset();
  free.request.slope.reset();
  free.request.apex.reset();
  const auto choice = search_pair(free, options);
  if (!choice) return std::nullopt;
  return choice->search.best.kind;
}

Result<PairChoice> search_pair(const FitTask& task, const ConnectOptions& options) {
  const PlanePair kind = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  if (kind == PlanePair::coplanar) return fail(refuse::in_one_plane, about(task, {}));
  const std::optional<EdgeKind> natural = natural_kind(task, options);
  std::optional<PairChoice> best;
  Error why = error_of(refuse::no_edges_facing, about(task, {}));
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], kind)) {
    auto choice = search_frame(task, frame, natural);
    if (!choice) {
      why = choice.error();
    } else if (!best || better(*choice, *best)) {
      best = std::move(*choice);
    }
  }
  if (!best) return tl::unexpected(why);
  return std::move(*best);
}

double common_width(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::min(a.back().x(), b.back().x()) - std::max(a.front().x(), b.front().x());
}

Nearness nearness_of(const PairChoice& choice) {
  const EdgeChoice& best = choice.search.best;
  const double turn = choice.frame.parallel() ? 0.5 * std::numbers::pi * choice.frame.rise.norm()
                                              : 0.0;
  const auto corners = choice.corners(best);
  const double left_a = corners[0].front().x(), left_b = corners[1].front().x();
  const double right_a = corners[0].back().x(), right_b = corners[1].back().x();
  const double common = common_width(corners[0], corners[1]);
  if (common <= 0.0) return {best.span + turn, best.width};
  const double shift = std::abs(left_a - left_b) + std::abs(right_a - right_b);
  return {best.span - shift + turn, common};
}

}  // namespace planish::connect_detail
