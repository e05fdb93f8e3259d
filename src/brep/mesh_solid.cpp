#include "guarded.hpp"
#include "kernel_points.hpp"
#include "refusals.hpp"
#include "solid_builder.hpp"
#include "step_out.hpp"

#include <planish/base/union_find.hpp>
#include <planish/brep/step.hpp>
#include <planish/geometry/mesh_volume.hpp>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

// A closed mesh as a solid: one plane face a triangle, edges shared, and triangles in one plane
// united by the kernel afterwards. Before that each edge must be run once each way, and each
// connected part must have a volume; connected parts become solids of their own.

namespace planish {
namespace {

using VertexPair = std::pair<int, int>;

Vec3 twice_area(const Mesh& mesh, const std::array<int, 3>& t) {
  const auto at = [&](int corner) -> const Vec3& { return mesh.points[t[corner]]; };
  return (at(1) - at(0)).cross(at(2) - at(0));
}

/// The mesh's connected parts, in the order of their first triangles.
std::vector<Mesh> parts_of(const Mesh& mesh) {
  UnionFind joined(static_cast<int>(mesh.points.size()));
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 1; i < 3; ++i)
      joined.unite(t[i], t[0]);
  std::map<int, std::size_t> number;
  std::vector<Mesh> parts;
  for (const auto& t : mesh.triangles) {
    const auto [at, added] = number.try_emplace(joined.root(t[0]), parts.size());
    if (added) parts.push_back({mesh.points, {}});
    parts[at->second].triangles.push_back(t);
  }
  return parts;
}

Result<void> check_triangles(const Mesh& mesh) {
  const int count = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Place row = place::pointer(fmt::format("/triangles/{}", i));
    if (std::ranges::any_of(t, [&](int corner) { return corner < 0 || corner >= count; }))
      return fail(refuse::corner_missing, {{"row", row}}, fmt::format("triangle {}", i));
    if (!(twice_area(mesh, t).norm() > 0.0))
      return fail(refuse::no_area, {{"row", row}, {"at", place::point(mesh.points[t[0]])}},
                  fmt::format("triangle {}", i));
  }
  return {};
}

Result<void> check_closed(const Mesh& mesh) {
  if (mesh.triangles.empty()) return fail(refuse::empty_mesh);
  const auto open = open_sides(mesh);
  if (open.empty()) return {};
  return fail(refuse::open_mesh, {{"from", place::point(mesh.points[open.front().first])},
                                  {"to", place::point(mesh.points[open.front().second])}});
}

Result<void> check_volume(const Mesh& part) {
  if (const double volume = volume_of(part); !(volume > 0.0))
    return fail(refuse::mesh_inside_out, {{"volume", volume, unit::mm3}});
  return {};
}

/// One plane face per triangle, with shared edges and only the vertices used.
TopoDS_Shell shell_of(const Mesh& mesh) {
  brep::SolidBuilder builder;
  std::map<int, TopoDS_Vertex> vertices;
  for (const auto& t : mesh.triangles)
    for (const int corner : t)
      if (!vertices.contains(corner)) vertices.emplace(corner, builder.vertex(mesh.points[corner]));
  std::map<VertexPair, brep::BuiltEdge> edges;
  const auto use_of = [&](int from, int to) {
    const VertexPair edge = std::minmax(from, to);
    auto found = edges.find(edge);
    if (found == edges.end())
      found = edges
                  .emplace(edge,
                           builder.straight_edge(vertices.at(edge.first), vertices.at(edge.second)))
                  .first;
    return brep::EdgeUse{&found->second, {}, from < to};
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 normal = twice_area(mesh, t).normalized();
    const Handle(Geom_Surface) plane = new Geom_Plane(brep::kernel_point(mesh.points[t[0]]),
                                                      brep::kernel_direction(normal));
    builder.face(plane, 1, {{use_of(t[0], t[1]), use_of(t[1], t[2]), use_of(t[2], t[0])}});
  }
  return builder.shell();
}

/// Triangles in one plane become one face, if the kernel detects it.
TopoDS_Shape with_whole_faces(const TopoDS_Shape& solid) {
  ShapeUpgrade_UnifySameDomain unify(solid, true, true, false);
  unify.Build();
  const TopoDS_Shape unified = unify.Shape();
  return !unified.IsNull() && unified.ShapeType() == TopAbs_SOLID &&
                 BRepCheck_Analyzer(unified).IsValid()
             ? unified
             : solid;
}

Result<TopoDS_Shape> solid_of(const TopoDS_Shell& shell) {
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  if (!BRepCheck_Analyzer(solid).IsValid()) return fail(refuse::mesh_solid_invalid);
  return with_whole_faces(solid);
}

/// One solid, or a compound of them.
Result<TopoDS_Shape> solids_of(const std::vector<Mesh>& parts) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const Mesh& part : parts) {
    auto solid = solid_of(shell_of(part));
    if (!solid || parts.size() == 1) return solid;
    builder.Add(all, *solid);
  }
  return all;
}

}  // namespace

Result<std::string> mesh_solid_step(const Mesh& mesh, const std::string& name) {
  if (auto sound = check_triangles(mesh); !sound) return pass_on(sound);
  if (auto sound = check_closed(mesh); !sound) return pass_on(sound);
  const std::vector<Mesh> parts = parts_of(mesh);
  for (const Mesh& part : parts)
    if (auto sound = check_volume(part); !sound) return pass_on(sound);
  return brep::guarded(
      [&]() -> Result<std::string> {
        const auto solids = solids_of(parts);
        if (!solids) return pass_on(solids);
        return brep::step_text(*solids, name);
      },
      name);
}

}  // namespace planish
