#include "sharp_fit.hpp"

#include "outline_run.hpp"
#include "pair_search.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// A fold of inside radius 0 along an edge that both plates have on the line where their planes
// meet. The longest stretch of free edges there is taken. The drawn edge is on the line of the mid-
// surfaces; inner skins meet before it, so the sheets are cut back, and the edge beside a corner
// must be long enough for that.

namespace planish::connect_detail {
namespace {

// Edges this near the line where the planes meet (mm) are drawn on it.
double near_line(const PlacedPlate& plate) {
  return std::max(kDrawn, tolerance::kFileDigits * plate.extent);
}

/// A stretch of the intersection line on which both plates have an edge.
struct Common {
  BendFrame frame;
  std::array<int, 2> edges{};
  double low = 0.0, high = 0.0;
  double length() const { return high - low; }
};

struct LineEdge {
  int edge = 0;
  double low = 0.0, high = 0.0;
};

/// Edges of chains at the height `near` of their frame, or as near to that.
std::vector<LineEdge> edges_on_line(const PairChoice& frame, std::size_t side, const FitTask& task,
                                    double near) {
  const auto& wanted = task.request.edges[side];
  std::vector<LineEdge> edges;
  for (const Chain& chain : frame.chains[side])
    for (std::size_t j = 0; j < chain.edges.size() && chain.kind == EdgeKind::facing; ++j) {
      if (wanted && std::ranges::count(*wanted, chain.edges[j]) == 0) continue;
      const Vec2 &a = chain.corners[j], &b = chain.corners[j + 1];
      if (std::max(a.y(), b.y()) <= 2.0 * near) edges.push_back({chain.edges[j], a.x(), b.x()});
    }
  return edges;
}

std::optional<Common> longest_common(const FitTask& task, const ConnectOptions& options) {
  const PlanePair planes = plane_pair(*task.plates[0], *task.plates[1], options.planarity);
  if (planes != PlanePair::crossing) return std::nullopt;
  const double least = kNegligible * std::max(task.plates[0]->extent, task.plates[1]->extent);
  const double near = std::max(near_line(*task.plates[0]), near_line(*task.plates[1]));
  std::optional<Common> best;
  for (const BendFrame& frame : bend_frames(*task.plates[0], *task.plates[1], planes)) {
    // Seen from a little below the line, since edges that cross it carry no bend.
    BendFrame below = frame;
    below.origin -= near / (1.0 + frame.e[0].dot(frame.e[1])) * (frame.e[0] + frame.e[1]);
    const auto chains = chains_in(task, below, EdgeKind::facing);
    if (!chains) continue;
    for (const LineEdge& a : edges_on_line(*chains, 0, task, near))
      for (const LineEdge& b : edges_on_line(*chains, 1, task, near)) {
        const Common part{
            frame, {a.edge, b.edge}, std::max(a.low, b.low), std::min(a.high, b.high)};
        if (part.length() > std::max(least, best ? best->length() : 0.0)) best = part;
      }
  }
  return best;
}

/// The edge beside a corner of the fold, from there.
Segment edge_beside(const PlacedPlate& plate, const BendFrame& frame, int side,
                    const EdgePlace& edge, bool at_low) {
  const auto at = [&](int further) { return frame.local(side, plate.corner(edge, further)); };
  const bool ascending = at(0).x() < at(1).x();
  const bool first = ascending == at_low;
  return {first ? at(0) : at(1), first ? at(-1) : at(2)};
}

/// Where it crosses the line at the height `reach`; empty if the plate ends below that.
std::optional<double> crossing_at(const Segment& beside, double reach, double near) {
  const auto& [corner, far] = beside;
  if (far.y() <= reach - near) return std::nullopt;
  return corner.x() + (reach - corner.y()) / (far.y() - corner.y()) * (far.x() - corner.x());
}

tl::unexpected<Error> no_room(const FitTask& task, double reach) {
  return fail(
      refuse::fold_without_room,
      about(task, {{"reach", reach, unit::mm}, {"field", place::pointer("/inside_radius")}}));
}

Result<Fold> fold_along(const FitTask& task, const Common& common) {
  Fold fold{.reach = tangent_distance(common.frame, 0.5 * task.thickness),
            .low = common.low,
            .high = common.high};
  for (int side = 0; side < 2; ++side) {
    const PlacedPlate& plate = *task.plates[side];
    const EdgePlace edge = plate.place_of(common.edges[side]);
    const double near = near_line(plate);
    const double first = common.frame.local(side, plate.corner(edge)).x();
    const double last = common.frame.local(side, plate.corner(edge, 1)).x();
    const double from = std::min(first, last), to = std::max(first, last);
    for (const bool low : {true, false}) {
      const Segment beside = edge_beside(plate, common.frame, side, edge, low);
      // A plate that goes on past the line beside the fold is cut as if inside an edge.
      const bool corner = std::abs(low ? from - common.low : to - common.high) <= near &&
                          beside.b.y() > near;
      fold.at_corner[side][low ? 0 : 1] = corner;
      if (!corner) continue;
      const auto cut = crossing_at(beside, fold.reach, near);
      if (!cut) return no_room(task, fold.reach);
      if (low)
        fold.low = std::max(fold.low, *cut);
      else
        fold.high = std::min(fold.high, *cut);
    }
  }
  if (fold.high - fold.low <= kNegligible * task.plates[0]->extent)
    return no_room(task, fold.reach);
  return fold;
}

}  // namespace

bool asks_for_fold(const BendRequest& request) {
  return request.inside_radius == 0.0 && request.between.size() == 2;
}

Result<BendFit> fit_fold(const FitTask& task, const ConnectOptions& options) {
  const auto common = longest_common(task, options);
  if (!common)
    return fail(
        in_request(task, error_of(refuse::fold_without_edges,
                                  about(task, {{"field", place::pointer("/inside_radius")}}))));
  auto fold = fold_along(task, *common);
  if (!fold) return fail(in_request(task, fold.error()));
  BendFit fit;
  fit.fold = *fold;
  fit.report.line = {0.0, -fold->reach};
  fit.surface = tangent_surface(common->frame, EdgeKind::facing, fit.report.line);
  FittedBend& report = fit.report;
  report.request = task.request;
  for (std::size_t side = 0; side < 2; ++side) {
    report.edges[side] = {common->edges[side]};
    // The rest of the edge can carry other bends.
    const int i = static_cast<int>(side);
    fit.runs[side] = outline_run(
        *task.plates[side], report.edges[side],
        {common->frame.point(i, {common->low, 0.0}), common->frame.point(i, {common->high, 0.0})});
  }
  report.kind = BendKind::sharp;
  report.frame = common->frame;
  report.angle = Angle::radians(std::numbers::pi - common->frame.beta.radians());
  report.width = common->length();
  return fit;
}

}  // namespace planish::connect_detail
