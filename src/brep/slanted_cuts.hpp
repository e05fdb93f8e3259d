#pragma once

#include "features.hpp"

namespace planish::brep {

/// Whether a wall of the part along this loop of a skin leans back from it and ends within the
/// sheet: of a chamfer, a fillet, a countersink.
bool is_chamfered(const Recognition& of, const RimPart& part, const LoopRef& ref);

/// Notes cuts along the outer contour, or through bends, that are not normal to the sheet: saw
/// cuts, mitres. The blank keeps the reference skin's outline there; the feature names the borders,
/// and the sheet gets the volume by which the solid differs from it, from the areas of both skins.
/// Nothing is noted of sheets with chamfered rims or sharp bends, whose skins differ otherwise.
/// `measured`: parts of the rim whose volume counts already.
void add_slanted_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                      const std::set<int>& measured);

}  // namespace planish::brep
