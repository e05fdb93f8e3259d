#include "surface_mesh.hpp"

#include "sample_rings.hpp"
#include "support/closed_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace planish::test {
namespace {

using namespace transition_detail;

double area_of(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  return area;
}

/// Sides that only one triangle has, each along one of two level profiles.
int free_sides(const Mesh& mesh) {
  const auto runs = sides_of(mesh);
  int free = 0;
  for (const auto& [side, times] : runs) {
    EXPECT_EQ(times, 1) << "a side is run twice the same way";
    if (runs.count({side.second, side.first}) != 0) continue;
    ++free;
    EXPECT_NEAR(mesh.points[side.first].z(), mesh.points[side.second].z(), 1e-9);
  }
  return free;
}

TEST(SurfaceMesh, OfPlanesIsTheirTriangles) {
  const Mesh squares = surface_mesh(pyramid(), 0.05);
  EXPECT_EQ(squares.triangles.size(), 8u);
  EXPECT_EQ(squares.points.size(), 8u);
  EXPECT_NEAR(area_of(squares), 4 * 80 * std::hypot(80, 20), 1e-8);
  EXPECT_EQ(surface_mesh(antiprism(), 0.05).triangles.size(), 8u);
}

TEST(SurfaceMesh, IsOpenAtBothProfilesAndNowhereElse) {
  for (const Ring& ring : {frustum(), square_to_circle(), pyramid(), antiprism()}) {
    const Mesh mesh = surface_mesh(ring, 0.05);
    std::set<int> used;
    for (const auto& triangle : mesh.triangles)
      used.insert(triangle.begin(), triangle.end());
    EXPECT_EQ(used.size(), mesh.points.size());
    const int sides = static_cast<int>(sides_of(mesh).size());
    const int free = free_sides(mesh), faces = static_cast<int>(mesh.triangles.size());
    EXPECT_EQ(static_cast<int>(used.size()) - (sides + free) / 2 + faces, 0) << "Euler: a ring";
  }
}

TEST(SurfaceMesh, LeavesTheSurfaceByTheChordAtMost) {
  for (const double chord : {1.0, 0.1, 0.01}) {
    const Mesh mesh = surface_mesh(frustum(), chord);
    double deepest = 0.0;
    for (const auto& triangle : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 middle = 0.5 * (mesh.points[triangle[i]] + mesh.points[triangle[(i + 1) % 3]]);
        const double radius = 50 - 30 * middle.z() / 80;
        deepest = std::max(deepest, radius - middle.head<2>().norm());
      }
    EXPECT_LT(deepest, 1.3 * chord);
    EXPECT_GT(deepest, 0.2 * chord) << "no finer than needed";
  }
}

TEST(SurfaceMesh, FacesOutwards) {
  for (const Ring& ring : {frustum(), square_to_circle(), antiprism()}) {
    const Mesh mesh = surface_mesh(ring, 0.5);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 n = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
      EXPECT_GT(n.dot(mesh.points[a]), 0.0);
    }
  }
}

}  // namespace
}  // namespace planish::test
