#pragma once

#include <planish/base/angle.hpp>

#include <TopoDS_Shape.hxx>

namespace planish::brep {

/// Has the kernel store triangles in every face of the shape, within `chord` mm of it; along curved
/// borders neighbouring chords turn by at most `turn`.
void triangulate(const TopoDS_Shape& shape, double chord, Angle turn = Angle::degrees(10));

}  // namespace planish::brep
