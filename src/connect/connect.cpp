#include "alternatives.hpp"
#include "assemble.hpp"
#include "close_loops.hpp"
#include "interrupted_bends.hpp"
#include "join_tree.hpp"
#include "loops.hpp"
#include "plate_pairs.hpp"
#include "refusals.hpp"
#include "request_check.hpp"
#include "taken_edges.hpp"
#include "trim.hpp"

#include <planish/connect/connect.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

// Plates in space become one sheet (math.md#bend-fitting). Plates are placed in their planes and
// must be apart; bends are fitted as requested or along a tree of nearest pairs, stretches added,
// the whole assembled and checked as any sheet is. Bends are numbered by the plates that they join,
// so that one keeps its number when a plate moves.

namespace planish {
namespace {

using namespace connect_detail;

std::string pointer_of(std::size_t plate) { return "/plates/" + std::to_string(plate); }

Result<std::vector<PlacedPlate>> place_all(const PlateStructure& structure,
                                           const ConnectOptions& options) {
  std::vector<PlacedPlate> plates;
  for (std::size_t p = 0; p < structure.plates.size(); ++p) {
    auto plate = placed(structure.plates[p], pointer_of(p), options.planarity);
    if (!plate) return pass_on(plate);
    for (std::size_t q = 0; q < p; ++q)
      if (structure.plates[q].id == structure.plates[p].id)
        return fail(refuse::same_id, {{"plate", place::plate(structure.plates[p].id)},
                                      {"id", place::pointer(pointer_of(p) + "/id")}});
    plates.push_back(std::move(*plate));
  }
  return plates;
}

/// Two plates, the place where they come too near, and the later one in the file.
Facts both_at(const PlateStructure& structure, std::size_t a, std::size_t b, const Vec3& at) {
  return {{"plate", place::at(place::plate(structure.plates[a].id), at)},
          {"plate", place::at(place::plate(structure.plates[b].id), at)},
          {"at", place::point(at)},
          {"later", place::pointer(pointer_of(b))}};
}

Result<void> check_apart(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                         const ConnectOptions& options) {
  for (std::size_t a = 0; a < plates.size(); ++a)
    for (std::size_t b = a + 1; b < plates.size(); ++b) {
      if (const auto at = intersection(plates[a], plates[b], options.planarity))
        return fail(refuse::plates_cross, both_at(structure, a, b, *at));
      auto near = too_near(plates[a], plates[b], structure.thickness);
      if (!near) near = too_near(plates[b], plates[a], structure.thickness);
      if (!near) continue;
      Facts facts = both_at(structure, a, b, near->at);
      facts.emplace_back("gap", near->distance, unit::mm);
      facts.emplace_back("thickness", structure.thickness, unit::mm);
      facts.emplace_back("least", near->needed, unit::mm);
      return fail(refuse::plates_too_near, facts);
    }
  return {};
}

Result<int> root_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates) {
  if (structure.root.empty()) {
    const auto largest = std::ranges::max_element(plates, {}, &PlacedPlate::area);
    return static_cast<int>(largest - plates.begin());
  }
  return row_of(structure, structure.root, "/root");
}

Result<void> check_options(const ConnectOptions& options) {
  const auto bad = [](const char* name, double value, std::string_view unit, const char* range) {
    return fail(refuse::bad_connect_option,
                {{"name", name}, {"value", value, unit}, {"range", range}});
  };
  if (!(options.k_factor >= 0.0 && options.k_factor <= 1.0))
    return bad("`k`", options.k_factor, unit::none, "a value from 0 to 1");
  if (!(options.smallest_slope >= 0.0 && std::isfinite(options.smallest_slope)))
    return bad("The smallest slope", options.smallest_slope, unit::none, "0 or more");
  if (!(options.planarity >= 0.0 && std::isfinite(options.planarity)))
    return bad("The planarity", options.planarity, unit::mm, "0 mm or more");
  if (options.alternatives < 0)
    return bad("The number of alternatives", options.alternatives, unit::none, "0 or more");
  return {};
}

Result<void> check_whole(const PlateStructure& structure) {
  if (!(structure.thickness > 0.0) || !std::isfinite(structure.thickness))
    return fail(refuse::bad_value, {{"name", "thickness"},
                                    {"value", structure.thickness, unit::mm},
                                    {"range", "a value above 0"},
                                    {"field", place::pointer("/thickness")}});
  if (structure.plates.empty() && structure.bends.size() != 1)
    return fail(refuse::bends_without_plates,
                {{"bends", structure.bends.size()}, {"field", place::pointer("/plates")}});
  return {};
}

/// What else would join the plates of each bend, by the edges that the others leave free.
void add_alternatives(const PlateStructure& structure, const ConnectOptions& options,
                      Parts& parts) {
  for (BendFit& fit : parts.fits) {
    FittedBend& report = fit.report;
    if (report.plates.size() < 2 || fit.fold) continue;
    const FitTask task = task_of(structure, parts.plates, taken_by(parts, &fit), report.plates,
                                 report.request);
    report.alternatives = alternatives_to(report, task, options);
  }
}

/// Joins plates in their places.
Result<Connection> joined(const PlateStructure& structure, const Trimmed& trimmed,
                          const ConnectOptions& options, const Progress& progress) {
  const std::vector<PlacedPlate>& plates = trimmed.plates;
  if (auto apart = check_apart(structure, plates, options); !apart) return pass_on(apart);
  const auto root = root_of(structure, plates);
  if (!root) return pass_on(root);
  const bool found = structure.bends.empty();
  auto fits = found ? fit_tree(structure, plates, trimmed.shared, options, progress)
                    : fit_requested(structure, plates, options, progress);
  if (!fits) return pass_on(fits);
  // Numbered by the plates they join, so that a bend keeps its number when a plate moves.
  if (found)
    std::ranges::sort(
        *fits, {}, [](const BendFit& fit) -> const auto& { return fit.report.plates; });
  Parts parts = parts_of(structure, plates, 0);
  parts.fits = std::move(*fits);
  parts.root = *root;
  if (found) close_loops(structure, trimmed.shared, options, parts);
  add_alternatives(structure, options, parts);
  const std::size_t bends = parts.fits.size();
  append_stretches(parts);
  auto made = assembled(parts);
  if (!made) return pass_on(made);
  if (auto flat = check_loops(parts, *made, options.k_factor); !flat) return pass_on(flat);
  Connection connection{
      structure, std::move(made->sheet), {}, std::move(made->plate_faces), made->root};
  connection.trimmed = trimmed.cut;
  connection.left_open = left_open(trimmed.shared, parts);
  for (std::size_t b = 0; b < bends; ++b) {
    connection.bends.push_back(std::move(parts.fits[b].report));
    connection.bends.back().bend = made->bends[b];
  }
  return connection;
}

/// How many of the edges that plates share are between plates that a bend joins.
std::ptrdiff_t joints_on(const std::vector<SharedEdge>& shared, const Connection& made) {
  return std::ranges::count_if(shared, [&](const SharedEdge& edge) {
    return edge.from != edge.to && std::ranges::any_of(made.bends, [&](const FittedBend& bend) {
             return std::ranges::is_permutation(bend.plates, edge.plates);
           });
  });
}

/// Joins plates that are cut back where they touch if that was asked for or helps.
Result<Connection> joined_trimmed(const PlateStructure& structure, std::vector<PlacedPlate> plates,
                                  const Trimmed& trimmed, const ConnectOptions& options,
                                  const Progress& progress) {
  if (structure.trim == true || (trimmed.all_touch && trimmed.cut.empty()))
    return joined(structure, trimmed, options, progress);
  // What was not asked for must not stand in the way.
  auto first = joined(structure, trimmed.all_touch ? trimmed : Trimmed{plates}, options, progress);
  if (trimmed.cut.empty() || (first && trimmed.all_touch)) return first;
  if (trimmed.all_touch) return joined(structure, {std::move(plates)}, options, progress);
  // Where only some plates touch, they may be meant to: but not to be joined elsewhere instead.
  auto second = joined(structure, trimmed, options, progress);
  const bool better = second && (!first || joints_on(trimmed.shared, *second) >
                                               joints_on(trimmed.shared, *first));
  return better ? second : first;
}

/// A plate that cannot be joined may be too narrow for the bend where it touches another one.
Error with_narrow_plate(const PlateStructure& structure, const Trimmed& trimmed, Error why) {
  if (why.code != code::plates_touch && why.code != code::no_bend_fits) return why;
  for (const NarrowPlate& narrow : trimmed.narrow) {
    const Place plate = place::plate(structure.plates[narrow.plate].id);
    const auto is_it = [&](const Place& one) {
      return one.kind == plate.kind && one.id == plate.id;
    };
    if (std::ranges::none_of(why.places, is_it)) continue;
    return error_of(refuse::flange_too_narrow,
                    {{"plate", plate},
                     {"other", place::plate(structure.plates[narrow.other].id)},
                     {"width", narrow.width, unit::mm},
                     {"needed", narrow.needed, unit::mm},
                     {"radius", narrow.inside_radius, unit::mm},
                     {"field", place::pointer(pointer_of(narrow.plate))}});
  }
  return why;
}

}  // namespace

Result<Connection> connect(const PlateStructure& structure, const ConnectOptions& options,
                           const Progress& progress) {
  if (auto sound = check_options(options); !sound) return pass_on(sound);
  if (auto whole = check_whole(structure); !whole) return pass_on(whole);
  auto plates = place_all(structure, options);
  if (!plates) return pass_on(plates);
  if (structure.trim == false) return joined(structure, {*plates}, options, progress);
  const Trimmed trimmed = trimmed_where_touching(structure, *plates);
  auto made = joined_trimmed(structure, std::move(*plates), trimmed, options, progress);
  if (made) return made;
  return tl::unexpected(with_narrow_plate(structure, trimmed, made.error()));
}

}  // namespace planish
