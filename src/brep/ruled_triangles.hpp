#pragma once

#include <planish/geometry/mesh.hpp>

#include <TopoDS_Face.hxx>

namespace planish::brep {

/// Whether the face lies on a B-spline that joins two rails by straight rulings, v along them, as
/// the general developables and the curved walls of made sheets do.
bool joins_rails(const TopoDS_Face& face);

/// Appends triangles of such a face under this number, none wider than a strip between two rulings:
/// within `chord` mm of the face, with points of their own along its borders. Requires parameter
/// curves and chord > 0. Cost: proportional to the strips and to what borders cross them.
void append_ruled_triangles(MeshOfFaces& to, const TopoDS_Face& face, int number, double chord);

}  // namespace planish::brep
