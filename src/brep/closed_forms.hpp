#pragma once

#include "grouping.hpp"

namespace planish::brep {

/// Forms that stay attached all round (bridges, closed lances): groups inside an inner loop of a
/// flange that make a ring with it. Their faces, for the caller to take off the skin.
std::vector<int> closed_forms(const SolidModel& model, const std::vector<Outline>& outlines,
                              const Groups& groups);

}  // namespace planish::brep
