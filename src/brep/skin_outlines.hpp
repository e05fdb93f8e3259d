#pragma once

#include "features.hpp"

#include <set>

namespace planish::brep {

/// Edges of a loop of a skin, as its face runs along them.
const std::vector<CoEdge>& loop_of(const Recognition& of, const LoopRef& ref);

/// Edges along the faces of a part, each once.
std::set<int> wall_edges(const Recognition& of, const RimPart& part);

/// Mean distances between outlines, mm: below one they are the same, above the other one is wider
/// by more than the noise of drilled holes.
inline constexpr double kSameOutline = 1e-7;
inline constexpr double kWiderOutline = 1e-3;

double perimeter(const BorderLoop& borders);
bool is_wider(const BorderLoop& outline, const BorderLoop& than);

/// Whether a wall reaches this skin.
bool reaches(const Recognition& of, int wall, Skin skin);

/// Whether walls that lead from skin to skin lean both ways from a direction, as those of a hole
/// that is drilled at a slant to it do.
bool is_slanted(const Recognition& of, const RimPart& part, const Vec3& from);

/// Whether the walls along a skin end before they reach the other one, as what is machined does.
bool is_machined(const Recognition& of, const RimPart& part, Skin skin);

/// Whether a face of the other skin lies opposite a plane face of the reference skin, or opposite
/// what grooves cut off from it.
bool lies_opposite(const Recognition& of, int face, int other);

/// Faces across the edges of a face, −1 where an edge has no other side. Beside a ledge, which
/// looks along the normal of a flange from between its skins, those of flanges at an angle do not
/// count: a gap between walls folded sharply ends on the skin of the next one.
std::set<int> faces_along(const Recognition& of, int face, const Frame& flange);

/// A loop of the other skin as seen on this one: reversed, a thickness below.
BorderLoop seen_through(const Recognition& of, const LoopRef& ref, const Frame& plane);

/// Adds a feature on the other skin, drawn in place, seen through the sheet. Only loops of planes
/// that lie under planes are drawn.
void add_far_outline(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                     const char* kind, const RimPart& part, const LoopRef& ref);

}  // namespace planish::brep
