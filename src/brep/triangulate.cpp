#include "triangulate.hpp"

#include <BRepMesh_IncrementalMesh.hxx>
#include <Precision.hxx>

namespace planish::brep {

void triangulate(const TopoDS_Shape& shape, double chord, Angle turn) {
  IMeshTools_Parameters limits;
  limits.Deflection = chord;
  limits.Angle = turn.radians();
  limits.MinSize = Precision::Confusion();  // by default the kernel stops at a tenth of the chord
  const BRepMesh_IncrementalMesh triangles(shape, limits);
}

}  // namespace planish::brep
