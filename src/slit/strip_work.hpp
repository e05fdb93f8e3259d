#pragma once

#include "snapshot.hpp"
#include "strip_solver.hpp"

#include <vector>

namespace planish::slit_detail {

/// What a strip must not cross: its mirror image, and with `of_neighbours` also the strips beside
/// it.
enum class Clear { of_mirror, of_neighbours };

/// Solves one strip of a snapshot and measures it.
StripSolution work_on(Snapshot& now, int strip, Clear clear, const DescentOptions& options);

/// Records which strips are crossed by those that moved.
void note_crossings(Snapshot& now, const std::vector<int>& moved);

/// Separates neighbours that cross each other, at least one of which has moved: the one gives way
/// for which their total objective is better. Best effort: a strip that would be creased stays.
/// Returns the iterations taken.
int part_neighbours(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options);

}  // namespace planish::slit_detail
