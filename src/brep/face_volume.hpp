#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// ⅓∫(x − c)·n dA over a plane, cylinder or cone, mm³: the face's share of the solid's volume. By
/// Green's theorem a sum of integrals along its borders: closed form on lines and on circles about
/// the axis, adaptive Gauss quadrature to 1e-12 of the model's cubed size on others. The borders
/// must lie on the surface. Other kinds of surface fail an assertion.
double volume_under(const SolidFace& face, const SolidModel& model);

/// Volume of the solid, from those of its faces.
double volume_of(const SolidModel& model);

/// Whether `volume_under` has a closed form for the face's surface, with the exactness of the file.
bool has_border_volume(const SolidFace& face);

}  // namespace planish::brep
