#include "slanted_cuts.hpp"

#include "borders.hpp"
#include "form_volume.hpp"
#include "skin_outlines.hpp"
#include "widest.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>

// Cuts that are not square to the sheet (math.md#slanted-cuts): saw cuts, mitres. The pattern keeps
// the reference skin's outline there, or that of a window on the other skin, and the volume that
// the solid has more or less is half the difference of the skins' areas, as walls between them are
// straight. Nothing is measured where chamfers or sharp bends make the skins differ too.

namespace planish::brep {
namespace {

/// Sine of the slope from which a wall is a slanted cut: 3°, more than draft and rounding cause.
constexpr double kSlantedWall = 0.05;

/// Whether a part is nothing but walls of one cut, along loops that are not openings of planes:
/// those are cut on their own (features.cpp).
bool is_plain_cut(const Recognition& of, const RimPart& part) {
  const auto& here = loops_here(of, part);
  const auto& there = loops_there(of, part);
  const auto in_plane = [&](const LoopRef& ref) { return opening_in_plane(of, ref); };
  return part.within && !here.empty() && !there.empty() && std::ranges::none_of(here, in_plane) &&
         std::ranges::none_of(there, in_plane);
}

/// Sine by which the wall at the edge of a skin face leans back from it; 0 if that is no slant, or
/// is not known.
double wall_slope(const Recognition& of, int skin_face, const CoEdge& use) {
  const SolidEdge& edge = of.model.edges[use.edge];
  const int wall = face_across(edge, skin_face);
  if (wall < 0 || of.rim.part_of[wall] < 0) return 0.0;
  if (std::holds_alternative<DoublyCurved>(of.model.faces[wall].surface)) return 0.0;
  const Vec3 middle = edge.curve.point((edge.curve.t0 + edge.curve.t1) / 2);
  const double slope = outward_normal_at(of.model.faces[wall], middle)
                           .dot(outward_normal_at(of.model.faces[skin_face], middle));
  return std::abs(slope) > kSlantedWall ? slope : 0.0;
}

/// The side to which a cut edge opens if it is slanted: the one from which its wall is seen.
FormSide open_side(const Recognition& of, int skin_face, const CoEdge& use) {
  const double slope = wall_slope(of, skin_face, use);
  const int wall = face_across(of.model.edges[use.edge], skin_face);
  if (slope == 0.0 || !reaches(of, wall, other_skin(of.skin))) return FormSide::both;
  return slope > 0.0 ? FormSide::up : FormSide::down;
}

/// The edges of a wall on a skin.
std::vector<const SpaceCurve*> edges_on(const Recognition& of, int wall, Skin skin) {
  std::vector<const SpaceCurve*> edges;
  for (const auto& loop : of.model.faces[wall].loops)
    for (const CoEdge& use : loop)
      if (const int other = face_across(of.model.edges[use.edge], wall);
          other >= 0 && of.skins.skin_of[other] == skin)
        edges.push_back(&of.model.edges[use.edge].curve);
  return edges;
}

/// Along a line beyond its ends, too.
double distance_along(const SpaceCurve& curve, const Vec3& p) {
  if (curve.kind != SpaceCurve::Kind::line) return curve.distance(p);
  return (p - curve.start).cross((curve.end - curve.start).normalized()).norm();
}

/// How far apart the ends of a slanted wall lie, seen along the normal of the skin.
double width_of_slant(const Recognition& of, int skin_face, const CoEdge& use) {
  const SpaceCurve& here = of.model.edges[use.edge].curve;
  const int wall = face_across(of.model.edges[use.edge], skin_face);
  const auto there = edges_on(of, wall, other_skin(of.skin));
  if (there.empty()) return 0.0;
  double width = 0.0;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const Vec3 p = here.point(std::lerp(here.t0, here.t1, share));
    const Vec3 below = p - of.skins.thickness * outward_normal_at(of.model.faces[skin_face], p);
    const auto off = mapped(there, [&](const SpaceCurve* curve) {
      return there.size() == 1 ? distance_along(*curve, below) : curve->distance(below);
    });
    width = std::max(width, std::ranges::min(off));
  }
  return width;
}

/// Sets what the slanted cut follows on one side of a part, and how far the other skin lies off.
void follow_borders(FormedFeature& feature, const SheetMap& map, const Recognition& of,
                    const RimPart& part) {
  for (const LoopRef& ref : loops_here(of, part)) {
    const auto& loop = of.model.faces[ref.face].loops[ref.loop];
    for (int i = 0; i < std::ssize(loop); ++i) {
      const auto border = map.borders.find({ref.face, loop[i].edge, loop[i].forward});
      if (border == map.borders.end() || open_side(of, ref.face, loop[i]) != feature.side) continue;
      feature.along.push_back(border->second);
      const bool within = feature.side == FormSide::down || far_run_at(of, ref, i);
      const double width = width_of_slant(of, ref.face, loop[i]);
      const double most = std::max(width, std::abs(feature.beyond_cut.value_or(0.0)));
      if (width > 0.0) feature.beyond_cut = within ? -most : most;
    }
  }
}

/// Area of a skin face half-way to the other skin, its openings in planes filled.
double filled_area(const Recognition& of, int f) {
  const SolidFace& face = of.model.faces[f];
  const double u_near = of.outlines[f].u_middle;
  double area = 0.0;
  for (int l = 0; l < std::ssize(face.loops); ++l)
    if (!opening_in_plane(of, {f, l}))
      area += signed_middle_area(
          of, f, read_borders(of.model, face.loops[l], face.surface, u_near, of.tolerance));
  return std::abs(area);
}

/// How much more area than the reference skin has is left where windows are cut along the other
/// one.
double left_at_windows(const SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  std::set<LoopRef> loops;
  for (const FarRun& run : of.far_runs)
    loops.insert(run.here.loop);
  return sum_of(loops, [&](const LoopRef& ref) {
    const SolidFace& face = of.model.faces[ref.face];
    const BorderRef& cut = map.cut_loops.at(ref);
    const BorderLoop own = read_borders(of.model, face.loops[ref.loop], face.surface,
                                        of.outlines[ref.face].u_middle, of.tolerance);
    return std::abs(signed_middle_area(of, ref.face, builder.sheet()[cut.face].loops[cut.loop])) -
           std::abs(signed_middle_area(of, ref.face, own));
  });
}

/// What the solid holds beyond the reference skin's outline over the whole thickness: straight
/// walls between two skins leave half of the difference (math.md#slanted-cuts).
double slanted_volume(const Recognition& of) {
  double difference = 0.0;
  for (int f = 0; f < std::ssize(of.model.faces); ++f)
    if (of.skins.skin_of[f] != Skin::none)
      difference += (of.skins.skin_of[f] == of.skin ? -1.0 : 1.0) * filled_area(of, f);
  return difference * of.skins.thickness / 2;
}

}  // namespace

bool is_chamfered(const Recognition& of, const RimPart& part, const LoopRef& ref) {
  const auto& loop = of.model.faces[ref.face].loops[ref.loop];
  const Skin across = other_skin(of.skins.skin_of[ref.face]);
  return std::ranges::any_of(loop, [&](const CoEdge& use) {
    const int wall = face_across(of.model.edges[use.edge], ref.face);
    if (std::ranges::count(part.faces, wall) == 0 || reaches(of, wall, across)) return false;
    return wall_slope(of, ref.face, use) > 0.0 || leans_back(of.model, ref.face, use);
  });
}

void add_slanted_cuts(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                      const std::set<int>& measured) {
  if (!map.widened.empty() || !of.skins.sharp.empty()) return;
  bool found = false;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    if (!is_plain_cut(of, part)) continue;
    for (const FormSide side : {FormSide::up, FormSide::down}) {
      FormedFeature feature;
      feature.kind = "slanted cut";
      feature.side = side;
      follow_borders(feature, map, of, part);
      if (feature.along.empty()) continue;
      feature.source_face = part.faces.front() + 1;
      feature.face = feature.along.front().face;
      builder.add_feature(std::move(feature));
      found |= !measured.contains(p);
    }
  }
  // The skins of formed sheets differ by their forms too.
  const auto& features = builder.sheet().features;
  const bool formed = std::ranges::any_of(
      features, [](const FormedFeature& one) { return one.kind == "formed"; });
  // Skins differ by chamfers and by what is machined over tangent lines, too, which count already.
  const bool alone = of.tangent_openings.empty() && measured.empty();
  if (found && !formed)
    builder.add_form_volume(
        alone ? std::optional(slanted_volume(of) -
                              of.skins.thickness * left_at_windows(builder, map, of))
              : std::nullopt);
}

}  // namespace planish::brep
