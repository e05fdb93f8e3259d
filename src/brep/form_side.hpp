#pragma once

#include "assembly.hpp"

namespace planish::brep {

/// The side to which a form that leaves the sheet and touches the reference skin stands out.
FormSide raised_side(const Recognition& of, const RimPart& part);

/// The side on which an opening is wider by more than this ratio of areas: `mine` on the reference
/// skin, `theirs` on the other.
FormSide wider_side(const BorderLoop& mine, const BorderLoop& theirs, double ratio);

}  // namespace planish::brep
