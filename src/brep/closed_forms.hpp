#pragma once

#include "grouping.hpp"

namespace planish::brep {

/// Faces of forms that stay attached on all sides (bridges, closed lances): groups inside an inner
/// loop of a flange that form a ring with it. The caller removes them from the skin.
std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups);

}  // namespace planish::brep
