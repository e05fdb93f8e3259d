#include "wide_cuts.hpp"

#include "passages.hpp"
#include "skin_outlines.hpp"
#include "widest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Along an edge of the skin the cut is too wide if the wall below leans back, or ends on a floor,
// before it reaches the other skin. How far the section lies within, seen along the skin's normal,
// is looked for at points of both.

namespace planish::brep {
namespace {

/// Sine from which a wall is machined: holes drilled straight through a bend lean less where they
/// are still holes.
constexpr double kMachined = 0.35;
constexpr int kCoarse = 32;  // steps along an edge
constexpr int kFine = 1024;  // the same of the section, of which the nearest point is taken

std::vector<Vec3> points_of(const SpaceCurve& curve, int steps) {
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(curve.point(std::lerp(curve.t0, curve.t1, static_cast<double>(i) / steps)));
  return points;
}

bool looks_out(const Recognition& of, int face, const Vec3& point, const Vec3& outwards) {
  const SolidFace& wall = of.model.faces[face];
  return !std::holds_alternative<DoublyCurved>(wall.surface) &&
         outward_normal_at(wall, point).dot(outwards) > kMachined;
}

/// Whether the wall along an edge of the skin widens the opening there alone.
bool is_machined(const Recognition& of, int skin_face, const CoEdge& use, int wall) {
  const SpaceCurve& curve = of.model.edges[use.edge].curve;
  const Vec3 middle = curve.point((curve.t0 + curve.t1) / 2);
  const Vec3 outwards = outward_normal_at(of.model.faces[skin_face], middle);
  bool floor = false;
  for (const auto& loop : of.model.faces[wall].loops)
    for (const CoEdge& far : loop) {
      const int next = face_across(of.model.edges[far.edge], wall);
      if (next < 0 || next == wall) continue;
      const Skin skin = of.skins.skin_of[next];
      if (skin == other_skin(of.skin)) return false;
      const SpaceCurve& edge = of.model.edges[far.edge].curve;
      floor |= skin == Skin::none &&
               looks_out(of, next, edge.point((edge.t0 + edge.t1) / 2), outwards);
    }
  return floor || looks_out(of, wall, middle, outwards) ||
         (std::holds_alternative<DoublyCurved>(of.model.faces[wall].surface) &&
          leans_back(of.model, skin_face, use));
}

/// How far a section lies within an edge of the skin, seen along the skin's normal.
double width_within(const Recognition& of, int skin_face, const CoEdge& use,
                    const std::vector<Vec3>& section) {
  double widest = 0.0;
  for (const Vec3& point : points_of(of.model.edges[use.edge].curve, kCoarse)) {
    const Vec3 outwards = outward_normal_at(of.model.faces[skin_face], point);
    const Vec3 nearest = *std::ranges::min_element(
        section, {}, [&](const Vec3& other) { return (other - point).squaredNorm(); });
    const Vec3 off = nearest - point;
    widest = std::max(widest, (off - off.dot(outwards) * outwards).norm());
  }
  return widest;
}

/// Points of what passes through.
std::vector<Vec3> section_points(const Recognition& of, const RimPart& part) {
  std::vector<Vec3> points;
  for (const auto& chain : passages(of, part, plane_across(of, part)))
    for (const CoEdge& use : chain)
      std::ranges::copy(points_of(of.model.edges[use.edge].curve, kFine),
                        std::back_inserter(points));
  return points;
}

/// Whether a part is an opening with a bend along it that is read from the skin.
bool is_at_bend(const Recognition& of, const SheetMap& map, int p) {
  const RimPart& part = of.rim.parts[p];
  const auto& here = loops_here(of, part);
  return part.within && part.openings == 1 && !loops_there(of, part).empty() &&
         std::ranges::count(of.tangent_openings, p, &TangentOpening::part) == 0 &&
         std::ranges::count(of.bend_openings, p, &BendOpening::part) == 0 &&
         std::ranges::none_of(here, [&](const LoopRef& ref) { return map.is_seen(ref); }) &&
         std::ranges::any_of(here, [&](const LoopRef& ref) {
           return !std::holds_alternative<Frame>(of.model.faces[ref.face].surface);
         });
}

}  // namespace

void measure_wide_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    if (!is_at_bend(of, map, p)) continue;
    const std::vector<Vec3> section = section_points(of, of.rim.parts[p]);
    if (section.empty()) continue;
    MeasuredOpening measured;
    for (const LoopRef& ref : loops_here(of, of.rim.parts[p]))
      for (const CoEdge& use : loop_of(of, ref)) {
        const int wall = face_across(of.model.edges[use.edge], ref.face);
        const auto at = map.borders.find({ref.face, use.edge, use.forward});
        if (wall < 0 || of.rim.part_of[wall] != p || at == map.borders.end() ||
            builder[at->second].edge != use.edge + 1 || !is_machined(of, ref.face, use, wall))
          continue;
        const double width = width_within(of, ref.face, use, section);
        if (width <= measured.intrusion) continue;
        measured.face = at->second.face;
        measured.loop = at->second.loop;
        measured.border = at->second.border;
        measured.intrusion = width;
      }
    if (measured.border) builder.add_opening(measured);
  }
}

}  // namespace planish::brep
