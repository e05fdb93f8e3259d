#include "bend_stretches.hpp"

#include "outline_run.hpp"
#include "pair_search.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

// Further stretches of an interrupted bend: free edges of both plates that lie on the tangent lines
// already found and opposite each other. A stretch is kept only where neither plate has material
// beyond its ruling; two of them become one where an edge of one plate goes on unbroken between
// them, past a recess of the other. No new line is sought, so stretches are coaxial by
// construction.

namespace planish::connect_detail {
namespace {

/// Edges of one chain as far from the tangent ruling of a side as the bend's own, between two
/// values of v.
struct OnRuling {
  std::vector<int> edges;
  std::pair<Vec3, Vec3> ends;
  double low = 0.0, high = 0.0;
};

// An edge that the ruling cuts by more than this share of the plates' extent is not on it.
constexpr double kCut = tolerance::kComputed;

/// How far the edges of the bend are from its ruling, if they are parallel to it; else 0.
double distance_of_run(const BendFit& fit, const PlacedPlate& plate, int side) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec2& p : run_points(plate, fit.runs[side])) {
    const double y = fit.surface.local(side, plate.frame.point(p)).y();
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return high - low <= kDrawn && low > 0.0 ? 0.5 * (low + high) : 0.0;
}

std::vector<OnRuling> edges_on_ruling(const BendFit& fit, const FitTask& task, int side,
                                      double extent) {
  const BendFrame& frame = fit.report.frame;
  const double distance = distance_of_run(fit, *task.plates[side], side);
  const double least = distance > kDrawn ? distance - kDrawn : -kCut * extent;
  std::vector<OnRuling> found;
  for (const Chain& chain : open_chains(task, frame, side)) {
    if (chain.kind != fit.report.edge_kind) continue;
    bool going_on = false;
    for (std::size_t j = 0; j < chain.edges.size(); ++j) {
      const std::pair ends{frame.point(side, chain.corners[j]),
                           frame.point(side, chain.corners[j + 1])};
      const Vec2 a = fit.surface.local(side, ends.first), b = fit.surface.local(side, ends.second);
      const auto [low, high] = std::minmax({a.y(), b.y()});
      const bool on_ruling = low >= least && high <= distance + kDrawn;
      if (on_ruling && !going_on)
        found.push_back({{}, ends, std::min(a.x(), b.x()), std::max(a.x(), b.x())});
      going_on = on_ruling;
      if (!on_ruling) continue;
      OnRuling& part = found.back();
      part.edges.push_back(chain.edges[j]);
      part.ends.second = ends.second;
      part.low = std::min({part.low, a.x(), b.x()});
      part.high = std::max({part.high, a.x(), b.x()});
    }
  }
  return found;
}

bool apart(const Boundaries& band, double low, double high) {
  for (std::size_t side = 0; side < 2; ++side)
    if (low <= band.high.v[side] + kDrawn && high >= band.low.v[side] - kDrawn) return false;
  return true;
}

/// The rings of both plates, by side, as the bend sees them.
using BothRings = std::array<std::vector<std::vector<Vec2>>, 2>;

BothRings both_rings(const BendFit& fit, const FitTask& task) {
  return {local_rings(*task.plates[0], fit.surface, 0),
          local_rings(*task.plates[1], fit.surface, 1)};
}

// Whether neither plate has material beyond its ruling there.
bool is_free(const BothRings& plates, double low, double high) {
  for (const auto& rings : plates) {
    const auto legal = legal_sections(rings, low, high, kDrawn);
    if (legal.size() != 1 || legal[0].second - legal[0].first < high - low - kDrawn) return false;
  }
  return true;
}

double larger_extent(const FitTask& task) {
  return std::max(task.plates[0]->extent, task.plates[1]->extent);
}

}  // namespace

std::array<double, 2> unused_edges(const BendFit& fit, const FitTask& task) {
  std::array<double, 2> unused{};
  if (fit.report.plates.size() != 2) return unused;
  for (int side = 0; side < 2; ++side)
    for (const OnRuling& part : edges_on_ruling(fit, task, side, larger_extent(task)))
      unused[side] += part.high - part.low;
  return unused;
}

std::vector<BendBand> further_stretches(const BendFit& fit, const FitTask& task) {
  if (fit.report.plates.size() != 2 || fit.surface.kind == BendKind::general) return {};
  if (task.request.edges[0] || task.request.edges[1]) return {};
  const double extent = larger_extent(task);
  const BothRings rings = both_rings(fit, task);
  std::vector<BendBand> stretches;
  const auto second = edges_on_ruling(fit, task, 1, extent);
  for (const OnRuling& a : edges_on_ruling(fit, task, 0, extent))
    for (const OnRuling& b : second) {
      const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
      if (high - low < task.thickness || !apart(fit.boundaries, low, high)) continue;
      if (std::ranges::any_of(stretches, [&](const BendBand& other) {
            return !apart(other.boundaries, low, high);
          }))
        continue;
      if (!is_free(rings, low, high)) continue;
      BendBand band{{LateralBoundary::arc, along_directrix(fit.surface, low, extent),
                     along_directrix(fit.surface, high, extent)},
                    {},
                    {}};
      for (int side = 0; side < 2; ++side) {
        const PlacedPlate& plate = *task.plates[side];
        const OnRuling& part = side == 0 ? a : b;
        band.runs[side] = trimmed(outline_run(plate, part.edges, part.ends), plate, fit.surface,
                                  band.boundaries, side, task.thickness);
      }
      stretches.push_back(std::move(band));
    }
  return stretches;
}

namespace {

// Whether one edge carries both runs.
bool on_one_edge(const OutlineRun& a, const OutlineRun& b) {
  return a.count == 1 && b.count == 1 && a.ring == b.ring && a.first == b.first;
}

/// `band` with `next`, which follows it; empty if no edge goes on from one to the other.
std::optional<BendBand> merged(const BendBand& band, const BendBand& next, const BothRings& rings) {
  const double low = band.boundaries.high.v[0], high = next.boundaries.low.v[0];
  for (std::size_t side = 0; side < 2; ++side) {
    const OutlineRun &a = band.runs[side], &b = next.runs[side];
    if (!on_one_edge(a, b) || !is_free(rings, low, high)) continue;
    BendBand both = band;
    both.boundaries.high = next.boundaries.high;
    both.runs[side].start = std::min(a.start, b.start);
    both.runs[side].end = std::max(a.end, b.end);
    std::vector<OutlineRun>& more = both.more[1 - side];
    more.push_back(next.runs[1 - side]);
    more.insert(more.end(), next.more[1 - side].begin(), next.more[1 - side].end());
    return both;
  }
  return std::nullopt;
}

}  // namespace

std::vector<BendBand> merged_stretches(std::vector<BendBand> bands, const BendFit& fit,
                                       const FitTask& task) {
  std::ranges::sort(bands, {}, [](const BendBand& band) { return band.boundaries.low.v[0]; });
  if (bands.size() < 2) return bands;
  const BothRings rings = both_rings(fit, task);
  std::vector<BendBand> all;
  for (BendBand& band : bands) {
    auto both = all.empty() ? std::nullopt : merged(all.back(), band, rings);
    if (both)
      all.back() = std::move(*both);
    else
      all.push_back(std::move(band));
  }
  return all;
}

}  // namespace planish::connect_detail
