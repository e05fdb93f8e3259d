#pragma once

#include <planish/geometry/mesh.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish {

/// A convex piece of the folded sheet's material: the hull of its corners, mm.
using Block = std::vector<Vec3>;

struct BlockOptions {
  double inset = 0.0;   ///< how far from skins and borders blocks stay, mm
  double chord = 0.01;  ///< largest distance of blocks from curved skins and borders, mm
  std::optional<Box3> within = {};  ///< blocks of a flange that do not meet it may be missing
};

/// Convex blocks of the material of a face, between the skins along their normals, that together
/// hold every ball of radius `inset` within it, reduced to its centre (math.md#self-intersection).
/// What the flange across a sharp bend fills as well, up to the mitre, is left out. Of a bend, each
/// block goes from one ruling to the next, between the lines nearest to the outer loop that leave
/// none of it outside: openings and notches count as material. Empty if nothing remains. Requires
/// chord > 0 and 0 ≤ inset. O(n log n) for n sampled points of the borders.
std::vector<Block> folded_blocks(const Sheet& sheet, FaceId face, const BlockOptions& options);

/// Corners of both skins, on the outer loop: their hull holds the face's material, to within
/// `chord`.
Block hull_of(const Sheet& sheet, FaceId face, double chord);

}  // namespace planish
