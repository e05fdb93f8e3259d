#pragma once

#include <planish/geometry/mesh.hpp>

#include <array>

namespace planish::collision_detail {

/// A triangle of a mesh, with what tests of it need.
struct Triangle {
  std::array<Vec3, 3> corners;
  Vec3 normal;  ///< unit, outward; zero for a triangle without area
};

inline Triangle triangle_of(const Mesh& mesh, int number) {
  const auto& c = mesh.triangles[number];
  const std::array<Vec3, 3> p{mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  const Vec3 twice_area = (p[1] - p[0]).cross(p[2] - p[0]);
  const double size = twice_area.norm();
  return {p, size > 0.0 ? Vec3(twice_area / size) : Vec3(Vec3::Zero())};
}

}  // namespace planish::collision_detail
