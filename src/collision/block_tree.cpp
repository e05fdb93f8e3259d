#include "block_tree.hpp"

#include <ccd/ccd.h>

#include <algorithm>
#include <utility>

namespace planish::collision_detail {
namespace {

std::vector<Box3> boxes_of(const std::vector<std::vector<Vec3>>& blocks) {
  std::vector<Box3> boxes(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (const Vec3& corner : blocks[i])
      boxes[i].extend(corner);
  return boxes;
}

/// The farthest corner in a direction: all that libccd asks about a hull.
void farthest_corner(const void* block, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const Eigen::Map<const Vec3> along(direction->v);
  const auto& corners = *static_cast<const std::vector<Vec3>*>(block);
  Eigen::Map<Vec3>(farthest->v) = *std::ranges::max_element(
      corners, {}, [&](const Vec3& corner) { return along.dot(corner); });
}

/// Gilbert, Johnson and Keerthi's algorithm.
bool intersect(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  constexpr int kMostSteps = 500;
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = farthest_corner;
  settings.max_iterations = kMostSteps;
  return ccdGJKIntersect(&a, &b, &settings) != 0;
}

}  // namespace

BlockTree::BlockTree(std::vector<std::vector<Vec3>> blocks)
    : blocks_(std::move(blocks)), tree_(boxes_of(blocks_)) {}

Box3 BlockTree::meetings(const BlockTree& other) const {
  Box3 found;
  tree_.visit_pairs(other.tree_, 0.0, [&](int a, int b) {
    if (intersect(blocks_[a], other.blocks_[b]))
      found.extend(tree_.box(a).intersection(other.tree_.box(b)));
  });
  return found;
}

Box3 BlockTree::own_meetings() const {
  Box3 found;
  tree_.visit_pairs(0.0, [&](int a, int b) {
    if (b - a > 1 && intersect(blocks_[a], blocks_[b]))
      found.extend(tree_.box(a).intersection(tree_.box(b)));
  });
  return found;
}

}  // namespace planish::collision_detail
