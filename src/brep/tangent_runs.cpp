#include "tangent_runs.hpp"

#include "borders.hpp"
#include "skin_outlines.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>

// The outline of an opening over a tangent line has two runs of edges, which end in each other: one
// of the flange's contour and one of the bend's.

namespace planish::brep {

namespace {

bool is_wall_of(const Recognition& of, int part, int face, const CoEdge& use) {
  const int wall = face_across(of.model.edges[use.edge], face);
  return wall >= 0 && of.rim.part_of[wall] == part;
}

}  // namespace

std::optional<LoopRun> run_along(const Recognition& of, int part, const LoopRef& ref) {
  const auto& loop = loop_of(of, ref);
  const int count = static_cast<int>(loop.size());
  LoopRun run{ref};
  int starts = 0;
  for (int i = 0; i < count; ++i) {
    if (!is_wall_of(of, part, ref.face, loop[i])) continue;
    ++run.count;
    if (is_wall_of(of, part, ref.face, loop[(i + count - 1) % count])) continue;
    run.first = i;
    ++starts;
  }
  if (run.count == 0 || starts > 1) return {};
  return run;
}

std::vector<CoEdge> uses_of(const Recognition& of, const LoopRun& run) {
  const auto& loop = loop_of(of, run.loop);
  std::vector<CoEdge> uses;
  for (int i = 0; i < run.count; ++i)
    uses.push_back(loop[(run.first + i) % loop.size()]);
  return uses;
}

Vec3 point_of(const Recognition& of, const CoEdge& use, bool after) {
  const SpaceCurve& curve = of.model.edges[use.edge].curve;
  return use.forward == after ? curve.end : curve.start;
}

const Cylinder* cylinder_of(const Recognition& of, int face) {
  const auto* surface = std::get_if<Developable>(&of.model.faces[face].surface);
  return surface ? std::get_if<Cylinder>(surface) : nullptr;
}

double middle_radius(const Recognition& of, const SkinOutline& outline) {
  const int face = outline.on_bend->loop.face;
  return cylinder_of(of, face)->radius - of.model.faces[face].sense * of.skins.thickness / 2;
}

Frame across_tangent(const Recognition& of, const Frame& plane, const SkinOutline& outline) {
  const auto uses = uses_of(of, *outline.on_bend);
  const Vec3 from = point_of(of, uses.front(), false), to = point_of(of, uses.back(), true);
  Vec3 x = (to - from).cross(plane.z).normalized();
  // Either run may lie on the tangent line, as where the side of a window does.
  const auto beyond = [&](const std::vector<CoEdge>& run) {
    return sum_of(run, [&](const CoEdge& use) {
      const SpaceCurve& curve = of.model.edges[use.edge].curve;
      return x.dot(curve.point((curve.t0 + curve.t1) / 2) - from);
    });
  };
  if (beyond(uses) < beyond(uses_of(of, outline.on_plane))) x = -x;
  Frame frame;
  frame.origin = from - (from - plane.origin).dot(plane.z) * plane.z;
  frame.x = x;
  frame.y = plane.z.cross(x);
  frame.z = plane.z;
  return frame;
}

BorderLoop seen_outline(const Recognition& of, const SkinOutline& outline, const Frame& plane,
                        Skin skin) {
  std::vector<CoEdge> uses = uses_of(of, outline.on_plane);
  if (outline.on_bend) std::ranges::copy(uses_of(of, *outline.on_bend), std::back_inserter(uses));
  const bool other = skin != of.skin;
  if (other) {
    std::ranges::reverse(uses);
    for (CoEdge& use : uses)
      use.forward = !use.forward;
  }
  BorderLoop loop = read_borders(of.model, uses, plane, 0.0, of.tolerance);
  for (Border& border : loop)
    border.edge_depth = other ? of.skins.thickness : 0.0;
  return loop;
}

BorderLoop seen_here(const Recognition& of, const TangentOpening& opening) {
  return seen_outline(of, opening.here, opening.plane, of.skin);
}
BorderLoop seen_there(const Recognition& of, const TangentOpening& opening) {
  return seen_outline(of, opening.there, opening.plane, other_skin(of.skin));
}

}  // namespace planish::brep
