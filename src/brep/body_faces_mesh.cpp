#include "body.hpp"
#include "guarded.hpp"
#include "mend.hpp"
#include "refusals.hpp"
#include "ruled_triangles.hpp"
#include "triangulate.hpp"

#include <planish/brep/step.hpp>

#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <utility>

// Triangles of a body, each with its face, numbered as in the file. The kernel sometimes makes no
// triangles of a face, or covers it in part, without an error. The area vectors of a closed surface
// add up to zero, so what is missing shows in their sum. Faces between two rails need no kernel
// unless they come out wrong.

namespace planish {
namespace {

/// The faces that the kernel is to mesh.
TopoDS_Compound faces_for_kernel(const TopoDS_Shape& solid, bool by_rulings) {
  TopoDS_Compound left;
  const BRep_Builder builder;
  builder.MakeCompound(left);
  for (TopExp_Explorer each(solid, TopAbs_FACE); each.More(); each.Next())
    if (!by_rulings || !brep::joins_rails(TopoDS::Face(each.Current())))
      builder.Add(left, each.Current());
  return left;
}

MeshOfFaces triangles_of(const TopoDS_Shape& solid, double chord, bool by_rulings) {
  // The kernel stores triangles in the shape itself, so mesh a copy.
  const TopoDS_Shape copy = brep::meshable(solid);
  brep::triangulate(faces_for_kernel(copy, by_rulings), chord);
  MeshOfFaces result;
  int number = 0;
  for (TopExp_Explorer each(copy, TopAbs_FACE); each.More(); each.Next(), ++number) {
    const TopoDS_Face& face = TopoDS::Face(each.Current());
    if (by_rulings && brep::joins_rails(face))
      brep::append_ruled_triangles(result, face, number, chord);
    else
      brep::append_triangles(result, face, number);
  }
  return result;
}

Result<void> check_closed(const MeshOfFaces& surface) {
  constexpr double kOpen = 1e-4;  // of the area; neighbouring faces have their corners in common
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const auto& t : surface.mesh.triangles) {
    const Vec3& a = surface.mesh.points[t[0]];
    const Vec3 twice = (surface.mesh.points[t[1]] - a).cross(surface.mesh.points[t[2]] - a);
    sum += 0.5 * twice;
    area += 0.5 * twice.norm();
  }
  if (sum.norm() <= kOpen * area) return {};
  return fail(refuse::triangles_open, {{"area", sum.norm(), unit::mm2}});
}

}  // namespace

Result<MeshOfFaces> body_faces_mesh(const Body& body, double chord) {
  if (!(chord > 0.0)) return fail(refuse::chord_not_positive, {{"chord", chord, unit::mm}});
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    const TopoDS_Shape& solid = body.shape().solid;
    MeshOfFaces surface = triangles_of(solid, chord, true);
    if (check_closed(surface)) return surface;
    surface = triangles_of(solid, chord, false);
    if (auto closed = check_closed(surface); !closed) return pass_on(closed);
    return surface;
  });
}

}  // namespace planish
