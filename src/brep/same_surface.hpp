#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Whether two faces that meet lie on one plane, cylinder or cone with the material on the same
/// side, within the accuracy of files and fits for a solid of that size (mm). Planes that meet
/// count as one; ruled surfaces never do.
bool same_surface(const SolidFace& f, const SolidFace& g, double size);

}  // namespace planish::brep
