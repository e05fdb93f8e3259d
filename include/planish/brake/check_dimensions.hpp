#pragma once

#include <planish/brake/plan.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <vector>

namespace planish {

/// What a caliper shows once a stroke is made.
struct CheckDimension {
  FlangeId flange{};
  double length = 0.0;  ///< mm
};

/// Of each stroke, in order, the shorter side of the bend, as a caliper measures it: from the
/// outside of the bend to the far edge, or to the outside of the bend there (bend.md#check). Bends
/// that are not formed yet are flat, the others have the radius that their stroke makes, for which
/// `laid` says what it takes of the sheet. Empty where no side ends along the bend line, of a
/// stroke that leaves its bend unfinished, and of a sheet without faces. Requires the layout of the
/// sheet, and the pattern of that layout.
std::vector<std::optional<CheckDimension>> check_dimensions(const Sheet& sheet,
                                                            const Layout& layout,
                                                            const FlatPattern& pattern,
                                                            const std::vector<Stroke>& strokes,
                                                            const FlattenOptions& laid = {});

}  // namespace planish
