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

int vertex_of(const Recognition& of, const CoEdge& use, bool after) {
  return of.model.edges[use.edge].vertices[use.forward == after ? 1 : 0];
}

/// Whether a run lies between two joints to another face.
bool is_between_joints(const Recognition& of, const LoopRun& run, int other) {
  const auto& loop = loop_of(of, run.loop);
  const size_t count = loop.size();
  for (const size_t i : {run.first + count - 1, size_t(run.first + run.count)})
    if (face_across(of.model.edges[loop[i % count].edge], run.loop.face) != other) return false;
  return true;
}

bool is_outer(const Recognition& of, const LoopRun& run) {
  return of.outlines[run.loop.face].outer == run.loop.loop;
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

std::optional<SkinOutline> outline_on(const Recognition& of, int part,
                                      const std::vector<LoopRef>& loops) {
  if (loops.size() == 1 && goes_round(of, of.rim.parts[part], loops.front())) {
    const auto run = run_along(of, part, loops.front());
    if (run) return SkinOutline{*run, {}};
  }
  if (loops.size() != 2) return {};
  auto plane = run_along(of, part, loops[0]), bend = run_along(of, part, loops[1]);
  if (!plane || !bend) return {};
  const auto is_plane = [&](const LoopRun& run) {
    return std::holds_alternative<Frame>(of.model.faces[run.loop.face].surface);
  };
  if (!is_plane(*plane)) std::swap(plane, bend);
  if (!is_plane(*plane) || !cylinder_of(of, bend->loop.face)) return {};
  if (!is_outer(of, *plane) || !is_outer(of, *bend) ||
      !is_between_joints(of, *plane, bend->loop.face) ||
      !is_between_joints(of, *bend, plane->loop.face))
    return {};
  const auto first = uses_of(of, *plane), second = uses_of(of, *bend);
  if (vertex_of(of, first.back(), true) != vertex_of(of, second.front(), false) ||
      vertex_of(of, second.back(), true) != vertex_of(of, first.front(), false))
    return {};
  return SkinOutline{*plane, *bend};
}

std::optional<SkinOutline> outline_beside_bend(const Recognition& of, int part, Skin skin) {
  const RimPart& row = of.rim.parts[part];
  auto outline = outline_on(of, part, skin == Skin::first ? row.first : row.second);
  if (!outline || !outline->on_bend) return {};
  const auto& plane = std::get<Frame>(of.model.faces[outline->on_plane.loop.face].surface);
  constexpr double kLevel = 1e-3;  // of the thickness
  for (const CoEdge& use : uses_of(of, *outline->on_bend)) {
    const SpaceCurve& curve = of.model.edges[use.edge].curve;
    for (const double share : {0.0, 0.5, 1.0})
      if (std::abs(plane.local(curve.point(std::lerp(curve.t0, curve.t1, share))).z()) >
          kLevel * of.skins.thickness)
        return {};
  }
  return outline;
}

}  // namespace planish::brep
