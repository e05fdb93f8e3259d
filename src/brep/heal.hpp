#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// The model as it was meant: slivers narrower than files are accurate are closed, and neighbouring
/// faces on one plane are one face. Faces keep their numbers; those merged into another are left
/// without loops and named in its `merged`.
SolidModel healed(SolidModel model);

}  // namespace planish::brep
