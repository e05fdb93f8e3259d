#pragma once

#include <planish/geometry/mesh.hpp>

#include <array>
#include <vector>

namespace planish {

/// A place that lies within a closed surface twice.
struct SelfIntersection {
  std::array<int, 2> faces{};  ///< that meet there, the smaller number first; may be equal
  double depth = 0.0;          ///< diameter of the largest ball that lies there twice, mm
  Vec3 centre = Vec3::Zero();  ///< of that ball
};

/// Where the surface of one solid, or of several, runs through itself
/// (math.md#self-intersection): for each pair of faces that do so, the largest ball of at least
/// `depth` mm that was found within the surface twice. Faces that touch, and surfaces that enclose
/// everything once, give nothing. At most 500 pairs are returned. `depth` must cover what the
/// triangles deviate from the surface. Requires depth > 0 and a closed surface; points need not be
/// shared, gaps far below `depth` do no harm. Only what begins within one of `places` is looked
/// for, or everything if there are none. Cost: near-linear in the triangles where few of them are
/// near one another.
std::vector<SelfIntersection> find_self_intersections(const MeshOfFaces& surface, double depth,
                                                      const std::vector<Box3>& places = {});

}  // namespace planish
