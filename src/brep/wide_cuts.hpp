#pragma once

#include "features.hpp"

namespace planish::brep {

/// Measures openings at bends that are machined, or cut across a tangent line: how far their walls
/// lie within what is cut, seen along the normal of the skin; and what is machined beside the
/// outline of a bent sheet: how far it lies beyond. The certificate tells, so that no size is wrong
/// in silence where the narrowest section or the widest outline was not found.
void measure_wide_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of);

}  // namespace planish::brep
