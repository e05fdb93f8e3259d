#include "form_openings.hpp"

#include "borders.hpp"
#include "form_volume.hpp"
#include "passages.hpp"
#include "tangent_runs.hpp"
#include "widest.hpp"

#include <planish/geometry/fit.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// What is cut within a form (math.md#pilot-holes). Passages of the form (passages.cpp) are holes; a
// narrow one beside a free edge is a slit. A hole drawn out of the sheet is pierced smaller: by the
// volume identity, what is left beside the pilot hole makes the form. Where the hole is no more
// than cut out (an emboss's floor), it is the hole itself.

namespace planish::brep {
namespace {

/// A passage narrower than this on average, of the thickness, is a slit: the form's edge was cut
/// and not moved away from the sheet's.
constexpr double kSlit = 0.5;
/// What is narrower, of the thickness, is closed as it is seen and cannot be cut.
constexpr double kNarrowest = 0.01;
/// An extruded hole is drawn from the sheet round its edge: a rim wider than this on its entrance
/// side, of the thickness, is an emboss, whose hole is not what it was drawn from.
constexpr double kWidestEntrance = 2.0;
/// How far a section may lie outside its form's outline and still be taken for inside, mm.
constexpr double kOutside = 0.01;
/// Chords by which loops are measured, of the thickness.
constexpr double kChord = 1e-3;

/// A passage as it is seen along the normal of the sheet.
struct Section {
  BorderLoop borders;
  Loop loop;          ///< the same as curves, neighbours of one line or circle joined
  double area = 0.0;  ///< what it leaves open; below 0 where the form's edge covers the sheet's
  double perimeter = 0.0;
};

Loop curves_of(const BorderLoop& borders) { return mapped(borders, &Border::curve); }

Section section_of(const Recognition& of, const std::vector<CoEdge>& chain, const Frame& plane) {
  Section section;
  section.borders = read_borders(of.model, chain, plane, 0.0, of.tolerance);
  section.loop = merged(curves_of(section.borders), of.tolerance).loop;
  section.area = -signed_area(section.loop);
  section.perimeter = length(section.loop);
  return section;
}

/// Whether a section is wider than this share of the thickness, on average.
bool is_wider(const Section& section, double share, double thickness) {
  return 2 * section.area > share * thickness * section.perimeter;
}

std::vector<std::vector<Vec2>> rings_of(const Recognition& of, const RimPart& part,
                                        const std::vector<LoopRef>& loops, const Frame& plane) {
  std::vector<std::vector<Vec2>> rings;
  if (const auto beside = outline_beside_bend(of, number_of(of, part), of.skin))
    return {
        sampled(curves_of(seen_outline(of, *beside, plane, of.skin)), kChord * of.skins.thickness)};
  for (const LoopRef& ref : loops) {
    const auto& loop = of.model.faces[ref.face].loops[ref.loop];
    const BorderLoop borders = read_borders(of.model, loop, plane, 0.0, of.tolerance);
    rings.push_back(sampled(curves_of(borders), kChord * of.skins.thickness));
  }
  return rings;
}

bool lies_inside(const Loop& loop, const std::vector<std::vector<Vec2>>& outlines,
                 double tolerance) {
  for (const Curve2& curve : loop)
    for (const double t : {0.0, 0.2, 0.5, 0.8}) {
      const Vec2 p = point_at(curve, t);
      const bool near = std::ranges::any_of(outlines, [&](const std::vector<Vec2>& ring) {
        return distance_to_ring(ring, p) <= tolerance;
      });
      if (!near && !inside(outlines, p)) return false;
    }
  return true;
}

Vec2 centroid(const std::vector<Vec2>& ring) {
  Vec2 sum = Vec2::Zero();
  double area = 0.0;
  for (const auto& [from, to] : sides_of(ring)) {
    const Vec2 a = from - ring.front(), b = to - ring.front();
    sum += cross(a, b) * (a + b) / 3;
    area += cross(a, b);
  }
  return ring.front() + sum / area;
}

/// The section shrunk about its centroid to an area: a circle about the middle of a round one.
Loop shrunk(const Section& section, double area, double chord) {
  const Vec2 centre = section.loop.size() == 1 && std::holds_alternative<Arc>(section.loop.front())
                          ? std::get<Arc>(section.loop.front()).center
                          : centroid(sampled(section.loop, chord));
  return scaled(section.loop, std::sqrt(area / section.area), centre);
}

BorderLoop as_borders(const Loop& loop) {
  return mapped(loop, [&](const Curve2& curve) { return Border{curve}; });
}

/// Mean width of the form between its hole and its outline on the side from which it was drawn.
double entrance_width(const Recognition& of, const RimPart& part, const Section& section) {
  double width = std::numeric_limits<double>::infinity();
  for (const auto* loops : {&part.first, &part.second}) {
    double area = 0.0, perimeter = 0.0;
    for (const LoopRef& ref : *loops) {
      const auto& face = of.model.faces[ref.face];
      const BorderLoop borders = read_borders(of.model, face.loops[ref.loop],
                                              std::get<Frame>(face.surface), 0.0, of.tolerance);
      area += loop_area(borders);
      perimeter += length(curves_of(borders));
    }
    width = std::min(width, 2 * (area - section.area) / (perimeter + section.perimeter));
  }
  return width;
}

/// What is pierced where a hole is drawn out of the sheet, so that what is left makes the form: by
/// the volume identity. The hole itself where that is more, or nothing.
Loop pilot_of(const Recognition& of, const RimPart& part, const Section& section) {
  const auto excess = form_volume(of, part);
  if (part.openings != 1 || !excess) return section.loop;
  if (entrance_width(of, part, section) > kWidestEntrance * of.skins.thickness) return section.loop;
  const double area = -*excess / of.skins.thickness;
  constexpr double kSmaller = 1.0 - 1e-6;  // of the hole: what no drill tells apart is the hole
  if (!(area > 0.0 && area < kSmaller * section.area)) return section.loop;
  const double chord = kChord * of.skins.thickness;
  Loop pilot = shrunk(section, area, chord);
  return lies_inside(pilot, {sampled(section.loop, chord)}, kOutside) ? pilot : section.loop;
}

/// Along how much of its borders a face touches the other skin, mm.
double length_there(const Recognition& of, int face) {
  double sum = 0.0;
  for (const auto& loop : of.model.faces[face].loops)
    for (const CoEdge& use : loop) {
      const int other = face_across(of.model.edges[use.edge], face);
      if (other >= 0 && of.skins.skin_of[other] == other_skin(of.skin))
        sum += of.model.edges[use.edge].curve.length();
    }
  return sum;
}

/// Whether the sheet ends at an edge of its reference skin: in a wall of its thickness, the rounded
/// or chamfered edges of which are strips of their own.
bool ends_at(const Recognition& of, int skin_face, const CoEdge& use) {
  constexpr int kMostStrips = 6;
  constexpr double kBeyond = 0.05;  // of the thickness: farther out a form begins
  constexpr double kMost = 0.5;     // of the edge: less is the end of a rounding beside it
  const double least = kMost * of.model.edges[use.edge].curve.length();
  int from = skin_face, edge = use.edge;
  for (int i = 0; i < kMostStrips; ++i) {
    const int wall = face_across(of.model.edges[edge], from);
    if (wall < 0 || of.rim.part_of[wall] < 0) return false;
    if (length_there(of, wall) > least) return true;
    const auto next = opposite_edge(of.model, wall, edge);
    if (!next) return false;
    const SpaceCurve& curve = of.model.edges[*next].curve;
    const double depth = depth_below(of.model.faces[skin_face], of.outlines[skin_face],
                                     curve.point((curve.t0 + curve.t1) / 2)) /
                         of.skins.thickness;
    if (depth < -kBeyond || depth > 1.0 + kBeyond) return false;
    from = wall;
    edge = *next;
  }
  return false;
}

/// Edges of the reference skin along which the sheet ends at the form: chains of them, loop by
/// loop.
std::vector<std::vector<CoEdge>> free_edges(const Recognition& of, const RimPart& part) {
  std::vector<std::vector<CoEdge>> chains;
  for (const LoopRef& ref : loops_here(of, part)) {
    const auto& loop = of.model.faces[ref.face].loops[ref.loop];
    std::vector<bool> free;
    for (const CoEdge& use : loop) {
      const int wall = face_across(of.model.edges[use.edge], ref.face);
      free.push_back(std::ranges::count(part.faces, wall) > 0 && ends_at(of, ref.face, use));
    }
    const auto formed = std::ranges::find(free, false);
    const size_t first = formed == free.end() ? 0 : static_cast<size_t>(formed - free.begin());
    bool begun = false;
    for (size_t i = 0; i < loop.size(); ++i) {
      const size_t at = (first + i) % loop.size();
      if (free[at]) {
        if (!begun) chains.emplace_back();
        chains.back().push_back(loop[at]);
      }
      begun = free[at];
    }
  }
  return chains;
}

/// A free edge where its wall reaches farthest: below its rounding, whose ends on the skin are no
/// edges of the sheet.
std::vector<CoEdge> widest_chain(const Recognition& of, const RimPart& part,
                                 const std::vector<CoEdge>& chain) {
  std::vector<CoEdge> moved;
  for (const LoopRef& ref : loops_here(of, part))
    for (const CoEdge& use : of.model.faces[ref.face].loops[ref.loop]) {
      if (std::ranges::find(chain, use.edge, &CoEdge::edge) == chain.end()) continue;
      const CoEdge widest = widest_edge(of.model, of.rim, of.skins.thickness, ref.face, use);
      if (widest.edge != use.edge) moved.push_back(widest);
    }
  return moved.empty() ? chain : moved;
}

/// The free edge beside a narrow passage; taken off the list.
std::optional<BorderLoop> slit_of(const Recognition& of, const RimPart& part,
                                  const Section& section, const Frame& plane,
                                  std::vector<std::vector<CoEdge>>& free) {
  for (auto chain = free.begin(); chain != free.end(); ++chain) {
    BorderLoop borders = read_borders(of.model, widest_chain(of, part, *chain), plane, 0.0,
                                      of.tolerance);
    const Vec2 middle = point_at(borders[borders.size() / 2].curve, 0.5);
    const bool beside = std::ranges::any_of(section.loop, [&](const Curve2& curve) {
      return nearest(curve, middle).distance <= kSlit * of.skins.thickness;
    });
    if (!beside) continue;
    free.erase(chain);
    return borders;
  }
  return {};
}

}  // namespace

int hidden_openings(const Recognition& of, const RimPart& part) {
  const auto is_island = [&](const LoopRef& ref) {
    return std::holds_alternative<Frame>(of.model.faces[ref.face].surface) &&
           !opening_in_plane(of, ref);
  };
  const auto islands = std::ranges::count_if(part.first, is_island) +
                       std::ranges::count_if(part.second, is_island);
  return std::max(0, part.openings - static_cast<int>(islands));
}

void add_form_openings(FormedFeature& feature, const Frame& plane, const Recognition& of,
                       const RimPart& part) {
  if (part.openings <= 0) return;
  const auto& here = loops_here(of, part);
  const auto& there = loops_there(of, part);
  if (here.empty() || there.empty()) {
    feature.own_openings += hidden_openings(of, part);
    return;
  }
  feature.lost_openings = part.openings;
  const auto in_plane = [&](const std::vector<LoopRef>& loops, Skin skin) {
    return std::ranges::all_of(loops,
                               [&](const LoopRef& ref) { return opening_in_plane(of, ref); }) ||
           outline_beside_bend(of, number_of(of, part), skin);
  };
  if (!in_plane(here, of.skin) || !in_plane(there, other_skin(of.skin))) return;
  const auto outlines = rings_of(of, part, here, plane);
  auto free = free_edges(of, part);
  for (const auto& chain : passages(of, part, plane)) {
    const Section section = section_of(of, chain, plane);
    const auto slit = is_wider(section, kSlit, of.skins.thickness)
                          ? std::nullopt
                          : slit_of(of, part, section, plane, free);
    if (slit) {
      feature.slits.push_back(*slit);
      --feature.lost_openings;
    } else if (is_wider(section, kNarrowest, of.skins.thickness) &&
               lies_inside(section.loop, outlines, kOutside)) {
      feature.openings.push_back(
          {as_borders(pilot_of(of, part, section)), as_borders(section.loop)});
      --feature.lost_openings;
    }
  }
}

}  // namespace planish::brep
