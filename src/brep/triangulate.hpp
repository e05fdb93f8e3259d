#pragma once

#include <planish/base/angle.hpp>
#include <planish/geometry/mesh.hpp>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace planish::brep {

/// Has the kernel store triangles in every face of the shape, within `chord` mm of it; along curved
/// borders neighbouring chords turn by at most `turn`.
void triangulate(const TopoDS_Shape& shape, double chord, Angle turn = Angle::degrees(10));

/// Appends the triangles that the kernel stores in a face, under this number; none if it made none.
void append_triangles(MeshOfFaces& to, const TopoDS_Face& face, int number);

}  // namespace planish::brep
