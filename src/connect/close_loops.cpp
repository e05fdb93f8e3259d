#include "close_loops.hpp"

#include "fit_check.hpp"
#include "interrupted_bends.hpp"
#include "loops.hpp"
#include "taken_edges.hpp"

#include <algorithm>
#include <utility>

// What a tree of bends leaves open of plates that touch: tried one by one, kept where the loop lies
// flat (math.md#cycles).

namespace planish::connect_detail {
namespace {

bool joined(const SharedEdge& edge, const Parts& parts) {
  return std::ranges::any_of(parts.fits, [&](const BendFit& fit) {
    const std::vector<int>& rows = fit.report.plates;
    return std::ranges::find(rows, edge.plates[0]) != rows.end() &&
           std::ranges::find(rows, edge.plates[1]) != rows.end();
  });
}

/// The parts with one more bend; empty if it does not hold.
std::optional<Parts> with_bend(const PlateStructure& structure, const SharedEdge& edge,
                               const ConnectOptions& options, Parts parts) {
  const std::vector<int> rows(edge.plates.begin(), edge.plates.end());
  const BendRequest request{.between = {parts.ids[rows[0]], parts.ids[rows[1]]},
                            .inside_radius = structure.defaults.inside_radius,
                            .lateral = structure.defaults.lateral,
                            .trade_off = structure.defaults.trade_off};
  auto fit = fit_between(task_of(structure, parts.plates, taken_by(parts), rows, request), options);
  if (!fit) return std::nullopt;
  fit->report.plates = rows;
  const int number = static_cast<int>(parts.fits.size());
  parts.fits.push_back(std::move(*fit));
  measure_joint(structure, parts.plates, taken_by(parts), parts.fits.back());
  if (!check_on_plates(parts, number)) return std::nullopt;
  const auto made = assembled(parts);
  if (!made || !check_loops(parts, *made, options.k_factor)) return std::nullopt;
  return parts;
}

}  // namespace

void close_loops(const PlateStructure& structure, const std::vector<SharedEdge>& shared,
                 const ConnectOptions& options, Parts& parts) {
  for (const SharedEdge& edge : shared)
    if (!joined(edge, parts))
      if (auto closed = with_bend(structure, edge, options, parts)) parts = std::move(*closed);
}

std::vector<SharedEdge> left_open(const std::vector<SharedEdge>& shared, const Parts& parts) {
  std::vector<SharedEdge> open;
  std::ranges::copy_if(shared, std::back_inserter(open),
                       [&](const SharedEdge& edge) { return !joined(edge, parts); });
  return open;
}

}  // namespace planish::connect_detail
