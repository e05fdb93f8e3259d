#include "interrupted_bends.hpp"

#include "bend_stretches.hpp"
#include "joined_face.hpp"
#include "plate_outline.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <utility>

// Stretches are added once every bend has its edges, so that none takes an edge that another bend
// needs. If the outlines do not hold with all of them, bends are widened one after another, and one
// that breaks an outline keeps its own band alone. Afterwards further stretches and joints are fits
// of their own, in rows behind all others, so that the rows of the bends stay as they were.

namespace planish::connect_detail {
namespace {

std::vector<int> edges_of(const PlacedPlate& plate, const OutlineRun& run) {
  std::vector<int> edges;
  const int n = static_cast<int>(plate.ring(run.ring).size());
  for (int j = 0; j < run.count; ++j)
    edges.push_back(plate.edge_number({run.ring, (run.first + j) % n}));
  std::ranges::sort(edges);
  return edges;
}

/// Makes the further joints of a fit's band fits of their own; `bend` is the row of the bend.
void append_joints(Parts& parts, int row, int bend) {
  const auto more = std::exchange(parts.fits[row].more, {});
  for (int side = 0; side < 2; ++side)
    for (const OutlineRun& run : more[side]) {
      BendFit fit = parts.fits[row];
      fit.stretches.clear();
      fit.stretch_of.reset();
      fit.joint_of = {row, side};
      fit.runs[side] = run;
      const PlacedPlate& plate = parts.plates[fit.report.plates[side]];
      const JointRange joint = joint_range(fit, side, plate);
      BendStretch& report = parts.fits[bend].report.stretches.emplace_back();
      report.edges[side] = edges_of(plate, run);
      const int other = 1 - side;
      report.edges[other] = edges_of(parts.plates[fit.report.plates[other]], fit.runs[other]);
      report.width = joint.high - joint.low;
      parts.fits.push_back(std::move(fit));
    }
}

/// Adds the further stretches of one bend.
void widen(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
           TakenEdges& taken, BendFit& fit) {
  const std::vector<int>& rows = fit.report.plates;
  const FitTask task = task_of(structure, plates, taken, rows, fit.report.request);
  fit.stretches = further_stretches(fit, task);
  if (fit.stretches.empty()) return;
  fit.stretches.insert(fit.stretches.begin(), {fit.boundaries, fit.runs, {}});
  fit.stretches = merged_stretches(std::move(fit.stretches), fit, task);
  for (const BendBand& band : fit.stretches)
    take(band, rows, plates, taken);
  // The band that was fitted stays the bend's own, with what it was merged with.
  const double at = fit.boundaries.low.v[0];
  const auto own = std::ranges::find_if(fit.stretches, [&](const BendBand& band) {
    return band.boundaries.low.v[0] <= at && at < band.boundaries.high.v[0];
  });
  fit.boundaries = std::move(own->boundaries);
  fit.runs = own->runs;
  fit.more = std::move(own->more);
  fit.stretches.erase(own);
}

/// Whether every plate has an outline with all bends on it.
bool outlines_hold(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   const std::vector<BendFit>& fits) {
  Parts parts = parts_of(structure, plates, 0);
  parts.fits = fits;
  append_stretches(parts);
  for (int p = 0; p < static_cast<int>(plates.size()); ++p)
    if (!plate_face(parts, p, 1)) return false;
  return true;
}

bool is_wider(const BendFit& fit) {
  return !fit.stretches.empty() || !fit.more[0].empty() || !fit.more[1].empty();
}

/// How far the joints of a bend lie beside each other, if they have no width in common.
std::optional<double> apart_along(const BendFit& fit, const std::vector<PlacedPlate>& plates) {
  const std::vector<int>& rows = fit.report.plates;
  if (fit.fold || rows.size() != 2 || is_wider(fit)) return std::nullopt;
  const JointRange a = joint_range(fit, 0, plates[rows[0]]);
  const JointRange b = joint_range(fit, 1, plates[rows[1]]);
  const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
  if (common > kDrawn) return std::nullopt;
  return std::max(0.0, -common);
}

}  // namespace

void measure_joint(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   const TakenEdges& taken, BendFit& fit) {
  const auto width = [](const Boundaries& b) {
    return 0.5 * (b.high.v[0] + b.high.v[1] - b.low.v[0] - b.low.v[1]);
  };
  fit.report.joined = fit.fold ? fit.fold->high - fit.fold->low : width(fit.boundaries);
  for (const BendBand& band : fit.stretches)
    fit.report.joined += width(band.boundaries);
  fit.report.beside = apart_along(fit, plates);
  fit.report.unused = unused_edges(
      fit, task_of(structure, plates, taken, fit.report.plates, fit.report.request));
}

void add_stretches(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                   TakenEdges& taken, std::vector<BendFit>& fits) {
  const auto alone = std::pair{taken, fits};
  for (BendFit& fit : fits)
    widen(structure, plates, taken, fit);
  if (std::ranges::any_of(fits, is_wider) && !outlines_hold(structure, plates, fits)) {
    std::tie(taken, fits) = alone;
    for (BendFit& fit : fits) {
      const auto narrow = std::pair{taken, fit};
      widen(structure, plates, taken, fit);
      if (is_wider(fit) && !outlines_hold(structure, plates, fits)) std::tie(taken, fit) = narrow;
    }
  }
  for (BendFit& fit : fits)
    measure_joint(structure, plates, taken, fit);
}

void append_stretches(Parts& parts) {
  const int bends = static_cast<int>(parts.fits.size());
  for (int b = 0; b < bends; ++b) {
    const BendFit& fit = parts.fits[b];
    for (std::size_t side = 0; side < 2 && fit.report.plates.size() == 2; ++side)
      parts.fits[b].report.edges[side] = edges_of(parts.plates[fit.report.plates[side]],
                                                  fit.runs[side]);
    append_joints(parts, b, b);
  }
  for (int b = 0; b < bends; ++b)
    for (const BendBand& band : std::exchange(parts.fits[b].stretches, {})) {
      BendFit fit = parts.fits[b];
      fit.boundaries = band.boundaries;
      fit.runs = band.runs;
      fit.stretch_of = b;
      BendStretch& report = parts.fits[b].report.stretches.emplace_back();
      for (std::size_t side = 0; side < 2; ++side)
        report.edges[side] = edges_of(parts.plates[fit.report.plates[side]], band.runs[side]);
      report.width = band.boundaries.high.v[0] - band.boundaries.low.v[0];
      fit.more = band.more;
      parts.fits.push_back(std::move(fit));
      append_joints(parts, static_cast<int>(parts.fits.size()) - 1, b);
    }
}

}  // namespace planish::connect_detail
