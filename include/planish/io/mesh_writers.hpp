#pragma once

#include <planish/geometry/mesh.hpp>

#include <string>

namespace planish {

/// Binary STL of a mesh, little-endian, coordinates in the mesh's own units (mm) as 32-bit floats:
/// relative accuracy 6e-8. The 80 bytes of the header hold "STL " and as much of `name` as fits: a
/// file that began with "solid" would be taken for text STL. Each facet has the unit normal of its
/// triangle as written, by the right-hand rule; triangles that have no area after rounding to
/// floats are left out. Attribute bytes are zero. Two triangles share a corner in the file if they
/// share it in the mesh. Requires: corner indices within `points`.
std::string stl_binary(const Mesh& mesh, const std::string& name);

/// Wavefront OBJ: points with 10 significant digits in the mesh's own units, triangles as faces,
/// one object called `name` (line breaks and leading blanks removed). Requires: corner numbers
/// within `points`.
std::string obj_text(const Mesh& mesh, const std::string& name);

}  // namespace planish
