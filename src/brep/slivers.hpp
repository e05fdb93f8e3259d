#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// The model without its slivers: strips narrower than files are accurate, between two faces that
/// were meant to meet. Those faces share one edge of the strip afterwards; the strip keeps its
/// number and has no loops.
SolidModel without_slivers(SolidModel model);

}  // namespace planish::brep
