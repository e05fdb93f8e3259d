#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// The model without slivers: faces narrower than the accuracy of files, between two faces that
/// were meant to meet. These two then share one edge of the sliver, which keeps its number and has
/// no loops.
SolidModel without_slivers(SolidModel model);

}  // namespace planish::brep
