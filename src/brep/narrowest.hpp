#pragma once

#include "assembly.hpp"

namespace planish::brep {

/// What passes right through an opening between two planes, seen along the normal of `plane`, the
/// reference skin's: a clockwise loop on that plane (math.md#narrowest-section). Walls that look
/// towards either skin are parted by the closed chain of edges that encloses least; where a wall is
/// round and bulges beyond its edges, the section follows the bulge. Borders keep their edge and
/// its depth where it lies level, and have no edge elsewhere. Empty where there is no such chain or
/// it runs over a wall that slants from skin to skin.
std::optional<BorderLoop> narrowest_section(const Recognition& of, const RimPart& part,
                                            const Frame& plane);

/// The narrowest of the cylinders upright to the plane that walls of an opening go all round, or at
/// least a part of the way round as those of a modelled thread do: a clockwise circle. Empty where
/// there is none, or walls reach into it.
std::optional<BorderLoop> round_core(const Recognition& of, const RimPart& part,
                                     const Frame& plane);

/// How far the walls of an opening reach into a section of it, seen along the normal of `plane`,
/// mm. Looked for at the ends of all edges and at points between.
double intrusion_into(const Recognition& of, const RimPart& part, const Frame& plane,
                      const BorderLoop& section);

/// How far faces reach beyond an outline, seen along the normal of `plane`, mm, and where. Looked
/// for at the same points.
struct Reach {
  double beyond = 0.0;
  Vec2 at = Vec2::Zero();
};
Reach reach_beyond(const Recognition& of, const std::vector<int>& faces, const Frame& plane,
                   const BorderLoop& outline);

/// A border of a plane skin, the material on its left, moved outwards to where the round wall below
/// it bulges farthest: a cylinder along the border, or a torus about the middle of its arc. Empty
/// where the wall does not bulge between its edges.
std::optional<Border> bulge_below(const Recognition& of, int wall, const Frame& plane,
                                  const Border& border);
/// The same of each border of a loop that has an edge with such a wall; straight ones that are
/// moved meet in their corners.
BorderLoop with_bulges(const Recognition& of, const Frame& plane, BorderLoop loop);

}  // namespace planish::brep
