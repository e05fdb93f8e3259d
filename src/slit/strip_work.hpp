#pragma once

#include "snapshot.hpp"
#include "strip_solver.hpp"

namespace planish::slit_detail {

/// Solves one strip of a snapshot, clear of its mirror image and of neighbours that stand, and measures it.
StripSolution work_on(Snapshot& now, int strip, const DescentOptions& options);

/// Whether a strip runs through the next one, noted in its state; nothing where there is no next one.
void note_crossing(Snapshot& now, int strip);

}  // namespace planish::slit_detail
