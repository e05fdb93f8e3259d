#pragma once

#include "solid_model.hpp"

#include <TopoDS_Solid.hxx>

namespace planish::brep {

/// Reads a kernel solid into a SolidModel. Surfaces of any kind become planes, cylinders, cones or
/// general developables when they are within `surface_tolerance` (mm) of one; the model is healed.
SolidModel read_solid(const TopoDS_Solid& solid, double surface_tolerance);

}  // namespace planish::brep
