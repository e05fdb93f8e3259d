#include "bend_openings.hpp"

#include "assembly.hpp"
#include "borders.hpp"
#include "form_volume.hpp"
#include "innermost.hpp"
#include "passages.hpp"
#include "projection.hpp"
#include "skin_outlines.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

// Holes within bends. Both skins may be machined, or the reference skin may be the inside, on which
// a drilled hole is widest. What is cut is the section along the drill whose edges are shortest
// once the bend lies flat: its walls then stand clear of all others.

namespace planish::brep {
namespace {

std::vector<CoEdge> uses_along(const Recognition& of, const RimPart& part, const LoopRef& ref) {
  std::vector<CoEdge> uses;
  for (const CoEdge& use : loop_of(of, ref))
    if (std::ranges::count(part.faces, face_across(of.model.edges[use.edge], ref.face)) > 0)
      uses.push_back(use);
  return uses;
}

const Cylinder* drill_of(const SolidFace& wall) {
  const auto* surface = std::get_if<Developable>(&wall.surface);
  return surface && wall.sense < 0 ? std::get_if<Cylinder>(surface) : nullptr;
}

/// A bend's skin half-way to the other one, flat.
class FlatBend {
 public:
  FlatBend(const Recognition& of, int face)
      : of_(of),
        leader_(of.groups.rows[of.groups.of_face[face]].leader),
        near_(of.outlines[leader_].u_middle),
        middle_(surface(), -of.model.faces[leader_].sense * of.skins.thickness / 2, near_) {}

  BorderLoop read(const std::vector<CoEdge>& uses) const {
    BorderLoop loop;
    for (Border& border :
         read_borders(of_.model, uses, of_.model.faces[leader_].surface, near_, of_.tolerance))
      if (length(border.curve) > of_.tolerance) loop.push_back(std::move(border));
    return loop;
  }
  Vec2 flat(const Border& border, double t) const {
    return middle_.develop(point_at(border.curve, t));
  }
  double area(const BorderLoop& loop) const {
    return std::abs(signed_middle_area(of_, leader_, loop));
  }
  double edge_length(int edge) const {
    constexpr int kSteps = 128;
    const SpaceCurve& curve = of_.model.edges[edge].curve;
    const auto image = [&](int step) {
      const double t = std::lerp(curve.t0, curve.t1, static_cast<double>(step) / kSteps);
      return middle_.develop(parameters_of(surface(), curve.point(t), near_));
    };
    double length = 0.0;
    for (int i = 0; i < kSteps; ++i)
      length += (image(i + 1) - image(i)).norm();
    return length;
  }

 private:
  const Developable& surface() const {
    return std::get<Developable>(of_.model.faces[leader_].surface);
  }
  const Recognition& of_;
  int leader_;
  double near_;
  Development middle_;
};

/// The loop on the reference skin of an opening that lies within a bend there.
std::optional<LoopRef> loop_in_bend(const Recognition& of, const RimPart& part) {
  const auto& here = loops_here(of, part);
  if (!part.within || part.openings != 1 || here.size() != 1 || loops_there(of, part).empty())
    return {};
  const LoopRef& ref = here.front();
  const bool inner = of.outlines[ref.face].outer != ref.loop &&
                     std::holds_alternative<Developable>(of.model.faces[ref.face].surface);
  if (!inner || uses_along(of, part, ref).size() != loop_of(of, ref).size()) return {};
  return ref;
}

/// What all edges of an opening's walls leave open, run as a section that it holds.
BorderLoop cell_within(const Recognition& of, const RimPart& part, const FlatBend& bend,
                       const BorderLoop& section) {
  constexpr double kEnds = 10.0;  // of the tolerance to which borders are read: so far ends are off
  BorderLoop edges;
  for (const int edge : wall_edges(of, part))
    std::ranges::copy(bend.read({{edge, true}}), std::back_inserter(edges));
  const auto curves = mapped(edges, [&](const Border& border) -> PlaneCurve {
    return [&](double t) { return bend.flat(border, t); };
  });
  Box2 box;
  for (const Border& border : section)
    for (const double t : {0.0, 0.25, 0.5, 0.75})
      box.add(bend.flat(border, t));
  const auto cell = innermost_cell(curves, (box.lo + box.hi) / 2, kEnds * of.tolerance);
  const auto cut_along = [&](const std::vector<CellPiece>& pieces) {
    return mapped(pieces,
                  [&](const CellPiece& piece) { return part_of(edges[piece.curve], piece); });
  };
  const BorderLoop cut = cut_along(cell);
  const bool alike = (signed_loop_area(cut) > 0.0) == (signed_loop_area(section) > 0.0);
  return alike ? cut : cut_along(reversed(cell));
}

/// Whether a drill, or what is drawn square to the bend, stands nearly along its normal: of walls
/// that lean more one end is cut.
bool is_square(const Recognition& of, const RimPart& part, const LoopRef& here,
               const Frame& plane) {
  constexpr double kSquare = 0.94;  // cosine of 20°
  const auto& ring = of.outlines[here.face].rings[here.loop];
  Vec3 middle = Vec3::Zero();
  for (const Vec3& point : ring)
    middle += point / static_cast<double>(ring.size());
  return outward_normal_at(of.model.faces[here.face], middle).dot(plane.z) > kSquare &&
         !is_slanted(of, part, plane.z);
}

/// The section along the drill, or what is left open within it, if it is narrower than the skin's
/// outline.
BorderLoop narrower_section(const Recognition& of, const RimPart& part, const LoopRef& here,
                            const FlatBend& bend, const Frame& plane,
                            const std::vector<CoEdge>& section) {
  BorderLoop cut = bend.read(section);
  const BorderLoop own = bend.read(loop_of(of, here));
  if (cut.empty()) return {};
  if (is_square(of, part, here, plane))
    if (auto cell = cell_within(of, part, bend, cut);
        !cell.empty() && bend.area(cell) < bend.area(cut))
      cut = std::move(cell);
  if (bend.area(own) - bend.area(cut) <= kSameOutline * perimeter(cut)) return {};
  for (Border& border : cut) {
    border.edge.reset();
    border.edge_length.reset();
  }
  return cut;
}

/// Whether a skin is machined: the walls along it are not those that let through.
bool is_machined_at(const Recognition& of, const RimPart& part, Skin skin, const Frame& plane,
                    const std::vector<CoEdge>& section) {
  const double noise = kWiderOutline * sum_of(section, [&](const CoEdge& use) {
                         return of.model.edges[use.edge].curve.length();
                       });
  const auto lets_through = [&](int wall) {
    return std::abs(projected_area(of.model, wall, plane)) <= noise &&
           std::ranges::any_of(section, [&](const CoEdge& use) {
             return std::ranges::count(of.model.edges[use.edge].faces, wall) > 0;
           });
  };
  for (const LoopRef& ref : skin == Skin::first ? part.first : part.second)
    for (const CoEdge& use : uses_along(of, part, ref))
      if (lets_through(face_across(of.model.edges[use.edge], ref.face))) return false;
  return is_machined(of, part, skin);
}

}  // namespace

Frame plane_across(const Recognition& of, const RimPart& part) {
  constexpr double kAlong = 0.7;  // cosine: a wall of the opening, and no other
  Vec3 sum = Vec3::Zero(), origin = Vec3::Zero();
  std::optional<Vec3> flange;
  for (const LoopRef& ref : loops_here(of, part))
    for (const CoEdge& use : uses_along(of, part, ref)) {
      const SpaceCurve& curve = of.model.edges[use.edge].curve;
      for (const double share : {0.25, 0.75}) {
        origin = curve.point(std::lerp(curve.t0, curve.t1, share));
        sum += curve.length() * outward_normal_at(of.model.faces[ref.face], origin);
      }
      if (const auto* plane = std::get_if<Frame>(&of.model.faces[ref.face].surface))
        flange = plane->z;
    }
  const Vec3 outwards = sum.normalized();
  for (const int f : part.faces)
    if (const Cylinder* drill = drill_of(of.model.faces[f]))
      if (const double cosine = drill->frame.z.dot(outwards); std::abs(cosine) > kAlong)
        return frame_from_normal(origin, std::copysign(1.0, cosine) * drill->frame.z);
  return frame_from_normal(origin, flange.value_or(outwards));
}

std::vector<BendOpening> bend_openings(const Recognition& of) {
  std::vector<BendOpening> found;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    const auto here = loop_in_bend(of, part);
    if (!here) continue;
    const FlatBend bend(of, here->face);
    const Frame plane = plane_across(of, part);
    const auto chains = passages(of, part, plane, [&](int edge) { return bend.edge_length(edge); });
    if (chains.size() != 1) continue;
    BendOpening opening{p, *here, narrower_section(of, part, *here, bend, plane, chains.front())};
    opening.up = is_machined_at(of, part, of.skin, plane, chains.front());
    opening.down = is_machined_at(of, part, other_skin(of.skin), plane, chains.front());
    if (opening.up || opening.down || !opening.cut.empty()) found.push_back(std::move(opening));
  }
  return found;
}

}  // namespace planish::brep
