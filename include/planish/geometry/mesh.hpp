#pragma once

#include <planish/geometry/frame.hpp>

#include <array>
#include <vector>

namespace planish {

/// Triangles in space, mm. Corners run counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

using Box3 = Eigen::AlignedBox3d;

/// The surface of a solid as triangles that know their faces: indices from 0, where places and
/// `planish info` count from 1.
struct MeshOfFaces {
  Mesh mesh;
  std::vector<int> face;  ///< by triangle
};

}  // namespace planish
