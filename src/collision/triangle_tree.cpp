#include "triangle_tree.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>
#include <fcl/narrowphase/detail/traversal/collision/bvh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include <utility>

namespace planish::collision_detail {
namespace {

using Model = fcl::BVHModel<fcl::AABBd>;

bool apart(const fcl::AABBd& a, const fcl::AABBd& b, double reach) {
  return ((a.min_ - b.max_).cwiseMax(b.min_ - a.max_).array() > reach).any();
}

/// Passes on which leaves are near each other; which of them meet, and how deep, is not FCL's to
/// decide.
class NearLeaves : public fcl::detail::BVHCollisionTraversalNode<fcl::AABBd> {
 public:
  NearLeaves(const Model& a, const Model& b, double reach,
             const std::function<void(int, int)>& found)
      : reach_(reach), found_(found) {
    model1 = &a;
    model2 = &b;
  }
  bool BVTesting(int a, int b) const override {
    return apart(model1->getBV(a).bv, model2->getBV(b).bv, reach_);
  }
  void leafTesting(int a, int b) const override {
    found_(model1->getBV(a).primitiveId(), model2->getBV(b).primitiveId());
  }
  bool canStop() const override { return false; }

 private:
  double reach_;
  const std::function<void(int, int)>& found_;
};

void visit_below(const Model& model, int node, const fcl::AABBd& box,
                 const std::function<void(int)>& found) {
  const auto& at = model.getBV(node);
  if (!at.bv.overlap(box)) return;
  if (at.isLeaf()) {
    found(at.primitiveId());
    return;
  }
  visit_below(model, at.leftChild(), box, found);
  visit_below(model, at.rightChild(), box, found);
}

}  // namespace

struct TriangleTree::Model {
  fcl::BVHModel<fcl::AABBd> tree;
  std::vector<int> triangles;
};

TriangleTree::TriangleTree(const Mesh& mesh, std::vector<int> triangles)
    : model_(std::make_unique<Model>()) {
  model_->triangles = std::move(triangles);
  const int count = static_cast<int>(model_->triangles.size());
  model_->tree.beginModel(count, 3 * count);
  for (const int t : model_->triangles) {
    const auto& corners = mesh.triangles[t];
    model_->tree.addTriangle(mesh.points[corners[0]], mesh.points[corners[1]],
                             mesh.points[corners[2]]);
  }
  model_->tree.endModel();
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

void TriangleTree::visit(const Box3& box, const std::function<void(int)>& found) const {
  if (model_->triangles.empty()) return;
  visit_below(model_->tree, 0, fcl::AABBd(box.min(), box.max()),
              [&](int leaf) { found(model_->triangles[leaf]); });
}

void TriangleTree::visit_pairs(const TriangleTree& other, double reach,
                               const std::function<void(int, int)>& found) const {
  if (model_->triangles.empty() || other.model_->triangles.empty()) return;
  const std::function<void(int, int)> named = [&](int a, int b) {
    found(model_->triangles[a], other.model_->triangles[b]);
  };
  NearLeaves node(model_->tree, other.model_->tree, reach, named);
  fcl::detail::collide<double>(&node);
}

void TriangleTree::visit_pairs(double reach, const std::function<void(int, int)>& found) const {
  if (model_->triangles.empty()) return;
  const std::function<void(int, int)> named = [&](int a, int b) {
    found(model_->triangles[a], model_->triangles[b]);
  };
  NearLeaves node(model_->tree, model_->tree, reach, named);
  fcl::detail::selfCollide<double>(&node);
}

}  // namespace planish::collision_detail
