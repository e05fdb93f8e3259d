#include "guarded.hpp"
#include "kernel_points.hpp"
#include "solid_builder.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS_Solid.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace planish {
namespace {

using Side = std::pair<int, int>;

Vec3 twice_area(const Mesh& mesh, const std::array<int, 3>& t) {
  const auto at = [&](int corner) -> const Vec3& { return mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(corner)])]; };
  return (at(1) - at(0)).cross(at(2) - at(0));
}

double volume_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.points[static_cast<std::size_t>(t[0])].dot(mesh.points[static_cast<std::size_t>(t[1])].cross(mesh.points[static_cast<std::size_t>(t[2])])) / 6.0;
  return sum;
}

Result<void> check_triangles(const Mesh& mesh) {
  const int count = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    if (std::ranges::any_of(t, [&](int corner) { return corner < 0 || corner >= count; }))
      return fail(ErrorCode::invalid_input, "A triangle has a corner that does not exist.", fmt::format("triangle {}", i));
    if (!(twice_area(mesh, t).norm() > 0.0)) return fail(ErrorCode::invalid_input, "A triangle has no area.", fmt::format("triangle {}", i));
  }
  return {};
}

Result<void> check_closed(const Mesh& mesh) {
  std::map<Side, int> runs;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++runs[{t[i], t[(i + 1) % 3]}];
  for (const auto& [side, times] : runs) {
    const auto back = runs.find({side.second, side.first});
    if (times != 1 || back == runs.end() || back->second != 1)
      return fail(ErrorCode::invalid_input, fmt::format("The mesh is not closed between points {} and {}.", side.first, side.second));
  }
  if (const double volume = volume_of(mesh); !(volume > 0.0))
    return fail(ErrorCode::invalid_input, fmt::format("The mesh encloses {:.6g} mm³: it is empty or inside out.", volume));
  return {};
}

/// A plane face a triangle, sides shared.
TopoDS_Shell shell_of(const Mesh& mesh) {
  brep::SolidBuilder builder;
  std::vector<TopoDS_Vertex> vertices;
  for (const Vec3& point : mesh.points)
    vertices.push_back(builder.vertex(point));
  std::map<Side, brep::BuiltEdge> edges;
  const auto use_of = [&](int from, int to) {
    const Side side = std::minmax(from, to);
    auto found = edges.find(side);
    if (found == edges.end())
      found = edges.emplace(side, builder.straight_edge(vertices[static_cast<std::size_t>(side.first)], vertices[static_cast<std::size_t>(side.second)])).first;
    return brep::EdgeUse{&found->second, {}, from < to};
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 normal = twice_area(mesh, t).normalized();
    const Handle(Geom_Surface) plane =
        new Geom_Plane(brep::kernel_point(mesh.points[static_cast<std::size_t>(t[0])]), brep::kernel_direction(normal));
    builder.face(plane, 1, {{use_of(t[0], t[1]), use_of(t[1], t[2]), use_of(t[2], t[0])}});
  }
  return builder.shell();
}

Result<TopoDS_Solid> solid_of(const TopoDS_Shell& shell) {
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  if (!BRepCheck_Analyzer(solid).IsValid()) return fail(ErrorCode::internal, "The CAD kernel finds the solid of the mesh invalid.");
  return solid;
}

}  // namespace

Result<std::string> mesh_solid_step(const Mesh& mesh, const std::string& name) {
  if (auto sound = check_triangles(mesh); !sound) return tl::unexpected(sound.error());
  if (auto sound = check_closed(mesh); !sound) return tl::unexpected(sound.error());
  return brep::guarded(
      [&]() -> Result<std::string> {
        const auto solid = solid_of(shell_of(mesh));
        if (!solid) return tl::unexpected(solid.error());
        return brep::step_text(*solid, name);
      },
      name);
}

}  // namespace planish
