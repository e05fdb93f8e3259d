#include "solid_check.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace planish::test {
namespace {

/// Corners at the origin and on the axes.
Mesh tetrahedron() {
  return {{Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(0, 30, 0), Vec3(0, 0, 40)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

ErrorCode code_of(const Mesh& mesh) {
  const auto text = mesh_solid_step(mesh, "mesh");
  EXPECT_FALSE(text);
  return text ? code::internal : text.error().code;
}

TEST(MeshSolid, IsTheSolidInsideTheMesh) {
  const auto text = mesh_solid_step(tetrahedron(), "mesh");
  ASSERT_TRUE(text) << text.error().message;
  const auto check = brep::check_step_solid(*text);
  ASSERT_TRUE(check) << check.error().message;
  EXPECT_EQ(check->solids, 1);
  EXPECT_TRUE(check->valid);
  EXPECT_TRUE(check->closed);
  EXPECT_EQ(check->planes, 4);
  EXPECT_NEAR(check->volume, 20.0 * 30 * 40 / 6, 1e-6);
  EXPECT_EQ(check->product, "mesh");
}

TEST(MeshSolid, MakesOneFaceOfTrianglesInOnePlane) {
  // A block whose sides are two triangles each, and a tetrahedron beside it.
  Mesh mesh = tetrahedron();
  for (int i = 0; i < 8; ++i)
    mesh.points.emplace_back(100.0 + (i & 1 ? 30 : 0), i & 2 ? 20 : 0, i & 4 ? 10 : 0);
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    mesh.triangles.push_back({4 + a, 4 + b, 4 + c});
    mesh.triangles.push_back({4 + a, 4 + c, 4 + d});
  }
  const auto text = mesh_solid_step(mesh, "two");
  ASSERT_TRUE(text) << text.error().message;
  const auto check = brep::check_step_solid(*text);
  ASSERT_TRUE(check) << check.error().message;
  EXPECT_EQ(check->solids, 2);
  EXPECT_TRUE(check->valid);
  EXPECT_TRUE(check->closed);
  EXPECT_EQ(check->planes, 4 + 6);
  EXPECT_NEAR(check->volume, 4000 + 30 * 20 * 10, 1e-6);
}

TEST(MeshSolid, RefusesWhatIsNotClosed) {
  Mesh open = tetrahedron();
  open.triangles.pop_back();
  EXPECT_EQ(code_of(open), code::invalid_input);
  EXPECT_EQ(code_of(Mesh{}), code::invalid_input);
}

TEST(MeshSolid, RefusesWhatIsInsideOut) {
  Mesh mesh = tetrahedron();
  for (auto& t : mesh.triangles)
    std::swap(t[0], t[1]);
  EXPECT_EQ(code_of(mesh), code::invalid_input);
}

TEST(MeshSolid, RefusesTrianglesThatAreNone) {
  Mesh flat = tetrahedron();
  flat.triangles.push_back({0, 1, 1});
  EXPECT_EQ(code_of(flat), code::invalid_input);
  Mesh beyond = tetrahedron();
  beyond.triangles.push_back({0, 1, 4});
  EXPECT_EQ(code_of(beyond), code::invalid_input);
}

}  // namespace
}  // namespace planish::test
