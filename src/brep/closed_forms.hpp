#pragma once

#include "grouping.hpp"
#include "rim.hpp"

namespace planish::brep {

/// Faces of forms that stay attached on all sides (bridges, closed lances, beads): groups inside an
/// inner loop of a flange that form a ring with it, among themselves or by faces that rise from the
/// sheet: doubly curved or upright ones; and curved ones at sharp edges anywhere that end in a
/// doubly curved face beside both. None of them has more than a quarter of the skin. The caller
/// removes them from it.
std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups, const Rim& rim);

}  // namespace planish::brep
