#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// The bend with kind, angle, inside radius and inside as measured on its faces in the sheet.
/// Cylinders and cones: closed form. Others: normals at 256 steps along the middle of the bend give
/// its turn, smallest radius and inside. Requires: a bend with faces, which lie on one surface and
/// on one turn of it.
Bend measured_bend(const Sheet& sheet, BendId bend);

}  // namespace planish::brep
