#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// The curve as a line or circle if it is of another kind but within `tolerance` (mm) of one;
/// otherwise unchanged. Many systems write straight lines and circles as splines.
SpaceCurve exact_curve(SpaceCurve curve, double tolerance);

}  // namespace planish::brep
