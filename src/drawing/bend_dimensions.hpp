#pragma once

#include <planish/drawing/page_parts.hpp>
#include <planish/schema/units.hpp>

#include <vector>

namespace planish::drawing {

/// The distances of bend lines from the left and from the lower edge of a pattern, mm, each once
/// and ascending. Lines that are neither upright nor level have none.
struct BendDistances {
  std::vector<double> from_left, from_below;
};
BendDistances bend_distances(const FlatPattern& flat);

/// Whether a line is upright or level.
bool is_dimensioned(const Segment& line);

/// Places in order, each at least `gap` behind the one before and all from `low` to `high`, as near
/// to those wanted as that goes. Empty if there is no room for all.
std::vector<double> spread(std::vector<double> wanted, double gap, double low, double high);

/// Writes the distances below the pattern and on its right, each with a line to its bend, measured
/// from the edges that the overall sizes begin at. Returns how many there was no room for.
std::size_t dimension_bends(Page& page, const FlatPattern& flat, const Fit& fit,
                            const schema::Units& units);

}  // namespace planish::drawing
