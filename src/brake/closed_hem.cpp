// A hem as it lies when it is closed: the smaller side is the return, turned on by the rest of the
// angle about the tangent line of the other, which stays (math.md#closing-hems).
#include "closed_hem.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>

namespace planish::brake_detail {
namespace {

/// In the line's frame, both sides as they are.
Block3 in_line_frame(Block3 block, bool left, const Eigen::Isometry3d& motion) {
  for (auto* ring : {&block.lower, &block.upper})
    for (Vec3& p : *ring) {
      if (!left) p.y() = -p.y();
      p = motion * p;
    }
  return block;
}

/// The smaller side of a hem is its return.
bool is_left_smaller(const Workpiece& work, const PartTree& tree) {
  double left = 0.0, right = 0.0;
  for (const PartTree::Part& part : tree.parts())
    if (!part.is_zone)
      for (const Convex& piece : work.bodies[part.index].pieces)
        (part.left ? left : right) += ring_area(piece);
  return left <= right;
}

}  // namespace

ClosedHem closed_hem(const Workpiece& work, const PartTree& tree, const BrakeLine& line,
                     const std::vector<const PlacedPart*>& open) {
  const bool left_folds = is_left_smaller(work, tree);
  const Eigen::Isometry3d bent = bent_side(line, line.closed);
  const Eigen::Isometry3d stays = Eigen::Isometry3d::Identity(),
                          folds = left_folds ? bent : bent.inverse();
  ClosedHem hem;
  hem.left_folds = left_folds;
  for (std::size_t i = 0; i < tree.parts().size(); ++i) {
    PlacedPart part;
    part.left = true;
    part.flat = open[i]->flat;
    for (const Block3& block : open[i]->blocks)
      part.blocks.push_back(
          in_line_frame(block, open[i]->left, open[i]->left == left_folds ? folds : stays));
    if (tree.parts()[i].is_zone && tree.parts()[i].before < 0)
      for (const Block3& block : tree.closed_zone())
        part.blocks.push_back(in_line_frame(block, true, left_folds ? stays : folds));
    summarise(part);
    hem.parts.push_back(std::move(part));
  }
  const int part_of_return = tree.part_of_body(line.bodies[left_folds ? 1 : 0]);
  const Box2 folded = box_of(hem.parts[static_cast<std::size_t>(part_of_return)].hull);
  hem.middle = 0.5 * (folded.lo.x() + folded.hi.x());
  hem.top = folded.hi.y();
  hem.gap = std::max(0.0, folded.lo.y());
  return hem;
}

}  // namespace planish::brake_detail
