#pragma once

#include <planish/geometry/interval.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>

namespace planish::brep {

/// The bend with kind, angle, inside radius and inside as measured on its faces in the sheet.
/// Cylinders and cones: closed form. Others: normals at 256 steps along the middle of the bend give
/// its turn, smallest radius and inside. Requires: a bend with faces, which lie on one surface and
/// on one turn of it. `own_u`: where the solid's own faces of the bend lie, if borders below the
/// skin are cut instead of theirs. What such a border has beyond the tangent line at which the bend
/// ends is the flange's, and no part of its angle.
Bend measured_bend(const Sheet& sheet, BendId bend, std::optional<Interval> own_u = {});

}  // namespace planish::brep
