#include "rim.hpp"

#include "genus.hpp"
#include "rim_refusal.hpp"

#include <algorithm>
#include <set>

// What belongs to neither skin, in connected parts: the walls of a cut, a countersink, an emboss, a
// boss. A part is told by the loops of skin faces that it touches, and by whether points of its
// own, not on a skin's border, lie between the skins or leave the sheet, and on which side.

namespace planish::brep {
namespace {

using EdgesByFace = std::vector<std::vector<int>>;

bool is_skin(const Skins& skins, int face) {
  return face >= 0 && skins.skin_of[face] != Skin::none;
}

bool on_skin(const Skins& skins, const SolidEdge& edge) {
  return is_skin(skins, edge.faces[0]) || is_skin(skins, edge.faces[1]);
}

/// Faces of no skin, connected over their edges.
Rim connected_parts(const SolidModel& model, const EdgesByFace& edges, const Skins& skins) {
  Rim rim;
  rim.part_of.assign(model.faces.size(), -1);
  for (int seed = 0; seed < std::ssize(model.faces); ++seed) {
    if (is_skin(skins, seed) || rim.part_of[seed] >= 0) continue;
    const int label = static_cast<int>(rim.parts.size());
    RimPart& part = rim.parts.emplace_back();
    std::vector<int> stack{seed};
    rim.part_of[seed] = label;
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      part.faces.push_back(face);
      for (const int e : edges[face]) {
        const int next = face_across(model.edges[e], face);
        if (next < 0 || is_skin(skins, next) || rim.part_of[next] >= 0) continue;
        rim.part_of[next] = label;
        stack.push_back(next);
      }
    }
  }
  return rim;
}

/// Parts that the loop of a skin face touches.
std::set<int> parts_along(const SolidModel& model, const Rim& rim, const LoopRef& ref) {
  std::set<int> parts;
  for (const CoEdge& use : model.faces[ref.face].loops[ref.loop])
    if (const int next = face_across(model.edges[use.edge], ref.face);
        next >= 0 && rim.part_of[next] >= 0)
      parts.insert(rim.part_of[next]);
  return parts;
}

/// The rim with the loops that each part touches.
Rim with_loops(Rim rim, const SolidModel& model, const Skins& skins) {
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    if (!is_skin(skins, f)) continue;
    for (int l = 0; l < std::ssize(model.faces[f].loops); ++l)
      for (const int p : parts_along(model, rim, {f, l})) {
        RimPart& part = rim.parts[p];
        (skins.skin_of[f] == Skin::first ? part.first : part.second).push_back({f, l});
      }
  }
  return rim;
}

/// Whether a point lies between the skins, seen from one of these skin faces.
bool between(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins,
             const std::set<int>& skin_faces, const Vec3& p) {
  constexpr double kTouching = 0.05;  // of the thickness: fillets and chamfers touch from inside
  const double t = skins.thickness;
  const double slack = kTouching * t + skins.spread;
  return std::ranges::any_of(skin_faces, [&](int f) {
    const Outline& outline = outlines[f];
    if (!enlarged(outline.space, 2 * t).contains(p)) return false;
    const double depth = depth_below(model.faces[f], outline, p);
    return depth >= -slack && depth <= t + slack;
  });
}

std::set<int> vertices_on_skins(const SolidModel& model, const Skins& skins) {
  std::set<int> vertices;
  for (const SolidEdge& edge : model.edges)
    if (on_skin(skins, edge)) vertices.insert(edge.vertices.begin(), edge.vertices.end());
  return vertices;
}

/// A point of an edge.
struct OwnPoint {
  int edge = 0;
  Vec3 at;
};

/// Points of the part that are not on a skin's border: middles of its edges and free corners.
std::vector<OwnPoint> own_points(const SolidModel& model, const EdgesByFace& edges,
                                 const Skins& skins, const std::set<int>& skin_vertices,
                                 const RimPart& part) {
  std::vector<OwnPoint> points;
  std::set<int> seen;
  const auto at_skin = [&](int vertex) { return skin_vertices.count(vertex) > 0; };
  for (const int f : part.faces)
    for (const int e : edges[f]) {
      const SolidEdge& edge = model.edges[e];
      if (!seen.insert(e).second || edge.vertices[0] < 0 || on_skin(skins, edge)) continue;
      const bool wall = at_skin(edge.vertices[0]) && at_skin(edge.vertices[1]);
      if (wall && edge.curve.kind == SpaceCurve::Kind::line) continue;
      points.push_back({e, edge.curve.point((edge.curve.t0 + edge.curve.t1) / 2)});
      if (!at_skin(edge.vertices[0])) points.push_back({e, edge.curve.start});
      if (!at_skin(edge.vertices[1])) points.push_back({e, edge.curve.end});
    }
  return points;
}

std::set<int> touched_faces(const RimPart& part) {
  std::set<int> faces;
  for (const auto* loops : {&part.first, &part.second})
    for (const LoopRef& ref : *loops)
      faces.insert(ref.face);
  return faces;
}

}  // namespace

Rim find_rim(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins) {
  const EdgesByFace edges = edges_by_face(model);
  const std::set<int> skin_vertices = vertices_on_skins(model, skins);
  Rim rim = with_loops(connected_parts(model, edges, skins), model, skins);
  for (RimPart& part : rim.parts) {
    const std::set<int> touched = touched_faces(part);
    std::set<int> outside;
    for (const OwnPoint& p : own_points(model, edges, skins, skin_vertices, part))
      if (!between(model, outlines, skins, touched, p.at)) outside.insert(p.edge);
    part.within = outside.empty();
    part.openings = openings_through(model, part.faces);
    if (!part.within) part.refusal = rim_refusal(model, edges, skins, part, outside);
  }
  return rim;
}

}  // namespace planish::brep
