#pragma once

#include <planish/geometry/mesh.hpp>

#include <utility>
#include <vector>

namespace planish {

/// Of a closed mesh, mm³; negative if its corners run clockwise seen from outside. 0 without
/// triangles. Relative to a point of it, so that no digits are lost far from the origin.
double volume_of(const Mesh& mesh);

/// Sides of triangles that do not have exactly one neighbour running them the other way, in the
/// order of their corners; none of a closed mesh.
std::vector<std::pair<int, int>> open_sides(const Mesh& mesh);

}  // namespace planish
