#pragma once

#include <planish/geometry/mesh.hpp>

namespace planish {

/// Of a closed mesh, mm³; negative if its corners run clockwise seen from outside. 0 without
/// triangles. Relative to a point of it, so that no digits are lost far from the origin.
double volume_of(const Mesh& mesh);

}  // namespace planish
