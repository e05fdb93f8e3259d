#pragma once

#include "snapshot.hpp"
#include "strip_solver.hpp"

#include <vector>

namespace planish::slit_detail {

/// What a strip must not cross: its mirror image, and with `of_neighbours` also the strips beside
/// it.
enum class Clear { of_mirror, of_neighbours };

/// Of the thickness: as deep as edges of neighbours may press on each other.
constexpr double kPressed = 0.25;

/// Solves one strip of a snapshot and measures it.
StripSolution work_on(Snapshot& now, int strip, Clear clear, const DescentOptions& options);

/// Whether a strip that touches others could be led to its end from where it is: what it would do
/// by itself does not matter. False if it must be solved.
bool goes_on(Snapshot& now, int strip);

/// Solves strips again from their neighbours' shapes, as long as one bends less then: the
/// conditions have many solutions, and neighbours show which of them go together. Returns the
/// iterations taken.
int improve_from_neighbours(Snapshot& now, const std::vector<int>& strips,
                            const DescentOptions& options);

/// What a shape of a strip must not reach beyond, and does.
PlanesBroken planes_broken(const Snapshot& now, int strip, Clear clear);

/// Puts another shape that meets the end conditions in the place of a solved strip's, measured.
void take_shape(Snapshot& now, int strip, const StripParameters& p,
                std::vector<Inequality> inequalities, bool touches);

/// Records which strips are crossed by those that moved.
void note_crossings(Snapshot& now, const std::vector<int>& moved);

/// Separates neighbours that cross each other, at least one of which has moved: the one gives way
/// for which their total objective is better. Best effort: a strip that would be creased stays.
/// Returns the iterations taken.
int part_neighbours(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options);

}  // namespace planish::slit_detail
