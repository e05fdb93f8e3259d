#pragma once

#include <planish/geometry/mesh.hpp>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace planish::collision_detail {

/// A tree of boxes, named by their numbers in the list it is made of.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box3> boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  const Box3& box(int number) const;

  /// Calls `found(number)` for every box that meets `query`.
  void visit(const Box3& query, const std::function<void(int)>& found) const;
  /// Calls `found(own, other's)` for every two boxes that are at most `reach` apart along each
  /// axis.
  void visit_pairs(const BoxTree& other, double reach,
                   const std::function<void(int, int)>& found) const;
  /// The same for the pairs within this tree, each once, the smaller number first.
  void visit_pairs(double reach, const std::function<void(int, int)>& found) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};

/// Every two boxes that are at most `reach` apart along each axis, by their numbers, in order.
std::vector<std::pair<int, int>> near_boxes(std::vector<Box3> boxes, double reach);

}  // namespace planish::collision_detail
