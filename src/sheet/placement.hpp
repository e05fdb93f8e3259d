#pragma once

#include <planish/sheet/layout.hpp>
#include <planish/sheet/topology.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish::sheet_detail {

/// The placement of the faces, and the joints over which they were placed.
struct Placed {
  IdVector<FaceId, Isometry2> placement;
  std::vector<int> tree;
};

/// Which joints a tree takes first: the higher one, compared number by number. Empty: none of it.
using JointRank = std::optional<std::array<double, 3>>;

/// Longer joints, which determine a placement best, before shorter ones.
std::vector<JointRank> longest_first(const Sheet& sheet);
/// Distance of the ends of a joint in space, mm.
double joint_length(const Sheet& sheet, const Joint& joint);

/// Grows a tree from `layout.root` over the joints of highest rank first. Reads the root,
/// allowances and developments of the layout. Error: `not_a_sheet` (a face that no joint leads to).
Result<Placed> placed_over(const std::vector<JointRank>& ranks, const Sheet& sheet,
                           const Topology& topology, const Layout& layout);

/// How far the borders of a joint lie from their proper position relative to each other, mm. Reads
/// developments, allowances and placements of the layout.
double mismatch(const Sheet& sheet, const Layout& layout, const Joint& joint);

/// The same with the joint's second face placed at its first one: more than 0 where they cannot be
/// joined flat whatever lies around them, as along a curved fold. Moves both.
double own_mismatch(const Sheet& sheet, Layout& layout, const Joint& joint);

}  // namespace planish::sheet_detail
