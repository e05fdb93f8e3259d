#pragma once

#include <planish/sheet/sheet.hpp>

namespace planish::test {

/// Border trihedron of a face (math.md#border-trihedron): origin at the border's start, x along the
/// border, y into the face, z outward from the reference skin.
Frame border_trihedron(const Sheet& sheet, const BorderRef& border);

/// Rigid motion that unfolds a child flange about one cylindrical bend into its parent's plane.
/// `parent` and `child` are the trihedra of the two flanges at the bend's tangent lines, borders
/// run in opposite directions; `turn` is the bend angle, positive where the child is folded towards
/// the parent's outward normal; `allowance` in mm.
///
/// As elementary transforms, T = TC · R · TR: the child is moved until the edges meet, turned about
/// x by the bend angle, moved off by the allowance [part 4].
Eigen::Isometry3d unfolding_by_steps(const Frame& parent, const Frame& child, Angle turn,
                                     double allowance);

/// The same motion from the trihedra alone: the child's trihedron goes onto the image that the
/// bend's development gives it, opposite to the parent's, one allowance off.
Eigen::Isometry3d unfolding_by_trihedra(const Frame& parent, const Frame& child,
                                        double border_length, double allowance);

}  // namespace planish::test
