#pragma once

#include "box_tree.hpp"

namespace planish::collision_detail {

/// A tree of boxes about some triangles of a mesh. Triangles are named by their numbers there.
class TriangleTree {
 public:
  TriangleTree(const Mesh& mesh, std::vector<int> triangles);

  /// Calls `found(triangle)` for every triangle whose box meets `box`.
  void visit(const Box3& box, const std::function<void(int)>& found) const;

  /// Calls `found(own, other's)` for every two triangles whose boxes are at most `reach` apart.
  void visit_pairs(const TriangleTree& other, double reach,
                   const std::function<void(int, int)>& found) const;
  /// The same for the pairs within this tree, each once.
  void visit_pairs(double reach, const std::function<void(int, int)>& found) const;

 private:
  std::vector<int> triangles_;
  BoxTree tree_;
};

}  // namespace planish::collision_detail
