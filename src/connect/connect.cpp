#include "assemble.hpp"
#include "join_tree.hpp"
#include "loops.hpp"
#include "plate_outline.hpp"
#include "plate_pairs.hpp"

#include <planish/connect/connect.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace planish {
namespace {

using namespace connect_detail;

Result<std::vector<PlacedPlate>> place_all(const PlateStructure& structure,
                                           const ConnectOptions& options) {
  std::vector<PlacedPlate> plates;
  for (std::size_t p = 0; p < structure.plates.size(); ++p) {
    auto plate = placed(structure.plates[p], fmt::format("/plates/{}", p), options.planarity);
    if (!plate) return tl::unexpected(plate.error());
    for (std::size_t q = 0; q < p; ++q)
      if (structure.plates[q].id == structure.plates[p].id)
        return fail(
            ErrorCode::invalid_input,
            fmt::format("two plates have the id \"{}\": ids must differ", structure.plates[p].id),
            fmt::format("/plates/{}/id", p));
    plates.push_back(std::move(*plate));
  }
  return plates;
}

Result<void> check_apart(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                         const ConnectOptions& options) {
  for (std::size_t a = 0; a < plates.size(); ++a)
    for (std::size_t b = a + 1; b < plates.size(); ++b) {
      if (const auto at = intersection(plates[a], plates[b], options.planarity))
        return fail(
            ErrorCode::plates_intersect,
            fmt::format(
                "plates \"{}\" and \"{}\" pass through each other at ({:.6g}, {:.6g}, {:.6g})",
                structure.plates[a].id, structure.plates[b].id, at->x(), at->y(), at->z()),
            fmt::format("/plates/{}", b));
      auto near = too_near(plates[a], plates[b], structure.thickness);
      if (!near) near = too_near(plates[b], plates[a], structure.thickness);
      if (near)
        return fail(ErrorCode::plates_touch,
                    fmt::format("plates \"{}\" and \"{}\" are {:.4g} mm apart at ({:.6g}, {:.6g}, "
                                "{:.6g}), where sheets of {:.4g} mm need {:.4g} "
                                "mm between their middles: move them apart",
                                structure.plates[a].id, structure.plates[b].id, near->distance,
                                near->at.x(), near->at.y(), near->at.z(), structure.thickness,
                                near->needed),
                    fmt::format("/plates/{}", b));
    }
  return {};
}

Result<int> root_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates) {
  if (structure.root.empty()) {
    const auto largest = std::max_element(
        plates.begin(), plates.end(),
        [](const PlacedPlate& a, const PlacedPlate& b) { return a.area < b.area; });
    return static_cast<int>(largest - plates.begin());
  }
  for (std::size_t p = 0; p < plates.size(); ++p)
    if (structure.plates[p].id == structure.root) return static_cast<int>(p);
  return fail(ErrorCode::unknown_plate,
              fmt::format("root is \"{}\", which is not the id of a plate", structure.root),
              "/root");
}

Result<void> check_options(const ConnectOptions& options) {
  const auto bad = [](const char* name, double value, const char* range) {
    return fail(ErrorCode::bad_option, fmt::format("{} is {}; it must be {}", name, value, range));
  };
  if (!(options.k_factor >= 0.0 && options.k_factor <= 1.0))
    return bad("the K-factor", options.k_factor, "from 0 to 1");
  if (!(options.smallest_slope >= 0.0 && std::isfinite(options.smallest_slope)))
    return bad("the smallest slope", options.smallest_slope, "0 or more");
  if (!(options.planarity >= 0.0 && std::isfinite(options.planarity)))
    return bad("the planarity", options.planarity, "0 mm or more");
  if (options.alternatives < 0)
    return bad("the number of alternatives", options.alternatives, "0 or more");
  return {};
}

Result<void> check_whole(const PlateStructure& structure) {
  if (!(structure.thickness > 0.0) || !std::isfinite(structure.thickness))
    return fail(ErrorCode::invalid_input,
                fmt::format("thickness is {} mm; it must be above 0", structure.thickness),
                "/thickness");
  if (structure.plates.empty() && structure.bends.size() != 1)
    return fail(ErrorCode::invalid_input,
                "without plates there must be exactly one bend, a section by itself", "/plates");
  return {};
}

std::vector<int> edges_of(const PlacedPlate& plate, const OutlineRun& run) {
  std::vector<int> edges;
  const int n = static_cast<int>(plate.ring(run.ring).size());
  for (int j = 0; j < run.count; ++j)
    edges.push_back(plate.edge_number({run.ring, (run.first + j) % n}));
  std::sort(edges.begin(), edges.end());
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

/// Makes the stretches of interrupted bends fits of their own, after all others.
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

}  // namespace

Result<Connection> connect(const PlateStructure& structure, const ConnectOptions& options,
                           const Progress& progress) {
  if (auto sound = check_options(options); !sound) return tl::unexpected(sound.error());
  if (auto whole = check_whole(structure); !whole) return tl::unexpected(whole.error());
  auto plates = place_all(structure, options);
  if (!plates) return tl::unexpected(plates.error());
  if (auto apart = check_apart(structure, *plates, options); !apart)
    return tl::unexpected(apart.error());
  const auto root = root_of(structure, *plates);
  if (!root) return tl::unexpected(root.error());
  auto fits = structure.bends.empty() ? fit_tree(structure, *plates, options, progress)
                                      : fit_requested(structure, *plates, options, progress);
  if (!fits) return tl::unexpected(fits.error());
  // Numbered by the plates they join, so that a bend keeps its number when a plate moves.
  if (structure.bends.empty())
    std::sort(fits->begin(), fits->end(),
              [](const BendFit& a, const BendFit& b) { return a.report.plates < b.report.plates; });

  Parts parts{structure.thickness, std::move(*plates), {}, std::move(*fits), *root};
  const std::size_t bends = parts.fits.size();
  append_stretches(parts);
  for (const Plate& plate : structure.plates)
    parts.ids.push_back(plate.id);
  auto made = assembled(parts);
  if (!made) return tl::unexpected(made.error());
  if (auto flat = check_loops(parts, *made, options.k_factor); !flat)
    return tl::unexpected(flat.error());
  Connection connection{
      structure, std::move(made->sheet), {}, std::move(made->plate_faces), made->root};
  for (std::size_t b = 0; b < bends; ++b) {
    connection.bends.push_back(std::move(parts.fits[b].report));
    connection.bends.back().bend = made->bends[b];
  }
  return connection;
}

}  // namespace planish
