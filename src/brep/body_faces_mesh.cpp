#include "body.hpp"
#include "guarded.hpp"
#include "mend.hpp"
#include "refusals.hpp"
#include "triangulate.hpp"

#include <planish/brep/step.hpp>

#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <utility>

// Triangles of a body, each with its face, numbered as in the file. The kernel sometimes makes no
// triangles of a face, or covers it in part, without an error. The area vectors of a closed surface
// add up to zero, so what is missing shows in their sum.

namespace planish {
namespace {

MeshOfFaces triangles_of(const TopoDS_Shape& solid, double chord) {
  // The kernel stores triangles in the shape itself, so mesh a copy.
  const TopoDS_Shape copy = brep::meshable(solid);
  brep::triangulate(copy, chord);
  MeshOfFaces result;
  int number = 0;
  for (TopExp_Explorer each(copy, TopAbs_FACE); each.More(); each.Next())
    brep::append_triangles(result, TopoDS::Face(each.Current()), number++);
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
    MeshOfFaces surface = triangles_of(body.shape().solid, chord);
    if (auto closed = check_closed(surface); !closed) return pass_on(closed);
    return surface;
  });
}

}  // namespace planish
