#pragma once

#include "features.hpp"

namespace planish::brep {

/// Measures openings that reach into a bend and are cut along the outline of the reference skin
/// though they are machined there, since their narrowest section was not found: by how much the cut
/// is too wide, at most. The certificate tells, so that no size is wrong in silence.
void measure_wide_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of);

}  // namespace planish::brep
