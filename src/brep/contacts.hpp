#pragma once

#include "features.hpp"

#include <optional>

namespace planish::brep {

/// Refuses what stands out from one skin across a joint, such as a gusset: it is another body,
/// which no bend makes of the sheet. Forms are on both skins.
std::optional<Error> standing_across(const Recognition& of);

/// Closed contours of a skin along a part, over all of its faces: fewer than openings where edges
/// touch.
int contours_on(const Recognition& of, const RimPart& part, Skin skin);

/// Whether a recess in planes of the reference skin has more holes in its floor than outlines.
bool has_several_holes(const Recognition& of, const RimPart& part);

/// Adds the walls of cuts that hang together although the sheet is cut between them: edges of the
/// sheet that touch, so that the solid has an opening there which no cut makes. All contours along
/// such walls are cut, and the other skin has no more of them, so none has been lost.
void add_contacts(SheetBuilder& builder, const SheetMap& map, const Recognition& of);

}  // namespace planish::brep
