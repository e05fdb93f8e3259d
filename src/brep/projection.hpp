#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// Area of a face as it is seen along the normal of the plane: positive where it looks that way,
/// what looks the other way is taken off. By Green's theorem on its projected borders.
double projected_area(const SolidModel& model, int face, const Frame& plane);

/// The volume between a face and the plane, mm³: the height of its points over the plane times that
/// area. By Stokes' theorem on its borders, as exact as `SolidFace::volume`.
double volume_over(const SolidModel& model, int face, const Frame& plane);

}  // namespace planish::brep
