#pragma once

#include <TopoDS_Shape.hxx>

namespace planish::brep {

/// Has the kernel store triangles in every face of the shape, within `chord` mm of it; along curved
/// borders neighbouring chords turn by at most 10°.
void triangulate(const TopoDS_Shape& shape, double chord);

}  // namespace planish::brep
