// Boxes in a balanced tree, halved along the longer side of their centres, so that what meets a box
// is found without a look at the others. The tree is full except in its last level and needs no
// pointers.

#include <planish/geometry/box_tree.hpp>

#include <algorithm>

namespace planish {

BoxTree2::BoxTree2(std::vector<Box2> boxes) : boxes_(std::move(boxes)) {
  for (size_t i = 0; i < boxes_.size(); ++i)
    if (!boxes_[i].empty()) ids_.push_back(i);
  if (ids_.empty()) return;
  // Halving makes a tree that is full except in its last level.
  size_t nodes = 1;
  for (size_t size = ids_.size(); size > kLeaf; size = (size + 1) / 2)
    nodes = 2 * nodes + 1;
  nodes_.resize(nodes);
  build(0, 0, ids_.size());
}

void BoxTree2::build(size_t node, size_t from, size_t to) {
  for (size_t i = from; i < to; ++i)
    nodes_[node].add(boxes_[ids_[i]]);
  if (to - from <= kLeaf) return;
  const Vec2 size = nodes_[node].size();
  const int axis = size.y() > size.x() ? 1 : 0;
  const size_t middle = from + (to - from) / 2;
  const auto at = [this](size_t i) { return ids_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(middle), at(to), [&](size_t a, size_t b) {
    return boxes_[a].lo[axis] + boxes_[a].hi[axis] < boxes_[b].lo[axis] + boxes_[b].hi[axis];
  });
  build(2 * node + 1, from, middle);
  build(2 * node + 2, middle, to);
}

}  // namespace planish
