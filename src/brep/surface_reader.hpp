#pragma once

#include "solid_model.hpp"

#include <TopoDS_Face.hxx>

namespace planish::brep {

/// The surface of a face as recognised, the sense of its outward normal, and the distance of the
/// face's own surface from it. Loops and volume are not set.
SolidFace read_surface(const TopoDS_Face& face, double tolerance);

}  // namespace planish::brep
