#pragma once

#include "stage_cache.hpp"

#include <vector>

namespace planish::brake_detail {

/// Whether two lines are pieces of one line of the pattern, bent alike. Press lines and hems are
/// not.
bool lie_on_one_line(const BrakeLine& a, const BrakeLine& b);

/// The lines that continue a line in a stage and may be pressed with it, itself included.
std::vector<int> together(StageCache& cache, int line, const LineSet& formed);

/// Pieces of the bend line along x, from the lowest on; in the frame of the first line pressed.
std::vector<Interval> pressed_pieces(StageCache& cache, const Setting& stroke);

/// The same, as far as the tools have to press it: not the ends of press lines that lie in the zone
/// of the next one, where what bends one bends the other (math.md#tool-segments).
std::vector<Interval> pieces_to_press(StageCache& cache, const Setting& stroke);

}  // namespace planish::brake_detail
