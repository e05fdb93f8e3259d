#pragma once

#include "observation.hpp"
#include "workpiece.hpp"

namespace planish::inspect_detail {

/// Violations of one or a few rules each, in the order of bends and openings.
std::vector<Observation> observe_flange_heights(const Workpiece& workpiece, const Rules& rules);
std::vector<Observation> observe_reliefs(const Workpiece& workpiece, const Rules& rules);
/// Inside radius, hem diameter and return, K-factor.
std::vector<Observation> observe_bend_shapes(const Workpiece& workpiece, const Rules& rules);

std::vector<Observation> observe_openings_by_bends(const Workpiece& workpiece, const Rules& rules);
std::vector<Observation> observe_openings_by_edges(const Workpiece& workpiece, const Rules& rules);
std::vector<Observation> observe_openings_by_openings(const Workpiece& workpiece,
                                                      const Rules& rules);
std::vector<Observation> observe_opening_sizes(const Workpiece& workpiece, const Rules& rules);

/// Distance from the outside of a bend to its tangent line, as a shop measures a leg: from the
/// outer mould line up to 90°, from the tangent plane beyond.
double measured_setback(const FlatBend& bend, double thickness);

/// The flat length beside a bend.
struct FlatLength {
  double length = 0.0;               ///< from the tangent line, mm; infinite beyond the reach
  Vec2 at = Vec2::Zero();            ///< on the tangent line
  std::optional<size_t> other_bend;  ///< the flange ends at that bend's tangent line
};
/// The shortest flat length at a side of a bend, up to `reach`, measured at stations along it.
/// Chamfers and rounded corners within `margin` of the bend's ends are accepted.
FlatLength shortest_flat(const Workpiece& workpiece, const BendSide& side, double reach,
                         double margin);

}  // namespace planish::inspect_detail
