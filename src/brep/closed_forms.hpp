#pragma once

#include "grouping.hpp"
#include "rim.hpp"

namespace planish::brep {

/// Faces of forms that stay attached on all sides (bridges, closed lances, beads): groups inside an
/// inner loop of a flange that form a ring with it, among themselves or by doubly curved faces that
/// stand out of the sheet. The caller removes them from the skin.
std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups, const Rim& rim);

}  // namespace planish::brep
