#pragma once

#include <planish/sheet/layout.hpp>
#include <planish/sheet/topology.hpp>

namespace planish::sheet_detail {

/// The placement of the faces, and the joints over which they were placed.
struct Placed {
  IdVector<FaceId, Isometry2> placement;
  std::vector<int> tree;
};

/// Grows a tree from `layout.root` over the longest joints first, which determine a placement best.
/// Reads the root, allowances and developments of the layout. Error: `not_a_sheet` (a face that no
/// joint leads to).
Result<Placed> placed_over_longest_joints(const Sheet& sheet, const Topology& topology,
                                          const Layout& layout);

/// How far the borders of a joint lie from their proper position relative to each other, mm. Reads
/// developments, allowances and placements of the layout.
double mismatch(const Sheet& sheet, const Layout& layout, const Joint& joint);

}  // namespace planish::sheet_detail
