#pragma once

#include "solid_model.hpp"

#include <planish/sheet/sheet.hpp>

namespace planish::brep {

/// Borders of a face loop in the (u, v) of a surface (the face's own or its substitute): straight
/// and circular edges exactly where the surface allows, others fitted within `tolerance` (mm on the
/// surface). u runs continuously along the loop, starting near `u_near`.
BorderLoop read_borders(const SolidModel& model, const std::vector<CoEdge>& loop,
                        const SolidSurface& surface, double u_near, double tolerance);

/// The depth of an edge below a plane, against its normal, mm; empty where it is not level within
/// `tolerance`, as its ends and its middle tell.
std::optional<double> level_depth(const SpaceCurve& edge, const Frame& plane, double tolerance);

/// The curve moved along u.
Curve2 shifted_u(const Curve2& curve, double by);

}  // namespace planish::brep
