#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Whether two faces that meet lie on one plane, cylinder or cone with the material on the same
/// side, as closely as files and fits of a solid of that size (mm) are accurate. Planes that meet
/// are taken for one; ruled surfaces never are.
bool same_surface(const SolidFace& f, const SolidFace& g, double size);

}  // namespace planish::brep
