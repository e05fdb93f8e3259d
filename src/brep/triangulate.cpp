#include "triangulate.hpp"

#include "kernel_points.hpp"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>

#include <utility>

namespace planish::brep {

void triangulate(const TopoDS_Shape& shape, double chord, Angle turn) {
  IMeshTools_Parameters limits;
  limits.Deflection = chord;
  limits.Angle = turn.radians();
  limits.MinSize = Precision::Confusion();  // by default the kernel stops at a tenth of the chord
  const BRepMesh_IncrementalMesh triangles(shape, limits);
}

void append_triangles(MeshOfFaces& to, const TopoDS_Face& face, int number) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, place);
  if (own.IsNull()) return;
  const int first = static_cast<int>(to.mesh.points.size());
  for (int i = 1; i <= own->NbNodes(); ++i)
    to.mesh.points.push_back(vector_of(own->Node(i).Transformed(place)));
  for (int i = 1; i <= own->NbTriangles(); ++i) {
    int a, b, c;
    own->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    to.mesh.triangles.push_back({first + a - 1, first + b - 1, first + c - 1});
    to.face.push_back(number);
  }
}

}  // namespace planish::brep
