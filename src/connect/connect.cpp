#include "assemble.hpp"
#include "interrupted_bends.hpp"
#include "join_tree.hpp"
#include "loops.hpp"
#include "plate_pairs.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Plates in space become one sheet (math.md#bend-fitting). Plates are placed in their planes and
// must be apart; bends are fitted as requested or along a tree of nearest pairs, stretches added,
// the whole assembled and checked as any sheet is. Bends are numbered by the plates that they join,
// so that one keeps its number when a plate moves.

namespace planish {
namespace {

using namespace connect_detail;

Result<std::vector<PlacedPlate>> place_all(const PlateStructure& structure,
                                           const ConnectOptions& options) {
  std::vector<PlacedPlate> plates;
  for (std::size_t p = 0; p < structure.plates.size(); ++p) {
    auto plate = placed(structure.plates[p], fmt::format("/plates/{}", p), options.planarity);
    if (!plate) return pass_on(plate);
    for (std::size_t q = 0; q < p; ++q)
      if (structure.plates[q].id == structure.plates[p].id)
        return fail(
            code::invalid_input,
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
            code::plates_intersect,
            fmt::format(
                "plates \"{}\" and \"{}\" pass through each other at ({:.6g}, {:.6g}, {:.6g})",
                structure.plates[a].id, structure.plates[b].id, at->x(), at->y(), at->z()),
            fmt::format("/plates/{}", b));
      auto near = too_near(plates[a], plates[b], structure.thickness);
      if (!near) near = too_near(plates[b], plates[a], structure.thickness);
      if (near)
        return fail(code::plates_touch,
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
  return fail(code::unknown_plate,
              fmt::format("root is \"{}\", which is not the id of a plate", structure.root),
              "/root");
}

Result<void> check_options(const ConnectOptions& options) {
  const auto bad = [](const char* name, double value, const char* range) {
    return fail(code::bad_option, fmt::format("{} is {}; it must be {}", name, value, range));
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
    return fail(code::invalid_input,
                fmt::format("thickness is {} mm; it must be above 0", structure.thickness),
                "/thickness");
  if (structure.plates.empty() && structure.bends.size() != 1)
    return fail(code::invalid_input,
                "without plates there must be exactly one bend, a section by itself", "/plates");
  return {};
}

}  // namespace

Result<Connection> connect(const PlateStructure& structure, const ConnectOptions& options,
                           const Progress& progress) {
  if (auto sound = check_options(options); !sound) return pass_on(sound);
  if (auto whole = check_whole(structure); !whole) return pass_on(whole);
  auto plates = place_all(structure, options);
  if (!plates) return pass_on(plates);
  if (auto apart = check_apart(structure, *plates, options); !apart) return pass_on(apart);
  const auto root = root_of(structure, *plates);
  if (!root) return pass_on(root);
  auto fits = structure.bends.empty() ? fit_tree(structure, *plates, options, progress)
                                      : fit_requested(structure, *plates, options, progress);
  if (!fits) return pass_on(fits);
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
  if (!made) return pass_on(made);
  if (auto flat = check_loops(parts, *made, options.k_factor); !flat) return pass_on(flat);
  Connection connection{
      structure, std::move(made->sheet), {}, std::move(made->plate_faces), made->root};
  for (std::size_t b = 0; b < bends; ++b) {
    connection.bends.push_back(std::move(parts.fits[b].report));
    connection.bends.back().bend = made->bends[b];
  }
  return connection;
}

}  // namespace planish
