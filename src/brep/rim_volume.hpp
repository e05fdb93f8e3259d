#pragma once

#include "features.hpp"

#include <set>

namespace planish::brep {

/// Parts of the rim with the loops of both skins along them and along the joints beside them, until
/// all of these close: the outline of a bent sheet with the windows over its bends, or one opening.
struct ClosedRim {
  std::set<int> parts;
  std::set<LoopRef> loops;
};
/// Of all these parts. Empty where an edge has no other side.
std::optional<ClosedRim> closed_rim(const Recognition& of, const std::set<int>& parts);

/// Adds what chamfered and rounded rims have beyond walls normal to the sheet along what is cut
/// (negative), each once. `widened`: parts of the rim along which the cut is wider than the
/// reference skin; `far`: those chamfered at the other skin, which are left out if their volume is
/// not known. Returns all parts that are measured so.
std::set<int> add_rim_volumes(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                              const std::set<int>& widened, const std::set<int>& far);

}  // namespace planish::brep
