#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Makes the model what was meant: slivers narrower than files are accurate are closed, and
/// neighbouring faces on one plane become one face. Faces keep their numbers; those merged into
/// another are left without loops and named in its `merged`.
void heal(SolidModel& model);

}  // namespace planish::brep
