#include "plane_opening.hpp"

#include "borders.hpp"
#include "form_volume.hpp"
#include "narrowest.hpp"
#include "skin_outlines.hpp"

#include <algorithm>

// The opening of its own walls: one loop on either skin. The least of both outlines, of the section
// between edges and of a round core is cut.

namespace planish::brep {

PlaneOpening opening_between(const Recognition& of, const RimPart& part, const LoopRef& here,
                             const LoopRef& there, const Frame& plane) {
  return {part, here, there, read_borders(of.model, loop_of(of, here), plane, 0.0, of.tolerance),
          seen_through(of, there, plane)};
}

bool goes_round(const Recognition& of, const RimPart& part, const LoopRef& ref) {
  return opening_in_plane(of, ref) && std::ranges::all_of(loop_of(of, ref), [&](const CoEdge& use) {
           const int wall = face_across(of.model.edges[use.edge], ref.face);
           return wall >= 0 && of.rim.part_of[wall] >= 0 &&
                  &of.rim.parts[of.rim.part_of[wall]] == &part;
         });
}

std::optional<BorderLoop> narrower_cut(const Recognition& of, const PlaneOpening& opening,
                                       const Frame& plane) {
  const auto section = narrowest_section(of, opening.part, plane);
  const auto core = round_core(of, opening.part, plane);
  const BorderLoop* least = &opening.mine;
  for (const auto* other :
       {&opening.theirs, section ? &*section : nullptr, core ? &*core : nullptr})
    if (other && loop_area(*least) - loop_area(*other) > kSameOutline * perimeter(*other))
      least = other;
  if (least == &opening.mine) return {};
  return *least;
}

}  // namespace planish::brep
