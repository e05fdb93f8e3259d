#include "pair_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::connect_detail {
namespace {

// Chains without the edges that other bends use already.
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

// Between parallel planes only edges that look outward carry a half-turn.
std::vector<Chain> averted_only(std::vector<Chain> chains) {
  std::erase_if(chains, [](const Chain& chain) { return chain.kind == EdgeKind::facing; });
  return chains;
}

// Plates that lie beside each other in their projection: a half-turn would have to pass under one.
bool beside(const std::array<std::vector<Vec2>, 2>& outlines) {
  std::array<std::pair<double, double>, 2> range;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto [lo, hi] = std::minmax_element(outlines[side].begin(), outlines[side].end(),
                                              [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    range[side] = {lo->y(), hi->y()};
  }
  return range[0].second <= range[1].first || range[1].second <= range[0].first;
}

Result<PairChoice> search_frame(const FitTask& task, const BendFrame& frame, const ConnectOptions& options) {
  PairChoice choice{frame, {}, {}};
  std::array<std::vector<Vec2>, 2> outlines;
  for (int side = 0; side < 2; ++side) {
    const auto i = static_cast<std::size_t>(side);
    outlines[i] = side_outline(*task.plates[i], frame, side);
    choice.chains[i] = without(viable_chains(outlines[i]), task.taken[i]);
    if (frame.parallel()) choice.chains[i] = averted_only(std::move(choice.chains[i]));
  }
  if (frame.parallel() && beside(outlines))
    return fail(ErrorCode::plates_offset,
                fmt::format("the plates lie in parallel planes {:.4g} mm apart and beside each other; a "
                            "half-turn joins plates that lie over each other: put a third plate between them",
                            frame.rise.norm()));
  EdgeSearchOptions wanted;
  wanted.trade_off = task.request.trade_off;
  wanted.line = given_line(task.request, frame, task.thickness);
  wanted.edges = task.request.edges;
  wanted.alternatives = options.alternatives;
  auto found = search_edges(choice.chains, frame.beta, wanted);
  if (!found) return tl::unexpected(found.error());
  choice.search = std::move(*found);
  return choice;
}

bool better(const PairChoice& a, const PairChoice& b) {
  return a.search.reference_length < b.search.reference_length;
}

}  // namespace

std::array<std::vector<Vec2>, 2> PairChoice::corners(const EdgeChoice& choice) const {
  std::array<std::vector<Vec2>, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    const Run& run = choice.runs[side];
    const auto& all = chains[side][static_cast<std::size_t>(run.chain)].corners;
    result[side].assign(all.begin() + run.first, all.begin() + run.last + 2);
  }
  return result;
}

std::array<std::vector<int>, 2> PairChoice::edges(const EdgeChoice& choice) const {
  std::array<std::vector<int>, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    const Run& run = choice.runs[side];
    const auto& all = chains[side][static_cast<std::size_t>(run.chain)].edges;
    result[side].assign(all.begin() + run.first, all.begin() + run.last + 1);
  }
  return result;
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
  line.slope = request.slope;
  line.apex = request.apex;
  const bool rolled = request.inside_radius && request.surface != SurfaceChoice::cone;
  if (request.surface == SurfaceChoice::cylinder || rolled) line.slope = 0.0;
  if (rolled) line.offset = -tangent_distance(frame, *request.inside_radius + 0.5 * thickness);
  return line;
}

Result<PairChoice> search_pair(const FitTask& task, const ConnectOptions& options) {
  const PlanePair kind = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  if (kind == PlanePair::coplanar)
    return fail(ErrorCode::plates_coplanar,
                "the plates lie in one plane, there is nothing to bend between them: make them one plate");
  std::optional<PairChoice> best;
  Error why{ErrorCode::no_bend_fits, "no edges of the two plates look towards each other", {}};
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], kind)) {
    auto choice = search_frame(task, frame, options);
    if (!choice) {
      why = choice.error();
    } else if (!best || better(*choice, *best)) {
      best = std::move(*choice);
    }
  }
  if (!best) return tl::unexpected(why);
  return std::move(*best);
}

}  // namespace planish::connect_detail
