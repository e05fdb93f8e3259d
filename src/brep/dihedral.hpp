#pragma once

#include "solid_model.hpp"

#include <optional>

namespace planish::brep {

/// A smaller dihedral angle beside a bend is a tangent transition, radians (5°): CAD systems keep
/// tangency to 0.1°, but radii rounded by hand leave a few degrees.
inline constexpr double kSmoothAngle = 0.0873;

/// Angle in space between the outward normals of the two faces of an edge, at its middle; negative
/// where the solid is concave there. Empty for seams, open edges and doubly curved neighbours.
std::optional<double> dihedral(const SolidModel& model, int edge);

/// Whether the faces of an edge continue each other: tangent, and parallel when both are planes.
bool smooth_edge(const SolidModel& model, int edge);

}  // namespace planish::brep
