#pragma once

#include "solid_model.hpp"

#include <planish/base/place.hpp>

namespace planish::brep {

/// A face of the solid by its number, and a point on its outline.
Place face_place(const SolidModel& model, int face);
/// An edge of the solid by its number, and its middle.
Place edge_place(const SolidModel& model, int edge);

}  // namespace planish::brep
