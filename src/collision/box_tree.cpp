#include "box_tree.hpp"

#include <Eigen/Core>
#include <unsupported/Eigen/BVH>

#include <algorithm>
#include <numeric>

// Which boxes meet, of one list or two, by Eigen's hierarchy of bounding volumes. A pair is near if
// the boxes are at most `reach` apart along each axis: no pair that is nearer than that is missed,
// some that are farther along a diagonal are reported.

namespace planish::collision_detail {
namespace {

using Tree = Eigen::KdBVH<double, 3, int>;

struct Query {
  const std::vector<Box3>& boxes;
  const Box3& box;
  const std::function<void(int)>& found;

  bool intersectVolume(const Box3& volume) const { return volume.intersects(box); }
  bool intersectObject(int number) const {
    if (boxes[number].intersects(box)) found(number);
    return false;  // go on
  }
};

struct PairQuery {
  const std::vector<Box3>&a, &b;
  double reach;
  const std::function<void(int, int)>& found;

  bool near(const Box3& one, const Box3& other) const {
    return ((one.min() - other.max()).cwiseMax(other.min() - one.max()).array() <= reach).all();
  }
  bool intersectVolumeVolume(const Box3& one, const Box3& other) const { return near(one, other); }
  bool intersectVolumeObject(const Box3& one, int other) const { return near(one, b[other]); }
  bool intersectObjectVolume(int one, const Box3& other) const { return near(a[one], other); }
  bool intersectObjectObject(int one, int other) const {
    if (near(a[one], b[other])) found(one, other);
    return false;  // go on
  }
};

}  // namespace

struct BoxTree::Model {
  std::vector<Box3> boxes;
  Tree tree;
};

BoxTree::BoxTree(std::vector<Box3> boxes) : model_(std::make_unique<Model>()) {
  model_->boxes = std::move(boxes);
  std::vector<int> numbers(model_->boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  model_->tree.init(numbers.begin(), numbers.end(), model_->boxes.begin(), model_->boxes.end());
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

const Box3& BoxTree::box(int number) const { return model_->boxes[number]; }

void BoxTree::visit(const Box3& query, const std::function<void(int)>& found) const {
  if (model_->boxes.empty()) return;
  const Query asked{model_->boxes, query, found};
  Eigen::BVIntersect(model_->tree, asked);
}

void BoxTree::visit_pairs(const BoxTree& other, double reach,
                          const std::function<void(int, int)>& found) const {
  if (model_->boxes.empty() || other.model_->boxes.empty()) return;
  const PairQuery asked{model_->boxes, other.model_->boxes, reach, found};
  Eigen::BVIntersect(model_->tree, other.model_->tree, asked);
}

void BoxTree::visit_pairs(double reach, const std::function<void(int, int)>& found) const {
  visit_pairs(*this, reach, [&](int a, int b) {
    if (a < b) found(a, b);
  });
}

std::vector<std::pair<int, int>> near_boxes(std::vector<Box3> boxes, double reach) {
  std::vector<std::pair<int, int>> pairs;
  BoxTree(std::move(boxes)).visit_pairs(reach, [&](int a, int b) { pairs.emplace_back(a, b); });
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace planish::collision_detail
