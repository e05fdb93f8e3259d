#include "solid_check.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

/// Corners at the origin and on the axes.
Mesh tetrahedron() {
  return {{Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(0, 30, 0), Vec3(0, 0, 40)}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

ErrorCode code_of(const Mesh& mesh) {
  const auto text = mesh_solid_step(mesh, "mesh");
  EXPECT_FALSE(text);
  return text ? ErrorCode::internal : text.error().code;
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
  EXPECT_NEAR(check->volume, 20.0 * 30 * 40 / 6, 1e-9);
  EXPECT_EQ(check->product, "mesh");
}

TEST(MeshSolid, RefusesWhatIsNotClosed) {
  Mesh open = tetrahedron();
  open.triangles.pop_back();
  EXPECT_EQ(code_of(open), ErrorCode::invalid_input);
  EXPECT_EQ(code_of({}), ErrorCode::invalid_input);
}

TEST(MeshSolid, RefusesWhatIsInsideOut) {
  Mesh mesh = tetrahedron();
  for (auto& t : mesh.triangles)
    std::swap(t[0], t[1]);
  EXPECT_EQ(code_of(mesh), ErrorCode::invalid_input);
}

TEST(MeshSolid, RefusesTrianglesThatAreNone) {
  Mesh flat = tetrahedron();
  flat.triangles.push_back({0, 1, 1});
  EXPECT_EQ(code_of(flat), ErrorCode::invalid_input);
  Mesh beyond = tetrahedron();
  beyond.triangles.push_back({0, 1, 4});
  EXPECT_EQ(code_of(beyond), ErrorCode::invalid_input);
}

}  // namespace
}  // namespace planish::test
