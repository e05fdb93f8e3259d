#pragma once

#include "seams.hpp"

#include <planish/geometry/mesh.hpp>

namespace planish::transition_detail {

/// Triangles of all patches of a closed ring.
Mesh surface_mesh(const Ring& ring, double chord);

}  // namespace planish::transition_detail
