#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// Where every face of a sheet goes in the plane, the reference skin facing up.
struct UnfoldingTree {
  std::vector<BendAllowance> allowance;  ///< by bend
  std::vector<Development> development;  ///< by bend; unused rows for sharp bends
  std::vector<double> neutral_offset;    ///< by face, along the surface normal
  std::vector<Isometry2> placement;      ///< by face: developed plane → pattern
  double closure = 0.0;                  ///< mm, worst joint outside the tree

  std::vector<std::vector<Loop>> images;  ///< of all borders in the pattern, by face and loop

  const Curve2& image(const BorderRef& ref) const;
  /// Image of the point of a face with parameters uv.
  Vec2 image(const Sheet& sheet, FaceId face, const Vec2& uv) const;
};

const Border& border_at(const Sheet& sheet, const BorderRef& ref);

/// Grows the tree from the root flange (or bend face) over the longest joints first and checks
/// every joint left out. Errors: see `flatten`.
Result<UnfoldingTree> grow_unfolding_tree(const Sheet& sheet, const FlattenOptions& options);

}  // namespace planish
