#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// The model as intended: slivers narrower than the accuracy of files are closed, and neighbouring
/// faces on one plane become one face. Faces keep their numbers; those merged into another keep no
/// loops and are listed in its `merged`.
SolidModel healed(SolidModel model);

}  // namespace planish::brep
