#pragma once

#include <planish/brep/step.hpp>

namespace planish {

struct CrossingOptions {
  double chord = 0.01;  ///< of the triangles from the faces, mm
  double depth = 0.04;  ///< what counts as running through, mm
};

/// Triangles of those faces of a body that may run through another face of it by `depth`: their
/// boxes overlap, and neither stays on one side of the other's plane. Most bodies have none, and
/// then nothing is meshed. Faces are numbered as by `body_faces_mesh`. Cost: near-linear in the
/// faces where few boxes overlap. Errors: `bad_option` (chord or depth not positive).
Result<MeshOfFaces> crossing_faces_mesh(const Body& body, const CrossingOptions& options);

}  // namespace planish
