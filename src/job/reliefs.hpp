#pragma once

#include <planish/inspect/double_cover.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/job/request.hpp>
#include <planish/sheet/layout.hpp>

namespace planish::job {

/// A pattern with what had to be cut away.
struct Relieved {
  FlatPattern pattern;
  double removed = 0.0;  ///< area of the sheet's faces that was cut away, mm²
  int mended = 0;        ///< places that were covered twice
  std::vector<Finding> findings;
  std::vector<Loop> cutouts;  ///< outlines of what was cut out; they may overlap
};

/// Cuts reliefs where the pattern covers itself, and draws slits that run there and back along a
/// contour once, or rips them if they have a width (math.md#reliefs); beside bends, those that the
/// rules ask for, if wanted. `covers`: those of the pattern. Errors: `overlap`, if a place is too
/// large to be mended; those of `without_cutout`; `pattern_wrong`, if the area cut away is not what
/// lies within the reliefs; `bad_option`, if a rip takes the whole line of a bend.
Result<Relieved> with_reliefs(const Sheet& sheet, const Layout& layout, const FlatPattern& pattern,
                              const std::vector<DoubleCover>& covers, const ReliefOptions& options,
                              const Rules& rules);

}  // namespace planish::job
