#include "rim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace planish::brep {
namespace {

class RimFinder {
 public:
  RimFinder(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins)
      : model_(model), outlines_(outlines), skins_(skins), edges_of_(model.faces.size()) {
    for (size_t e = 0; e < model.edges.size(); ++e)
      for (const int f : model.edges[e].faces)
        if (f >= 0) edges_of_[f].push_back(static_cast<int>(e));
    mark_skin_vertices();
  }

  Rim run() {
    rim_.part_of.assign(model_.faces.size(), -1);
    for (size_t f = 0; f < model_.faces.size(); ++f) {
      if (side(static_cast<int>(f)) != Side::none || rim_.part_of[f] >= 0) continue;
      grow(static_cast<int>(f));
    }
    note_loops();
    for (RimPart& part : rim_.parts)
      judge(part);
    return std::move(rim_);
  }

 private:
  Side side(int face) const { return skins_.side[face]; }

  void mark_skin_vertices() {
    for (const SolidEdge& edge : model_.edges) {
      const bool on_skin = std::any_of(edge.faces.begin(), edge.faces.end(),
                                       [&](int f) { return f >= 0 && side(f) != Side::none; });
      if (on_skin) skin_vertices_.insert(edge.vertices.begin(), edge.vertices.end());
    }
  }

  int across(int e, int face) const {
    const auto& faces = model_.edges[e].faces;
    return faces[0] == face ? faces[1] : faces[0];
  }

  void grow(int seed) {
    const int label = static_cast<int>(rim_.parts.size());
    RimPart& part = rim_.parts.emplace_back();
    std::vector<int> stack{seed};
    rim_.part_of[seed] = label;
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      part.faces.push_back(face);
      for (const int e : edges_of_[face]) {
        const int next = across(e, face);
        if (next < 0 || side(next) != Side::none || rim_.part_of[next] >= 0) continue;
        rim_.part_of[next] = label;
        stack.push_back(next);
      }
    }
  }

  void note_loops() {
    for (size_t f = 0; f < model_.faces.size(); ++f) {
      if (side(static_cast<int>(f)) == Side::none) continue;
      for (size_t l = 0; l < model_.faces[f].loops.size(); ++l) {
        std::set<int> parts;
        for (const CoEdge& use : model_.faces[f].loops[l])
          if (const int next = across(use.edge, static_cast<int>(f)); next >= 0)
            if (const int part = rim_.part_of[next]; part >= 0) parts.insert(part);
        for (const int part : parts) {
          RimPart& row = rim_.parts[part];
          (side(static_cast<int>(f)) == Side::first ? row.first : row.second)
              .push_back({static_cast<int>(f), static_cast<int>(l)});
        }
      }
    }
  }

  /// Whether a point lies between the skins, seen from one of the skin faces the part touches.
  bool between(const Vec3& p, const std::vector<int>& skin_faces) const {
    const double t = skins_.thickness;
    const double slack = 0.05 * t +
                         skins_.spread;  // fillets and chamfers touch the skins from inside
    return std::any_of(skin_faces.begin(), skin_faces.end(), [&](int f) {
      const Outline& outline = outlines_[f];
      const bool near = ((outline.lo.array() - 2 * t) <= p.array()).all() &&
                        (p.array() <= (outline.hi.array() + 2 * t)).all();
      if (!near) return false;
      const SolidFace& face = model_.faces[f];
      double depth = 0.0;
      if (const auto* plane = std::get_if<Frame>(&face.surface)) {
        depth = -plane->local(p).z();
      } else {
        const auto& surface = std::get<Developable>(face.surface);
        const Vec2 uv = parameters_of(surface, p, outline.u_middle);
        depth = -face.sense * (p - point_on(surface, uv)).dot(normal_on(surface, uv.x()));
      }
      return depth >= -slack && depth <= t + slack;
    });
  }

  /// Points of the part that are not on a skin's border: middles of its edges and free corners.
  std::vector<Vec3> own_points(const RimPart& part) const {
    std::vector<Vec3> points;
    std::set<int> seen;
    for (const int f : part.faces)
      for (const int e : edges_of_[f]) {
        const SolidEdge& edge = model_.edges[e];
        if (!seen.insert(e).second || edge.vertices[0] < 0) continue;
        const bool on_skin = std::any_of(edge.faces.begin(), edge.faces.end(), [&](int face) {
          return face >= 0 && side(face) != Side::none;
        });
        if (on_skin) continue;
        const bool wall = skin_vertices_.count(edge.vertices[0]) &&
                          skin_vertices_.count(edge.vertices[1]);
        if (wall && edge.curve.kind == SpaceCurve::Kind::line) continue;
        points.push_back(edge.curve.point((edge.curve.t0 + edge.curve.t1) / 2));
        if (!skin_vertices_.count(edge.vertices[0])) points.push_back(edge.curve.start);
        if (!skin_vertices_.count(edge.vertices[1])) points.push_back(edge.curve.end);
      }
    return points;
  }

  void judge(RimPart& part) {
    std::set<int> skin_faces;
    for (const LoopRef& ref : part.first)
      skin_faces.insert(ref.face);
    for (const LoopRef& ref : part.second)
      skin_faces.insert(ref.face);
    const std::vector<int> touched(skin_faces.begin(), skin_faces.end());
    for (const Vec3& p : own_points(part)) {
      if (between(p, touched)) continue;
      part.within = false;
      break;
    }
    if (!part.within) part.refusal = refusal_of(part, skin_faces);
  }

  /// A neighbour that continues a skin tangentially tells what went wrong there.
  Error refusal_of(const RimPart& part, const std::set<int>& skin_faces) const {
    Error doubly{ErrorCode::internal, {}, {}};
    Error thickness = doubly;
    for (const int f : part.faces)
      for (const int e : edges_of_[f]) {
        const int skin = across(e, f);
        if (skin < 0 || !skin_faces.count(skin)) continue;
        const SolidFace& face = model_.faces[f];
        if (const auto* curved = std::get_if<DoublyCurved>(&face.surface)) {
          if (doubly.message.empty())
            doubly = {ErrorCode::doubly_curved,
                      fmt::format("Face {} ({}) is curved two ways; it was drawn or formed, not "
                                  "bent, and has no flat "
                                  "pattern.",
                                  f + 1, curved->kind),
                      fmt::format("face {}", f + 1)};
        } else if (const auto angle = dihedral(model_, e); angle && std::abs(*angle) < 0.1) {
          if (thickness.message.empty())
            thickness = {ErrorCode::thickness_not_constant,
                         fmt::format("Below face {}, which goes on from face {}, the material is "
                                     "not {:.4g} mm thick.",
                                     f + 1, skin + 1, skins_.thickness),
                         fmt::format("face {}", f + 1)};
        }
      }
    if (!doubly.message.empty()) return doubly;
    if (!thickness.message.empty()) return thickness;
    return {ErrorCode::not_a_sheet,
            fmt::format("Material at face {} leaves the sheet of {:.4g} mm; this is not a part "
                        "made of one sheet.",
                        part.faces.front() + 1, skins_.thickness),
            fmt::format("face {}", part.faces.front() + 1)};
  }

  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  const Skins& skins_;
  std::vector<std::vector<int>> edges_of_;
  std::set<int> skin_vertices_;
  Rim rim_;
};

}  // namespace

Rim find_rim(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins) {
  return RimFinder(model, outlines, skins).run();
}

int outer_loop(const Outline& outline) {
  int best = 0;
  double best_area = -1.0;
  for (size_t l = 0; l < outline.flat.size(); ++l) {
    double sum = 0.0;
    const auto& ring = outline.flat[l];
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      sum += a.x() * b.y() - a.y() * b.x();
    }
    if (std::abs(sum) <= best_area) continue;
    best_area = std::abs(sum);
    best = static_cast<int>(l);
  }
  return best;
}

}  // namespace planish::brep
