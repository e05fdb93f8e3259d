#pragma once

#include "box_tree.hpp"

namespace planish::collision_detail {

/// Convex blocks, each the hull of its corners, in a tree of boxes.
class BlockTree {
 public:
  explicit BlockTree(std::vector<std::vector<Vec3>> blocks);

  /// A box that holds all places where blocks of both intersect; empty if none do.
  Box3 meetings(const BlockTree& other) const;
  /// The same within one, for blocks that are not next to each other in its list.
  Box3 own_meetings() const;

 private:
  std::vector<std::vector<Vec3>> blocks_;
  BoxTree tree_;
};

}  // namespace planish::collision_detail
