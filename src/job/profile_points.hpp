#pragma once

#include <planish/geometry/mesh.hpp>
#include <planish/transition/profile.hpp>

#include <vector>

namespace planish::job {

/// A profile as a closed polyline in space, the last point not repeated, with 96 points per full
/// turn of curves. Splines come from the border of the surface's mesh in their plane; without a
/// mesh, only their given points.
std::vector<Vec3> profile_points(const PlacedProfile& profile, const Mesh& mesh);

}  // namespace planish::job
