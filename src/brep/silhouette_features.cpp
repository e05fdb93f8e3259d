#include "silhouette_features.hpp"

#include "borders.hpp"
#include "divided_skin.hpp"
#include "form_volume.hpp"
#include "narrowest.hpp"
#include "projection.hpp"
#include "skin_outlines.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <cmath>

// A silhouette is what the saw or the laser cuts; the rest is a drawing of what is machined after
// it. Its volume is summed over the faces between the skins, column by column: what looks up ends
// one, what looks down begins one.

namespace planish::brep {
namespace {

/// What is known of a face with a silhouette.
struct SeenFace {
  const Recognition& of;
  const SheetMap& map;
  int face = 0;
  const Silhouette& silhouette;

  FaceId id() const { return map.face_id.at(face); }
  const RimPart& part(int p) const { return of.rim.parts[p]; }
};

/// Loops of the face that were taken from the silhouette.
std::vector<int> cut_loops(const SeenFace& seen) {
  const int openings = static_cast<int>(seen.silhouette.loops.size()) - 1;
  std::vector<int> loops;
  if (!seen.silhouette.outer_kept) loops.push_back(0);
  for (int i = 0; i < openings; ++i)
    loops.push_back(seen.silhouette.first_opening + i);
  return loops;
}

/// What the solid has beyond the plain sheet under the cut, mm³: between the skins, what stands not
/// upright; and the other skin where it has another outline than the cut. Empty at sharp bends, by
/// which outlines of the skins differ too, and where the other skin's goes on over a bend.
std::optional<double> volume_beyond(const SeenFace& seen, const Frame& plane, double cut_area) {
  const Recognition& of = seen.of;
  if (!of.skins.sharp.empty() || seen.silhouette.over_bend) return {};
  double volume = 0.0, there = 0.0;
  for (const int p : seen.silhouette.parts)
    for (const LoopRef& ref : loops_there(of, seen.part(p)))
      if (lies_opposite(of, seen.face, ref.face))
        there += signed_loop_area(seen_through(of, ref, plane));
  for (const int f : seen.silhouette.leaning)
    volume += volume_over(of.model, f, plane);
  return volume + (there - cut_area) * of.skins.thickness;
}

/// Whether an outline is one of the loops that are cut.
bool is_cut(const BorderLoop& outline, const Face& face) {
  const Box2 box = bounds(outline);
  return std::ranges::any_of(face.loops, [&](const BorderLoop& cut) {
    const Box2 other = bounds(cut);
    return !is_wider(outline, cut) && !is_wider(cut, outline) &&
           std::max((box.lo - other.lo).norm(), (box.hi - other.hi).norm()) < kWiderOutline;
  });
}

bool is_outer(const Recognition& of, const LoopRef& ref) {
  return of.outlines[ref.face].outer == ref.loop;
}

/// What is machined off at a loop: a recess where a floor is level with the sheet, a groove where a
/// skin is divided.
const char* kind_of(const SeenFace& seen, const RimPart& part, const LoopRef& ref) {
  const Recognition& of = seen.of;
  constexpr double kLevel = 1.0 - 1e-6;  // cosine
  const Vec3& normal = std::get<Frame>(of.model.faces[seen.face].surface).z;
  const bool level = std::ranges::any_of(part.faces, [&](int f) {
    const auto* plane = std::get_if<Frame>(&of.model.faces[f].surface);
    return plane && std::abs(plane->z.dot(normal)) > kLevel;
  });
  const bool divided = std::ranges::count_if(loops_there(of, part), [&](const LoopRef& one) {
                         return is_outer(of, one) && lies_opposite(of, seen.face, one.face);
                       }) > 1;
  return level || divided ? "pocket" : is_outer(of, ref) ? "chamfer" : "countersink";
}

/// The skin's own loops along a part, with those of faces that grooves cut off from it.
std::vector<LoopRef> loops_on_skin(const SeenFace& seen, const RimPart& part) {
  const Recognition& of = seen.of;
  std::vector<LoopRef> loops;
  std::ranges::copy_if(loops_here(of, part), std::back_inserter(loops),
                       [&](const LoopRef& ref) { return ref.face == seen.face; });
  for (const int f : part.faces)
    if (in_plane_of(of.model, f, seen.face, of.skins.spread))
      for (int l = 0; l < std::ssize(of.model.faces[f].loops); ++l)
        loops.push_back({f, l});
  return loops;
}

/// Of a part along the skins' loops; those of the other skin that are not drawn yet.
void draw_outlines(SheetBuilder& builder, const SeenFace& seen, const RimPart& part,
                   std::set<LoopRef>& drawn) {
  const Recognition& of = seen.of;
  const auto& plane = std::get<Frame>(builder[seen.id()].surface);
  const auto draw = [&](const LoopRef& ref, FormSide side, BorderLoop outline) {
    if (is_cut(outline, builder[seen.id()])) return;
    FormedFeature feature = feature_of(kind_of(seen, part, ref), side, part.faces.front(),
                                       seen.id());
    feature.outlines.push_back(std::move(outline));
    builder.add_feature(std::move(feature));
  };
  for (const LoopRef& ref : loops_on_skin(seen, part))
    draw(ref, FormSide::up, read_borders(of.model, loop_of(of, ref), plane, 0.0, of.tolerance));
  for (const LoopRef& ref : loops_there(of, part))
    if (lies_opposite(of, seen.face, ref.face) && drawn.insert(ref).second)
      draw(ref, FormSide::down, seen_through(of, ref, plane));
}

/// Openings of the solid beyond those that are seen through. An outline counts none, whether it is
/// the rim's on either skin or that of an island in a recess.
int openings_closed(const SeenFace& seen) {
  int through = 1 - static_cast<int>(seen.silhouette.loops.size());
  if (!seen.silhouette.outer_kept) ++through;
  for (const int p : seen.silhouette.parts) {
    through += seen.part(p).openings;
    for (const auto* loops : {&seen.part(p).first, &seen.part(p).second})
      through -= static_cast<int>(std::ranges::count_if(*loops, [&](const LoopRef& ref) {
        return seen.of.outlines[ref.face].outer == ref.loop;
      }));
  }
  return std::max(0, through);
}

MeasuredOutline measured_outline(SheetBuilder& builder, FaceId id, const std::vector<int>& ledges,
                                 const Recognition& of, double lacking) {
  const auto& plane = std::get<Frame>(builder[id].surface);
  const Reach reach = reach_beyond(of, ledges, plane, builder[id].loops.front());
  return {id, reach.at, reach.beyond, lacking};
}

}  // namespace

double silhouette_area(const Sheet& sheet, const SheetMap& map, const Recognition& of, int face) {
  const SeenFace seen{of, map, face, map.silhouettes.at(face)};
  return sum_of(cut_loops(seen),
                [&](int l) { return signed_loop_area(sheet[seen.id()].loops[l]); });
}

std::optional<double> volume_beyond_silhouette(const Sheet& sheet, const SheetMap& map,
                                               const Recognition& of, int face) {
  const SeenFace seen{of, map, face, map.silhouettes.at(face)};
  return volume_beyond(seen, std::get<Frame>(sheet[seen.id()].surface),
                       silhouette_area(sheet, map, of, face));
}

void add_silhouette(SheetBuilder& builder, const SheetMap& map, const Recognition& of, int face) {
  const SeenFace seen{of, map, face, map.silhouettes.at(face)};
  const auto& plane = std::get<Frame>(builder[seen.id()].surface);
  const std::vector<int> cut = cut_loops(seen);
  const auto beyond = volume_beyond_silhouette(builder.sheet(), map, of, face);
  builder.add_outline(measured_outline(builder, seen.id(), ledges_of(of, face), of,
                                       std::max(0.0, -beyond.value_or(0.0))));
  const auto drawn_before = builder.sheet().features.size();
  std::set<LoopRef> far;
  for (const int p : seen.silhouette.parts)
    draw_outlines(builder, seen, seen.part(p), far);
  const bool drawn = builder.sheet().features.size() > drawn_before;
  for (const int l : cut) {
    if (l == 0) continue;
    const BorderLoop& loop = builder.sheet()[seen.id()].loops[l];
    MeasuredOpening opening{seen.id(), l};
    opening.lacking = loop_area(loop) * of.skins.thickness;
    for (const int p : seen.silhouette.parts)
      if (!seen.silhouette.over_bend)
        opening.intrusion = std::max(opening.intrusion,
                                     intrusion_into(of, seen.part(p), plane, loop));
    builder.add_opening(opening);
  }
  if (!seen.silhouette.over_bend) builder.add_form_volume(beyond);
  if (!drawn && std::abs(beyond.value_or(0.0)) > kWiderOutline * of.skins.thickness) {
    FormedFeature groove = feature_of("pocket", FormSide::both,
                                      seen.part(seen.silhouette.parts.front()).faces.front(),
                                      seen.id());
    groove.along = {{seen.id(), cut.back(), 0}};
    builder.add_feature(std::move(groove));
  }
  if (const int closed = openings_closed(seen); closed > 0) {
    FormedFeature feature = feature_of("pocket", FormSide::both,
                                       seen.part(seen.silhouette.parts.front()).faces.front(),
                                       seen.id());
    feature.own_openings = closed;
    builder.add_feature(std::move(feature));
  }
}

void measure_outlines(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  for (const auto& [face, id] : map.face_id) {
    if (map.silhouettes.contains(face) || !std::holds_alternative<Frame>(builder[id].surface))
      continue;
    if (const std::vector<int> ledges = ledges_of(of, face); !ledges.empty())
      builder.add_outline(measured_outline(builder, id, ledges, of, 0.0));
  }
}

}  // namespace planish::brep
