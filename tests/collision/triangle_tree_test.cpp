#include "triangle_tree.hpp"

#include "collision/solid_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace planish::collision_detail {
namespace {

using planish::test::block;

Box3 box_of_triangle(const Mesh& mesh, int triangle) {
  Box3 box;
  for (const int corner : mesh.triangles[triangle])
    box.extend(mesh.points[corner]);
  return box;
}

bool boxes_near(const Box3& a, const Box3& b, double reach) {
  return ((a.min() - b.max()).array() <= reach).all() &&
         ((b.min() - a.max()).array() <= reach).all();
}

/// Every third triangle of a block, backwards: numbers are those of the mesh, not of the list.
std::vector<int> some_of(const Mesh& mesh) {
  std::vector<int> some;
  for (int t = static_cast<int>(mesh.triangles.size()) - 1; t >= 0; t -= 3)
    some.push_back(t);
  return some;
}

TEST(TriangleTree, NamesTrianglesByTheirNumbersInTheMesh) {
  const Mesh mesh = block({0, 0, 0}, {10, 20, 30}, 4).mesh;
  const std::vector<int> some = some_of(mesh);
  const TriangleTree tree(mesh, some);
  for (const Box3& query :
       {Box3(Vec3(1, 1, 1), Vec3(4, 6, 9)), Box3(Vec3(-1, -1, 8), Vec3(2, 30, 9)),
        Box3(Vec3(50, 50, 50), Vec3(60, 60, 60))}) {
    std::set<int> expected, found;
    for (const int t : some)
      if (boxes_near(box_of_triangle(mesh, t), query, 0.0)) expected.insert(t);
    tree.visit(query, [&](int t) { found.insert(t); });
    EXPECT_EQ(found, expected);
  }
}

TEST(TriangleTree, FindsPairsOfTwoTreesAndWithinOne) {
  const Mesh mesh = block({0, 0, 0}, {10, 20, 30}, 3).mesh;
  const Mesh other = block({9, 18, 5}, {25, 40, 30}, 2).mesh;
  const std::vector<int> some = some_of(mesh), others = some_of(other);
  const TriangleTree tree(mesh, some), second(other, others);
  std::set<std::pair<int, int>> expected, found;
  for (const int a : some)
    for (const int b : others)
      if (boxes_near(box_of_triangle(mesh, a), box_of_triangle(other, b), 0.5))
        expected.emplace(a, b);
  tree.visit_pairs(second, 0.5, [&](int a, int b) { found.emplace(a, b); });
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(expected.empty());
  expected.clear();
  found.clear();
  for (const int a : some)
    for (const int b : some)
      if (a < b && boxes_near(box_of_triangle(mesh, a), box_of_triangle(mesh, b), 0.5))
        expected.emplace(a, b);
  tree.visit_pairs(0.5, [&](int a, int b) { found.insert(std::minmax(a, b)); });
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace planish::collision_detail
