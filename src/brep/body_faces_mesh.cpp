#include "body.hpp"
#include "guarded.hpp"
#include "kernel_points.hpp"
#include "mend.hpp"
#include "triangulate.hpp"

#include <planish/brep/step.hpp>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <fmt/format.h>

#include <utility>

namespace planish {
namespace {

Result<void> add_face(MeshOfFaces& result, const TopoDS_Face& face, int number) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, place);
  if (own.IsNull())
    return fail(ErrorCode::internal, "The CAD kernel made no triangles of a face.",
                fmt::format("face {}", number + 1));
  const int first = static_cast<int>(result.mesh.points.size());
  for (int i = 1; i <= own->NbNodes(); ++i)
    result.mesh.points.push_back(brep::vector_of(own->Node(i).Transformed(place)));
  for (int i = 1; i <= own->NbTriangles(); ++i) {
    int a, b, c;
    own->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    result.mesh.triangles.push_back({first + a - 1, first + b - 1, first + c - 1});
    result.face.push_back(number);
  }
  return {};
}

}  // namespace

Result<MeshOfFaces> body_faces_mesh(const Body& body, double chord) {
  if (!(chord > 0.0))
    return fail(ErrorCode::bad_option,
                fmt::format("The chord of a mesh is {} mm; it must be positive.", chord));
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    // The kernel stores triangles in the shape itself, so mesh a copy.
    const TopoDS_Shape measurable = brep::with_parameter_curves(body.shape().solid);
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(measurable).Shape();
    brep::triangulate(copy, chord);
    MeshOfFaces result;
    int number = 0;
    for (TopExp_Explorer faces(copy, TopAbs_FACE); faces.More(); faces.Next(), ++number)
      if (auto added = add_face(result, TopoDS::Face(faces.Current()), number); !added)
        return tl::unexpected(added.error());
    return result;
  });
}

}  // namespace planish
