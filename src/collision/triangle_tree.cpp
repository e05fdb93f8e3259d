#include "triangle_tree.hpp"

namespace planish::collision_detail {
namespace {

std::vector<Box3> boxes_of(const Mesh& mesh, const std::vector<int>& triangles) {
  std::vector<Box3> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const int corner : mesh.triangles[triangles[i]])
      boxes[i].extend(mesh.points[corner]);
  return boxes;
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh, std::vector<int> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(mesh, triangles_)) {}

void TriangleTree::visit(const Box3& box, const std::function<void(int)>& found) const {
  tree_.visit(box, [&](int i) { found(triangles_[i]); });
}

void TriangleTree::visit_pairs(const TriangleTree& other, double reach,
                               const std::function<void(int, int)>& found) const {
  tree_.visit_pairs(other.tree_, reach,
                    [&](int a, int b) { found(triangles_[a], other.triangles_[b]); });
}

void TriangleTree::visit_pairs(double reach, const std::function<void(int, int)>& found) const {
  tree_.visit_pairs(reach, [&](int a, int b) { found(triangles_[a], triangles_[b]); });
}

}  // namespace planish::collision_detail
