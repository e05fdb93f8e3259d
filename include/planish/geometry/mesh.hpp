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

}  // namespace planish
