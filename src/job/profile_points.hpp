#pragma once

#include <planish/geometry/mesh.hpp>
#include <planish/transition/profile.hpp>

#include <vector>

namespace planish::job {

/// A profile as a closed polyline in space, the last point not repeated, with 96 points on what is
/// curved. Splines are taken from the border of the surface's mesh that lies in their plane;
/// without a mesh, their points alone.
std::vector<Vec3> profile_points(const PlacedProfile& profile, const Mesh& mesh);

}  // namespace planish::job
