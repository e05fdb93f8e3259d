#pragma once

#include "assembly.hpp"

namespace planish::brep {

// Outlines of openings over a tangent line, on a plane and on the cylinder beside it.

/// The edges of a loop along a part of the rim, if they follow each other.
std::optional<LoopRun> run_along(const Recognition& of, int part, const LoopRef& ref);

/// The outline of a part of the rim on these loops of one skin: a loop of a plane, or runs of a
/// plane and of the cylinder beside it.
std::optional<SkinOutline> outline_on(const Recognition& of, int part,
                                      const std::vector<LoopRef>& loops);

/// That on a skin of a part beside a bend, if it leaves the plane nowhere: it ends at the tangent
/// line.
std::optional<SkinOutline> outline_beside_bend(const Recognition& of, int part, Skin skin);

/// The edges of a run, as its face runs along them; where one begins, or ends (`after`).
std::vector<CoEdge> uses_of(const Recognition& of, const LoopRun& run);
Vec3 point_of(const Recognition& of, const CoEdge& use, bool after);

/// The cylinder of a face; null for others.
const Cylinder* cylinder_of(const Recognition& of, int face);

/// Half-way between the skins, the radius of the bend beside an opening.
double middle_radius(const Recognition& of, const SkinOutline& outline);

/// A flange and the bend beside it: x across the tangent line, above 0 over the bend, z the outward
/// normal of the reference skin.
Frame across_tangent(const Recognition& of, const Frame& plane, const SkinOutline& outline);

/// An outline on a skin as it is seen along the normal of a plane, clockwise.
BorderLoop seen_outline(const Recognition& of, const SkinOutline& outline, const Frame& plane,
                        Skin skin);

}  // namespace planish::brep
