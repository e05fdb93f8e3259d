#include "plane_opening.hpp"

#include "borders.hpp"
#include "features.hpp"
#include "form_volume.hpp"
#include "narrowest.hpp"
#include "skin_outlines.hpp"
#include "threads.hpp"

#include <algorithm>

// The opening of its own walls: one loop on either skin. The least of both outlines, of the section
// between edges and of a round core is cut.

namespace planish::brep {
namespace {

/// A thread with the countersinks that are wider than it.
std::vector<FormedFeature> threaded(const PlaneOpening& opening, const BorderRef& first,
                                    const BorderLoop& nominal) {
  const auto is_within = [&](const BorderLoop& outline) {
    return (bounds(outline).size() - bounds(nominal).size()).maxCoeff() <= kWiderOutline;
  };
  std::vector<FormedFeature> found = widenings(
      {opening.part, opening.here, opening.there, is_within(opening.mine) ? nominal : opening.mine,
       is_within(opening.theirs) ? nominal : opening.theirs},
      first, nominal);
  found.push_back(drawn_opening("thread", FormSide::both, opening, first, {nominal}));
  return found;
}

}  // namespace

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

FormedFeature drawn_opening(const char* kind, FormSide side, const PlaneOpening& opening,
                            const BorderRef& first, std::vector<BorderLoop> outlines) {
  FormedFeature feature = feature_of(kind, side, opening.part.faces.front(), first.face);
  feature.outlines = std::move(outlines);
  return feature;
}

std::vector<FormedFeature> widenings(const PlaneOpening& opening, const BorderRef& first,
                                     const BorderLoop& cut) {
  const BorderLoop &mine = opening.mine, &theirs = opening.theirs;
  const auto drawn = [&](FormSide side, std::vector<BorderLoop> outlines) {
    return drawn_opening("countersink", side, opening, first, std::move(outlines));
  };
  const bool up = is_wider(mine, cut), down = is_wider(theirs, cut);
  if (up && down && !is_wider(mine, theirs) && !is_wider(theirs, mine))
    return {drawn(FormSide::both, {mine, theirs})};
  std::vector<FormedFeature> found;
  if (up) found.push_back(drawn(FormSide::up, {mine}));
  if (down) found.push_back(drawn(FormSide::down, {theirs}));
  return found;
}

std::vector<FormedFeature> machined_round(const Recognition& of, const PlaneOpening& opening,
                                          const Frame& plane, const BorderRef& first,
                                          const BorderLoop& cut) {
  const auto thread = thread_about(of, opening.part, plane, cut);
  return thread ? threaded(opening, first, *thread) : widenings(opening, first, cut);
}

}  // namespace planish::brep
