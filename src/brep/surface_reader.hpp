#pragma once

#include "solid_model.hpp"

#include <TopoDS_Face.hxx>

namespace planish::brep {

/// The surface of a face as recognition sees it, the sense of its outward normal, and how far the
/// face's own surface lies from it. Loops and volume are left alone.
SolidFace read_surface(const TopoDS_Face& face, double tolerance);

}  // namespace planish::brep
