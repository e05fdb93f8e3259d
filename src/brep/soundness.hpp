#pragma once

#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace planish::brep {

// What files leave open in a solid, found by looks that cost no more than reading it: nothing is
// projected or intersected.

/// Whether the face is read rightly as it is written: its edges have curves in space and follow
/// each other round each loop; none of its loops runs round a cylinder or cone without a seam; and
/// on other surfaces than planes, cylinders and cones, which are read without, its edges have
/// curves in the surface's parameters that follow each other too.
bool is_readable(const TopoDS_Face& face);

/// Whether every edge of the face has a curve in the surface's parameters, as meshing needs them.
/// On planes the kernel makes them by itself.
bool has_parameter_curves(const TopoDS_Face& face);

/// Whether the curves in the surface's parameters follow each other round each loop as its edges
/// do, no period apart: only then the kernel meshes the face rightly. On planes they do.
bool follows_in_parameters(const TopoDS_Face& face);

/// Whether the shape is a solid of one shell that closes: every edge is run once each way, and all
/// its faces hang together.
bool is_closed_solid(const TopoDS_Shape& shape);

}  // namespace planish::brep
