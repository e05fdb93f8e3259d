#include "face_reader.hpp"

#include "borders.hpp"
#include "narrowest.hpp"
#include "skin_outlines.hpp"
#include "widest.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// A face of the solid as a face of the sheet, on the surface that represents its group. Loops of
// one face are read each from a first point of its own, so a hole on a cylinder may come out a turn
// away from the outer loop, and is moved back by whole turns. A border along an edge below the skin
// keeps its depth; where a chamfer ends, the step to the next border is closed by its short side,
// and where a strip tapers to a point at a corner, by the edge below it.

namespace planish::brep {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Loops on planes and ruled surfaces have only one position.
bool repeats(const std::variant<Frame, Developable>& surface) {
  const auto* developable = std::get_if<Developable>(&surface);
  return developable && !std::holds_alternative<Ruled>(*developable);
}

BorderLoop shifted(BorderLoop loop, double by) {
  if (by != 0.0)
    for (Border& border : loop)
      border.curve = shifted_u(border.curve, by);
  return loop;
}

double middle_u(const BorderLoop& loop) {
  const Box2 box = bounds(loop);
  return (box.lo.x() + box.hi.x()) / 2;
}

double depth_at(const SolidFace& face, const Vec3& point) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return -plane->local(point).z();
  const auto& surface = std::get<Developable>(face.surface);
  const Vec2 uv = parameters_of(surface, point, 0.0);
  return -face.sense * (point - point_on(surface, uv)).dot(normal_on(surface, uv.x()));
}

/// A border along an edge below the skin, with its depth. On a curved skin its length is not the
/// skin's; where its depth varies, it has no edge to be measured against.
Border below_skin(Border border, const SolidFace& face, const SpaceCurve& edge, double tolerance) {
  border.edge_depth = depth_at(face, edge.start);
  if (!std::holds_alternative<Frame>(face.surface)) border.edge_length.reset();
  for (const double share : {0.25, 0.5, 0.75, 1.0})
    if (std::abs(depth_at(face, edge.point(std::lerp(edge.t0, edge.t1, share))) -
                 border.edge_depth) > tolerance) {
      border.edge.reset();
      border.edge_length.reset();
    }
  return border;
}

/// The face as read, before others were merged into it, that runs along an edge in this sense.
std::optional<int> read_face_at(const SolidModel& model, int face, const CoEdge& use) {
  const SolidEdge& edge = model.edges[use.edge];
  for (int side = 0; side < 2; ++side)
    if (edge.faces[side] == face && edge.forward[side] == use.forward)
      return face_as_read(edge, side);
  return {};
}

/// Beside a chamfer that ends, its short side closes the contour.
void connect(BorderLoop& borders, const Border& next) {
  if (borders.empty()) return;
  const Vec2 from = end_of(borders.back().curve);
  const Vec2 to = start_of(next.curve);
  constexpr double kStep = 1e-3;  // mm: smaller gaps are rounding of the file, which merging closes
  if ((to - from).norm() <= kStep) return;
  Border step;
  step.curve = Segment{from, to};
  borders.push_back(step);
}

int vertex_after(const SolidModel& model, const CoEdge& use) {
  return model.edges[use.edge].vertices[use.forward ? 1 : 0];
}
int vertex_before(const SolidModel& model, const CoEdge& use) {
  return vertex_after(model, {use.edge, !use.forward});
}

/// The edge of a wall that leads from the end of one edge below the skin to the start of the next,
/// where a strip between them tapers to a point on the skin, as round a corner.
std::optional<CoEdge> edge_between(const Recognition& of, const CoEdge& from, const CoEdge& to) {
  const int start = vertex_after(of.model, from);
  const int end = vertex_before(of.model, to);
  if (start == end) return {};
  const int wall = of.model.edges[to.edge].faces.front();
  if (wall < 0 || of.rim.part_of[wall] < 0) return {};
  for (const int f : of.rim.parts[of.rim.part_of[wall]].faces)
    for (const auto& loop : of.model.faces[f].loops)
      for (const CoEdge& use : loop)
        for (const CoEdge& one : {use, CoEdge{use.edge, !use.forward}})
          if (vertex_before(of.model, one) == start && vertex_after(of.model, one) == end)
            return one;
  return {};
}

/// Whether what lies beyond an edge of a skin is no cut: it leaves the sheet, or touches one skin.
bool is_beside_form(const Recognition& of, int face, const CoEdge& use) {
  const int wall = face_across(of.model.edges[use.edge], face);
  if (wall < 0 || of.rim.part_of[wall] < 0) return false;
  const RimPart& part = of.rim.parts[of.rim.part_of[wall]];
  return !part.within || part.first.empty() || part.second.empty();
}

/// An edge along which the blank is cut.
struct CutUse {
  CoEdge use;
  int border = -1;     ///< of the loop, that it stands for; −1: it leads from one to the next
  bool below = false;  ///< it lies below the skin
  bool far = false;    ///< on the other one
  int bridge = -1;     ///< the tangent opening over which a straight border leads to it
};

/// The opening along which a loop runs at a use, over a tangent line.
int opening_at(const Recognition& of, const LoopRef& ref, int use) {
  const int count = static_cast<int>(of.model.faces[ref.face].loops[ref.loop].size());
  for (int i = 0; i < std::ssize(of.tangent_openings); ++i) {
    const SkinOutline& here = of.tangent_openings[i].here;
    if (!of.tangent_openings[i].leads_over()) continue;
    for (const LoopRun& run : {here.on_plane, *here.on_bend})
      if (run.loop == ref && run.holds((use + count) % count, count)) return i;
  }
  return -1;
}

std::vector<CutUse> cut_uses(const Recognition& of, const LoopRef& ref) {
  const auto& loop = of.model.faces[ref.face].loops[ref.loop];
  std::vector<CutUse> uses;
  const auto lead_to = [&](const CutUse& next) {
    if (uses.empty() || !uses.back().below || !next.below || next.bridge >= 0) return;
    if (const auto between = edge_between(of, uses.back().use, next.use))
      uses.push_back({*between, -1, true});
  };
  for (int i = 0; i < std::ssize(loop); ++i) {
    if (opening_at(of, ref, i) >= 0) continue;
    if (const FarRun* far = far_run_at(of, ref, i)) {
      for (int k = 0; far->here.first == i && k < std::ssize(far->uses); ++k)
        uses.push_back({far->uses[k], far->stands_for(k, std::ssize(loop)), true, true});
      continue;
    }
    const CoEdge cut = is_beside_form(of, ref.face, loop[i])
                           ? loop[i]
                           : widest_edge(of.model, of.rim, of.skins.thickness, ref.face, loop[i]);
    CutUse next{cut, i, cut.edge != loop[i].edge, false};
    next.bridge = opening_at(of, ref, i - 1);
    lead_to(next);
    uses.push_back(next);
  }
  lead_to(CutUse(uses.front()));
  return uses;
}

/// Whether the edge that is cut beside a joint, on the face across, ends at a vertex too: before
/// the joint as this face runs along it, or after.
bool meets_across(const Recognition& of, int across, const CoEdge& joint, int vertex, bool before) {
  for (const auto& loop : of.model.faces[across].loops)
    for (size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].edge != joint.edge || loop[i].forward == joint.forward) continue;
      const CoEdge& beside = loop[(i + (before ? 1 : loop.size() - 1)) % loop.size()];
      if (is_beside_form(of, across, beside)) return false;
      const CoEdge cut = widest_edge(of.model, of.rim, of.skins.thickness, across, beside);
      return vertex == (before ? vertex_before(of.model, cut) : vertex_after(of.model, cut));
    }
  return false;
}

/// Joints between faces that are both cut wider than the skin reach as far: borders are moved to
/// the ends of those beside them where these lie in their lines.
void extend_joints(const Recognition& of, int face, const std::vector<CutUse>& uses,
                   BorderLoop& read) {
  constexpr double kAside = 1e-6;  // mm, or radians
  const size_t count = uses.size();
  for (size_t i = 0; i < count; ++i) {
    const int across = face_across(of.model.edges[uses[i].use.edge], face);
    auto* segment = std::get_if<Segment>(&read[i].curve);
    if (uses[i].below || !segment || across < 0 || of.skins.skin_of[across] == Skin::none) continue;
    const Vec2 along = (segment->b - segment->a).normalized();
    const size_t last = (i + count - 1) % count, next = (i + 1) % count;
    const Vec2 start = end_of(read[last].curve), end = start_of(read[next].curve);
    const auto moves = [&](const CutUse& beside, const Vec2& to, const Vec2& from, bool before) {
      if (!beside.below || std::abs(cross(along, to - from)) > kAside) return false;
      if (beside.far) return true;
      const int vertex = before ? vertex_after(of.model, beside.use)
                                : vertex_before(of.model, beside.use);
      return meets_across(of, across, uses[i].use, vertex, before);
    };
    const bool longer_before = moves(uses[last], start, segment->a, true);
    const bool longer_after = moves(uses[next], end, segment->b, false);
    if (longer_before) segment->a = start;
    if (longer_after) segment->b = end;
    if (longer_before || longer_after) read[i].edge_length.reset();
  }
}

/// Whether only walls of cuts lie along a loop, and no joints.
bool is_rim_alone(const Recognition& of, const LoopRef& ref) {
  return std::ranges::all_of(of.model.faces[ref.face].loops[ref.loop], [&](const CoEdge& use) {
    const int wall = face_across(of.model.edges[use.edge], ref.face);
    return wall >= 0 && of.rim.part_of[wall] >= 0 && !is_beside_form(of, ref.face, use);
  });
}

struct ReadLoop {
  BorderLoop borders;
  std::vector<int> places;                  // in `borders`, by use
  std::map<int, std::vector<int>> bridges;  // in `borders`, by tangent opening
  std::map<int, int> cuts;                  // where what is cut of it begins
  bool widened = false;
};

/// Leads on from one border to the next along a tangent line over an opening, and round what is cut
/// of it across the line.
void lead_over(const Recognition& of, int number, const SolidSurface& surface, ReadLoop& result,
               const Vec2& start, const Vec2& end) {
  const TangentOpening& opening = of.tangent_openings[number];
  const bool flat = std::holds_alternative<Frame>(surface);
  BorderLoop cut;
  if (!opening.cut_of_bend.empty()) cut = flat ? opening.cut : opening.cut_of_bend;
  result.bridges[number];
  const auto lead = [&](const Vec2& from, const Vec2& to) {
    if (!opening.has_room) return;
    result.bridges[number].push_back(static_cast<int>(result.borders.size()));
    result.borders.push_back({Segment{from, to}});
  };
  if (cut.empty()) return lead(start, end);
  if (!flat)
    cut = shifted(std::move(cut),
                  kTurn * std::round((start.x() - start_of(cut.front().curve).x()) / kTurn));
  lead(start, start_of(cut.front().curve));
  result.cuts[number] = static_cast<int>(result.borders.size());
  std::ranges::copy(cut, std::back_inserter(result.borders));
  lead(end_of(cut.back().curve), end);
}

ReadLoop read_loop(const Recognition& of, const LoopRef& ref, const SolidSurface& surface,
                   double u_near) {
  const SolidFace& face = of.model.faces[ref.face];
  const std::vector<CutUse> uses = cut_uses(of, ref);
  ReadLoop result;
  result.widened = std::ranges::any_of(uses, &CutUse::below);
  const bool only_far = std::ranges::none_of(
      uses, [](const CutUse& use) { return use.below && !use.far; });
  BorderLoop read = read_borders(of.model, mapped(uses, &CutUse::use), surface, u_near,
                                 of.tolerance);
  if (const auto* plane = std::get_if<Frame>(&surface); plane && is_rim_alone(of, ref))
    read = with_bulges(of, *plane, std::move(read));
  const bool bulges = std::ranges::any_of(read, [](const Border& border) { return !border.edge; });
  result.widened |= bulges;
  if (result.widened) extend_joints(of, ref.face, uses, read);
  result.places.assign(of.model.faces[ref.face].loops[ref.loop].size(), -1);
  for (size_t i = 0; i < uses.size(); ++i) {
    if (uses[i].bridge >= 0)
      lead_over(of, uses[i].bridge, surface, result,
                end_of(i > 0 ? result.borders.back().curve : read.back().curve),
                start_of(read[i].curve));
    if (uses[i].below && read[i].edge)
      read[i] = below_skin(std::move(read[i]), face, of.model.edges[uses[i].use.edge].curve,
                           of.tolerance);
    if (const auto as_read = read_face_at(of.model, ref.face, uses[i].use))
      read[i].source_face = *as_read + 1;
    if (result.widened) connect(result.borders, read[i]);
    if (uses[i].border >= 0)
      result.places[uses[i].border] = static_cast<int>(result.borders.size());
    result.borders.push_back(std::move(read[i]));
  }
  if (result.widened) connect(result.borders, Border(result.borders.front()));
  result.widened = bulges || !only_far;
  return result;
}

/// A hole, of one within a bend its narrowest section.
ReadLoop read_hole(const Recognition& of, const LoopRef& ref, const SolidSurface& surface,
                   double u_near) {
  const auto opening = std::ranges::find(of.bend_openings, ref, &BendOpening::here);
  if (opening == of.bend_openings.end() || opening->cut.empty())
    return read_loop(of, ref, surface, u_near);
  const size_t uses = of.model.faces[ref.face].loops[ref.loop].size();
  return {opening->cut, std::vector<int>(uses, -1), {}, {}, false};
}

/// The sheet's face without loops.
Face empty_face(const SolidModel& model, int f, int leader) {
  const SolidFace& stands = model.faces[leader];
  Face face;
  face.source_face = f + 1;
  for (const int other : model.faces[f].merged)
    face.merged_faces.push_back(other + 1);
  face.sense = stands.sense;
  if (const auto* plane = std::get_if<Frame>(&stands.surface))
    face.surface = *plane;
  else
    face.surface = std::get<Developable>(stands.surface);
  return face;
}

/// Takes the loops that a silhouette stands for from it: the outer one stays first, then those that
/// are the skin's own.
void take_silhouette(ReadFace& read, Silhouette silhouette, int outer) {
  const auto is_seen = [&](int l) { return std::ranges::count(silhouette.skin_loops, l) > 0; };
  std::vector<BorderLoop> own = std::move(read.face.loops);
  read.face.loops = {silhouette.outer_kept ? own.front() : silhouette.loops.front()};
  for (int l = 0; l < std::ssize(read.loops); ++l) {
    if (l == outer || is_seen(l)) continue;
    read.face.loops.push_back(std::move(own[read.loops[l].place]));
    read.loops[l].place = static_cast<int>(read.face.loops.size()) - 1;
  }
  const int first = static_cast<int>(read.face.loops.size());
  for (size_t i = 1; i < silhouette.loops.size(); ++i)
    read.face.loops.push_back(silhouette.loops[i]);
  for (const int l : silhouette.skin_loops) {
    ReadFace::Loop& loop = read.loops[l];
    const auto as_read = std::exchange(loop.borders, std::vector<int>(loop.borders.size(), -1));
    const int place_as_read = std::exchange(loop.place, 0);
    loop.widened = false;
    loop.places.resize(as_read.size());
    for (int i = 0; i < std::ssize(as_read); ++i)
      if (const auto at = silhouette.places.find({l, i}); at != silhouette.places.end()) {
        const auto [place, border] = at->second;
        loop.places[i] = place == 0 ? 0 : first + place - 1;
        if (l != outer) loop.place = loop.places[i];
        loop.borders[i] = border;
        read.face.loops[loop.places[i]][border].source_face = own[place_as_read][as_read[i]]
                                                                  .source_face;
      }
  }
  silhouette.first_opening = first;
  read.silhouette = std::move(silhouette);
}

/// Adds what is cut of openings beside bends to the flange in which they lie.
void take_tangent_cuts(ReadFace& result, const Recognition& of, int f) {
  for (int i = 0; i < std::ssize(of.tangent_openings); ++i)
    if (const TangentOpening& opening = of.tangent_openings[i];
        opening.leads_over() && opening.here.on_plane.loop.face == f) {
      if (!opening.cut_of_bend.empty()) continue;
      result.openings[i] = {static_cast<int>(result.face.loops.size()), 0};
      result.face.loops.push_back(opening.cut);
    }
}

}  // namespace

ReadFace read_face(const Recognition& of, int f, int leader) {
  const SolidSurface& surface = of.model.faces[leader].surface;
  const int outer = of.outlines[f].outer;
  ReadFace result;
  result.face = empty_face(of.model, f, leader);
  result.loops.resize(of.model.faces[f].loops.size());
  const auto add = [&](int l, ReadLoop loop) {
    result.loops[l] = {
        static_cast<int>(result.face.loops.size()), std::move(loop.places), {}, loop.widened};
    result.face.loops.push_back(std::move(loop.borders));
  };
  ReadLoop outline = read_loop(of, {f, outer}, surface, of.outlines[leader].u_middle);
  result.bridges = std::move(outline.bridges);
  if (std::holds_alternative<Frame>(surface))
    for (const auto& [opening, border] : outline.cuts)
      result.openings[opening] = {0, border};
  add(outer, std::move(outline));
  const double u_near = middle_u(result.face.loops.front());
  for (int l = 0; l < std::ssize(result.loops); ++l) {
    if (l == outer) continue;
    ReadLoop hole = read_hole(of, {f, l}, surface, u_near);
    // A hole, read from its own first point, may lie a turn away from the face's outer loop.
    if (repeats(result.face.surface)) {
      const double turns = std::round((u_near - middle_u(hole.borders)) / kTurn);
      hole.borders = shifted(std::move(hole.borders), turns * kTurn);
    }
    add(l, std::move(hole));
  }
  // A silhouette has no tangent lines that go on over openings.
  if (auto silhouette = silhouette_of(of, f, leader);
      silhouette && (silhouette->outer_kept || result.bridges.empty()))
    take_silhouette(result, std::move(*silhouette), outer);
  take_tangent_cuts(result, of, f);
  return result;
}

Face turned_by(Face face, double by) {
  const double turns = kTurn * std::round(by / kTurn);
  for (BorderLoop& loop : face.loops)
    loop = shifted(std::move(loop), turns);
  return face;
}

}  // namespace planish::brep
