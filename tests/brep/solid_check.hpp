#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>

#include <string>

namespace planish::brep {

/// The content of a STEP text as read independently; for tests and tools.
struct SolidCheck {
  int solids = 0;
  int shells = 0, faces = 0, free_edges = 0;  ///< of solids and alone; edges of one face only
  bool valid = false;                         ///< the kernel's checker finds nothing
  bool closed = false;                        ///< every edge has two faces
  double volume = 0.0;                        ///< mm³
  double area = 0.0;                          ///< of all faces, mm²
  Vec3 lo = Vec3::Zero(), hi = Vec3::Zero();  ///< bounding box, at most 1e-6 mm too large
  int planes = 0, cylinders = 0, cones = 0, extrusions = 0, splines = 0, other_surfaces = 0;
  double largest_tolerance = 0.0;  ///< of any edge or vertex, mm
  std::string product;             ///< name of the first product
};

/// Reads the text with the kernel's STEP reader and examines all its content. Errors: `not_step`.
Result<SolidCheck> check_step_solid(const std::string& text);

}  // namespace planish::brep
