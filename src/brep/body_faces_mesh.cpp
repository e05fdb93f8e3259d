#include "body.hpp"
#include "face_extent.hpp"
#include "guarded.hpp"
#include "kernel_points.hpp"
#include "mend.hpp"
#include "triangulate.hpp"

#include <planish/brep/crossing_faces.hpp>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace planish {
namespace {

using brep::FaceExtent;

/// Leaves out a face of which the kernel makes no triangles.
void add_face(MeshOfFaces& result, const TopoDS_Face& face, int number) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, place);
  if (own.IsNull()) return;
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
}

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer each(shape, TopAbs_FACE); each.More(); each.Next())
    faces.push_back(TopoDS::Face(each.Current()));
  return faces;
}

/// The faces with these numbers as triangles.
MeshOfFaces triangles_of(const std::vector<TopoDS_Face>& faces, const std::vector<int>& numbers,
                         double chord) {
  MeshOfFaces result;
  if (numbers.empty()) return result;
  TopoDS_Compound chosen;
  BRep_Builder builder;
  builder.MakeCompound(chosen);
  for (const int number : numbers)
    builder.Add(chosen, faces[number]);
  // The kernel stores triangles in the shape itself, so mesh a copy.
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(brep::with_parameter_curves(chosen)).Shape();
  brep::triangulate(copy, chord);
  const std::vector<TopoDS_Face> meshed = faces_of(copy);
  for (std::size_t i = 0; i < std::min(meshed.size(), numbers.size()); ++i)
    add_face(result, meshed[i], numbers[i]);
  return result;
}

double lowest(const FaceExtent& extent) { return extent.box.min().x(); }
double highest(const FaceExtent& extent) { return extent.box.max().x(); }

/// The numbers of the faces that may run through another one. Boxes are swept along x.
std::vector<int> crossing_faces(const std::vector<TopoDS_Face>& faces, double depth) {
  std::vector<FaceExtent> extents;
  std::vector<int> order;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    extents.push_back(brep::extent_of(faces[i]));
    if (!extents.back().hull.empty()) order.push_back(static_cast<int>(i));
  }
  std::ranges::sort(order, {}, [&](int i) { return lowest(extents[i]); });
  std::vector<bool> may(faces.size(), false);
  for (auto i = order.begin(); i != order.end(); ++i)
    for (auto j = i + 1; j != order.end() && lowest(extents[*j]) <= highest(extents[*i]); ++j)
      if (!(may[*i] && may[*j]) && brep::may_cross(extents[*i], extents[*j], depth))
        may[*i] = may[*j] = true;
  std::vector<int> numbers;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (may[i]) numbers.push_back(static_cast<int>(i));
  return numbers;
}

/// The area vectors of a closed surface add up to nothing. The kernel sometimes makes no triangles
/// of a face, or covers it in part.
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
  return fail(
      ErrorCode::internal,
      fmt::format("The CAD kernel's triangles of the body leave {:.3g} mm² open.", sum.norm()));
}

Result<void> check_positive(const char* what, double value) {
  if (value > 0.0) return {};
  return fail(ErrorCode::bad_option,
              fmt::format("The {} is {} mm; it must be positive.", what, value));
}

}  // namespace

Result<MeshOfFaces> body_faces_mesh(const Body& body, double chord) {
  if (auto sound = check_positive("chord of a mesh", chord); !sound)
    return tl::unexpected(sound.error());
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    const std::vector<TopoDS_Face> faces = faces_of(body.shape().solid);
    std::vector<int> all(faces.size());
    std::iota(all.begin(), all.end(), 0);
    MeshOfFaces surface = triangles_of(faces, all, chord);
    if (auto closed = check_closed(surface); !closed) return tl::unexpected(closed.error());
    return surface;
  });
}

Result<MeshOfFaces> crossing_faces_mesh(const Body& body, const CrossingOptions& options) {
  if (auto sound = check_positive("chord of a mesh", options.chord); !sound)
    return tl::unexpected(sound.error());
  if (auto sound = check_positive("depth that counts", options.depth); !sound)
    return tl::unexpected(sound.error());
  return brep::guarded([&]() -> Result<MeshOfFaces> {
    const std::vector<TopoDS_Face> faces = faces_of(body.shape().solid);
    return triangles_of(faces, crossing_faces(faces, options.depth), options.chord);
  });
}

}  // namespace planish
