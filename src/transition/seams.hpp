#pragma once

#include "ring.hpp"

#include <planish/base/tolerance.hpp>

#include <optional>
#include <vector>

namespace planish::transition_detail {

/// Parts whose normals differ by less (rad) join smoothly: planes and their neighbours agree to a
/// few 1e-9.
inline constexpr double kNoFold = 100.0 * tolerance::kComputed;

/// A ruling at which the ring is cut: in a patch, from 0 (its start) up to but not including 1.
struct Cut {
  int patch = 0;
  double at = 0.0;
  friend auto operator<=>(const Cut&, const Cut&) = default;
};

/// The cuts for a seam and a number of pieces, ascending. Errors: `unknown_seam`.
Result<std::vector<Cut>> cuts_of(const Ring& ring, const std::optional<Seam>& seam,
                                 Division pieces);

/// A ring whose only patch is closed, starting at another ruling.
Ring begun_at(const Ring& ring, double at, double tolerance);

/// A stretch of patches between two cuts.
struct PatchPart {
  int patch = 0;
  double from = 0.0, to = 1.0;
};
std::vector<PatchPart> parts_between(const Ring& ring, const Cut& begin, const Cut& end);

/// The angle (rad) by which the sheet is folded sharply between two consecutive parts; 0 if they
/// join smoothly.
double fold_between(const Ring& ring, const PatchPart& before, const PatchPart& after);

/// Takes 0.005 mm off both ends of parts that close into a ring. Returns the area removed.
double open_seam(const Ring& ring, std::vector<PatchPart>& parts);

}  // namespace planish::transition_detail
