#pragma once

#include "snapshot.hpp"
#include "strip_solver.hpp"

#include <vector>

namespace planish::slit_detail {

/// What a strip is kept clear of: its mirror image, and with `neighbours` the strips beside it too.
enum class Clear { of_mirror, of_neighbours };

/// Solves one strip of a snapshot and measures it.
StripSolution work_on(Snapshot& now, int strip, Clear clear, const DescentOptions& options);

/// Notes which strips those that moved run through.
void note_crossings(Snapshot& now, const std::vector<int>& moved);

/// Neighbours that run through each other, one of them at least moved: one gives way, whichever
/// lets both together be nearer to what is wanted. Best effort: a strip that would be creased for
/// it stays. Returns the iterations taken.
int part_neighbours(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options);

}  // namespace planish::slit_detail
