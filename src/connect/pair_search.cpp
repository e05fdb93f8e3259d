#include "pair_search.hpp"

#include "drawn_edges.hpp"
#include "outline_run.hpp"
#include "tolerances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::connect_detail {
namespace {

// Chains without some of their edges.
std::vector<Chain> without(const std::vector<Chain>& chains, const std::set<int>& taken) {
  std::vector<Chain> left;
  for (const Chain& chain : chains) {
    Chain part{chain.kind, {}, {}};
    for (std::size_t j = 0; j < chain.edges.size(); ++j) {
      if (taken.count(chain.edges[j]) == 0) {
        if (part.corners.empty()) part.corners.push_back(chain.corners[j]);
        part.corners.push_back(chain.corners[j + 1]);
        part.edges.push_back(chain.edges[j]);
      } else if (!part.edges.empty()) {
        left.push_back(std::move(part));
        part = Chain{chain.kind, {}, {}};
      }
    }
    if (!part.edges.empty()) left.push_back(std::move(part));
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

std::vector<Chain> of_kind(std::vector<Chain> chains, EdgeKind kind) {
  std::erase_if(chains, [&](const Chain& chain) { return chain.kind != kind; });
  return chains;
}

// Whether plates lie beside each other in projection, so that a half-turn would have to pass under
// one.
bool beside(const std::array<std::vector<Vec2>, 2>& outlines) {
  std::array<std::pair<double, double>, 2> range;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto [lo, hi] = std::minmax_element(
        outlines[side].begin(), outlines[side].end(),
        [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    range[side] = {lo->y(), hi->y()};
  }
  return range[0].second <= range[1].first || range[1].second <= range[0].first;
}

Result<void> search(PairChoice& choice, const EdgeSearchOptions& wanted) {
  auto found = search_edges(choice.chains, choice.frame.beta, wanted);
  if (!found) return tl::unexpected(found.error());
  choice.search = std::move(*found);
  return {};
}

// Round the back only where that is shorter for its width than what is in front: of a toothed edge
// the search sees one tooth at a time, all of which a bend then joins.
PairChoice as_facing(PairChoice choice, const EdgeSearchOptions& wanted) {
  if (choice.search.best.kind == EdgeKind::facing || choice.frame.parallel()) return choice;
  PairChoice front{choice.frame, {}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    front.chains[i] = of_kind(choice.chains[i], EdgeKind::facing);
  if (!search(front, wanted)) return choice;
  const Nearness back = nearness_of(choice), near = nearness_of(front);
  return near.span * back.width < back.span * near.width ? front : choice;
}

// How much of the line both chains pass; negative if they lie beside each other.
double common_width(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::min(a.back().x(), b.back().x()) - std::max(a.front().x(), b.front().x());
}

// The chains that pass a part of the line together with one of the other side.
std::array<std::vector<Chain>, 2> opposite(const std::array<std::vector<Chain>, 2>& chains) {
  std::array<std::vector<Chain>, 2> result;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : chains[i])
      if (std::ranges::any_of(chains[1 - i], [&](const Chain& other) {
            return chain.kind == other.kind && common_width(chain.corners, other.corners) > 0.0;
          }))
        result[i].push_back(chain);
  return result;
}

// The best choice of edges opposite each other, where the best of all lie beside each other: the
// ends of a long edge are far from those of a short wall, and those of a stub beside it near.
PairChoice as_opposite(PairChoice choice, const EdgeSearchOptions& wanted) {
  const auto corners = choice.corners(choice.search.best);
  if (wanted.edges[0] || wanted.edges[1] || common_width(corners[0], corners[1]) > 0.0)
    return choice;
  PairChoice facing{choice.frame, opposite(choice.chains), {}};
  return search(facing, wanted) ? facing : choice;
}

// Whether points lie on a tangent line.
bool is_on(const TangentLine& line, const std::vector<Vec2>& corners) {
  return std::ranges::all_of(
      corners, [&](const Vec2& p) { return std::abs(p.y() - line.at(p.x())) <= kDrawn; });
}

// On how much of a tangent line both sides have an edge.
double drawn_width(const PairChoice& choice, const TangentLine& line) {
  std::array<std::vector<std::pair<double, double>>, 2> drawn;
  for (std::size_t i = 0; i < 2; ++i)
    for (const Chain& chain : choice.chains[i])
      for (std::size_t j = 0; j < chain.edges.size(); ++j)
        if (is_on(line, {chain.corners[j], chain.corners[j + 1]}))
          drawn[i].emplace_back(chain.corners[j].x(), chain.corners[j + 1].x());
  double width = 0.0;
  for (const auto& [low, high] : drawn[0])
    for (const auto& [from, to] : drawn[1])
      width += std::max(0.0, std::min(high, to) - std::max(low, from));
  return width;
}

// The teeth of an edge that are drawn up to the bend, where the best choice is a wider recess
// between them: together they are wider.
PairChoice as_teeth(PairChoice choice, EdgeSearchOptions wanted) {
  const auto corners = choice.corners(choice.search.best);
  const TangentLine& line = choice.search.best.line;
  if (wanted.edges[0] || wanted.edges[1] || (is_on(line, corners[0]) && is_on(line, corners[1])))
    return choice;
  PairChoice shortest = choice;
  wanted.trade_off = 0.0;
  if (!search(shortest, wanted)) return choice;
  const double width = drawn_width(shortest, shortest.search.best.line);
  return width > common_width(corners[0], corners[1]) ? shortest : choice;
}

// Whether the edge of a run of one is parallel to the intersection line.
bool is_level(const std::vector<Vec2>& corners) {
  return corners.size() == 2 && std::abs(corners[0].y() - corners[1].y()) <= kDrawn;
}

// A straight edge that goes on far past the other plate's, parallel to it, and has to be extended
// to the bend, is used as far as they lie opposite each other: the rest of it stays where it is,
// for other bends.
PairChoice as_part(PairChoice choice, const FitTask& task, EdgeSearchOptions wanted) {
  const EdgeChoice& best = choice.search.best;
  const auto corners = choice.corners(best);
  if (!is_level(corners[0]) || !is_level(corners[1])) return choice;
  const double low = std::max(corners[0].front().x(), corners[1].front().x());
  const double high = std::min(corners[0].back().x(), corners[1].back().x());
  if (high - low <= task.thickness) return choice;
  PairChoice part{choice.frame, {}, {}};
  bool shorter = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 &a = corners[i].front(), &b = corners[i].back();
    const bool drawn = std::abs(a.y() - best.line.at(a.x())) <= kDrawn;
    const bool far = std::max(low - a.x(), b.x() - high) > high - low;
    const double least = drawn || !(far || task.shares_edges) ? HUGE_VAL : task.thickness;
    const double from = low - a.x() > least ? low : a.x();
    const double to = b.x() - high > least ? high : b.x();
    shorter |= from > a.x() || to < b.x();
    part.chains[i] = {{best.kind, {{from, a.y()}, {to, b.y()}}, choice.edges(best)[i]}};
  }
  wanted.alternatives = 0;
  if (!shorter || !search(part, wanted)) return choice;
  choice.search.best = part.search.best;
  for (std::size_t i = 0; i < 2; ++i) {
    choice.search.best.runs[i].chain = static_cast<int>(choice.chains[i].size());
    choice.chains[i].push_back(part.chains[i].front());
  }
  return choice;
}

// Whether the best edges reach so near the intersection line that the bend there would be too
// sharp.
bool is_too_near(const FitTask& task, const PairChoice& choice) {
  if (choice.search.best.kind == EdgeKind::averted) return false;
  const double height = least_height(task, choice.frame);
  for (const auto& side : choice.corners(choice.search.best))
    for (const Vec2& p : side)
      if (p.y() < height) return true;
  return false;
}

// The choice with the edges that are drawn up to the bend, if it has such.
PairChoice as_drawn(PairChoice choice, const FitTask& task, EdgeSearchOptions wanted) {
  if (task.request.edges[0] || task.request.edges[1]) return choice;
  const auto edges = drawn_edges(choice);
  if (!edges) return choice;
  wanted.edges = {(*edges)[0], (*edges)[1]};
  wanted.alternatives = 0;
  const auto found = search_edges(choice.chains, choice.frame.beta, wanted);
  if (found) choice.search.best = found->best;
  return choice;
}

Result<PairChoice> search_frame(const FitTask& task, const BendFrame& frame,
                                const ConnectOptions& options, std::optional<EdgeKind> kind) {
  auto chains = chains_in(task, frame, kind);
  if (!chains) return chains;
  PairChoice choice = std::move(*chains);
  const EdgeSearchOptions wanted = search_options(task, frame, options.alternatives);
  if (auto searched = search(choice, wanted); !searched) return tl::unexpected(searched.error());
  choice = as_opposite(as_facing(std::move(choice), wanted), wanted);
  choice = as_teeth(std::move(choice), wanted);
  if (is_too_near(task, choice)) {
    PairChoice farther = choice;
    for (std::size_t i = 0; i < 2; ++i) {
      farther.chains[i] = of_kind(std::move(farther.chains[i]), EdgeKind::facing);
      if (!task.request.edges[i])
        farther.chains[i] = without(farther.chains[i],
                                    too_near(farther.chains[i], least_height(task, frame)));
    }
    if (search(farther, wanted)) choice = std::move(farther);
  }
  return as_part(as_drawn(std::move(choice), task, wanted), task, wanted);
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
  return free_chains(without(side_chains(plate, frame, side), task.taken[side]),
                     task.taken_parts[side], plate, frame, side, task.thickness);
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
    const auto i = static_cast<std::size_t>(side);
    outlines[i] = side_outline(*task.plates[i], frame, side);
    choice.chains[i] = open_chains(task, frame, side);
    if (kind) choice.chains[i] = of_kind(std::move(choice.chains[i]), *kind);
    if (frame.parallel())
      choice.chains[i] = of_kind(std::move(choice.chains[i]), EdgeKind::averted);
  }
  if (frame.parallel() && beside(outlines))
    return fail(
        ErrorCode::plates_offset,
        fmt::format(
            "the plates lie in parallel planes {:.4g} mm apart and beside each other; a "
            "half-turn joins plates that lie over each other: put a third plate between them",
            frame.rise.norm()));
  return choice;
}

EdgeSearchOptions search_options(const FitTask& task, const BendFrame& frame, int alternatives) {
  EdgeSearchOptions wanted;
  wanted.trade_off = task.request.trade_off;
  wanted.line = given_line(task.request, frame, task.thickness);
  wanted.edges = task.request.edges;
  wanted.alternatives = alternatives;
  return wanted;
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
  if (kind == PlanePair::coplanar)
    return fail(ErrorCode::plates_coplanar,
                "the plates lie in one plane, so there is nothing to bend between them: make them "
                "one plate");
  const std::optional<EdgeKind> natural = natural_kind(task, options);
  std::optional<PairChoice> best;
  Error why{ErrorCode::no_bend_fits, "no edges of the two plates look towards each other", {}};
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], kind)) {
    auto choice = search_frame(task, frame, options, natural);
    if (!choice) {
      why = choice.error();
    } else if (!best || better(*choice, *best)) {
      best = std::move(*choice);
    }
  }
  if (!best) return tl::unexpected(why);
  return std::move(*best);
}

Nearness nearness_of(const PairChoice& choice) {
  const EdgeChoice& best = choice.search.best;
  const double turn = choice.frame.parallel() ? 0.5 * std::numbers::pi * choice.frame.rise.norm()
                                              : 0.0;
  const auto corners = choice.corners(best);
  const double left_a = corners[0].front().x(), left_b = corners[1].front().x();
  const double right_a = corners[0].back().x(), right_b = corners[1].back().x();
  const double common = std::min(right_a, right_b) - std::max(left_a, left_b);
  if (common <= 0.0) return {best.span + turn, best.width};
  const double shift = std::abs(left_a - left_b) + std::abs(right_a - right_b);
  return {best.span - shift + turn, common};
}

}  // namespace planish::connect_detail
