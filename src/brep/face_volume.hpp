#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// ⅓∫(x − c)·n dA over a plane, cylinder or cone, mm³: what the face adds to the solid's volume. By
/// Green's theorem a sum of integrals along its borders: closed form on lines and on circles about
/// the axis, adaptive Gauss quadrature to 1e-12 of the model's cubed size on others. The borders
/// must lie on the surface. Surfaces of other kinds have no such form: an assertion.
double volume_under(const SolidFace& face, const SolidModel& model);

/// Volume of the solid, from those of its faces.
double volume_of(const SolidModel& model);

/// Whether `volume_under` has the face's surface in closed form, as exactly as the file gives it.
bool has_border_volume(const SolidFace& face);

}  // namespace planish::brep
