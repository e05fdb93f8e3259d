#pragma once

#include "solid_model.hpp"

namespace planish::brep {

/// A point of a surface with its unit normal.
struct SurfaceSample {
  Vec3 point;
  Vec3 normal;
};

struct SurfaceFit {
  std::variant<Frame, Developable> surface;  ///< a plane's z is the mean normal
  double deviation = 0.0;                    ///< largest distance of a sample from the surface, mm
};

/// The plane, circular cylinder or right cone (tried in this order) on which all samples lie within
/// `tolerance` and whose normals agree. Cylinder and cone follow from the normals: they are
/// perpendicular, or equally inclined, to the axis; axis line, radius and apex by linear least
/// squares.
std::optional<SurfaceFit> fit_surface(const std::vector<SurfaceSample>& samples, double tolerance);

}  // namespace planish::brep
