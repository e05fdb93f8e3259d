#pragma once

#include "plate_plane.hpp"

#include <planish/connect/connect.hpp>

#include <optional>
#include <vector>

namespace planish::connect_detail {

/// How the planes of two plates lie to each other.
enum class PlanePair { crossing, parallel, coplanar };
PlanePair plane_pair(const PlacedPlate& a, const PlacedPlate& b, double planarity);

/// How far plates miss lying in one plane, where that is less than a degree and `thickness`; else
/// empty.
struct NearlyCoplanar {
  Angle angle;       ///< between their planes
  double off = 0.0;  ///< largest distance of a corner from the other's plane, mm
};
std::optional<NearlyCoplanar> nearly_coplanar(const PlacedPlate& a, const PlacedPlate& b,
                                              double thickness);

/// Whether the line in which the planes of two plates meet runs between the plates, or along their
/// edges.
bool runs_between(const PlacedPlate& a, const PlacedPlate& b);

/// Axes of the bends that two plates can have (math.md#bend-frame). Crossing planes: one for each
/// combination of sides of the intersection line on which the plates have corners (one, unless a
/// plate crosses the line); the origin is the point of the line nearest to the middle of both
/// plates. Parallel planes: one for each direction of an edge and each way to look from it.
std::vector<BendFrame> bend_frames(const PlacedPlate& a, const PlacedPlate& b, PlanePair kind);

/// The outline in (x, y) of a side.
std::vector<Vec2> side_outline(const PlacedPlate& plate, const BendFrame& frame, int side);
/// The same of one ring of the plate.
std::vector<Vec2> side_ring(const PlacedPlate& plate, int ring, const BendFrame& frame, int side);

/// The chains of the outline and of all holes, with the plate's numbers of the edges.
std::vector<Chain> side_chains(const PlacedPlate& plate, const BendFrame& frame, int side);

}  // namespace planish::connect_detail
