#pragma once

#include "snapshot.hpp"
#include "strip_solver.hpp"

#include <vector>

namespace planish::slit_detail {

/// What a strip is kept clear of: its mirror image, and with `of_neighbours` also the strips beside
/// it.
enum class Clear { of_mirror, of_neighbours };

/// Solves one strip of a snapshot and measures it.
StripSolution work_on(Snapshot& now, int strip, Clear clear, const DescentOptions& options);

/// Notes which strips those that moved run through.
void note_crossings(Snapshot& now, const std::vector<int>& moved);

/// Parts neighbours that run through each other, at least one of which has moved: that one gives
/// way with which both together come nearer to what is wanted. Best effort: a strip that would be
/// creased stays. Returns the iterations taken.
int part_neighbours(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options);

}  // namespace planish::slit_detail
