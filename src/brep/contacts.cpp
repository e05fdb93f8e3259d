#include "contacts.hpp"

#include "borders.hpp"
#include "dihedral.hpp"
#include "form_volume.hpp"
#include "genus.hpp"
#include "model_places.hpp"
#include "refusals.hpp"
#include "same_surface.hpp"

#include <algorithm>
#include <set>

// Where parts of the rim join what the sheet does not: walls of cuts that touch, and what stands on
// one skin across a joint. Touching edges are told by counting: contours along the walls against
// openings of the part, or the handles of the solid against those that the skins alone would make
// (math.md#openings-and-genus). What stands on a skin meets it in concave edges only.

namespace planish::brep {
namespace {

/// Whether a part is put on a skin, which it meets in concave edges only: those of what is cut into
/// it are convex.
bool stands_on_skin(const Recognition& of, const RimPart& part) {
  bool concave = false;
  for (const int f : part.faces)
    for (const auto& loop : of.model.faces[f].loops)
      for (const CoEdge& use : loop) {
        const int skin = face_across(of.model.edges[use.edge], f);
        if (skin < 0 || of.skins.skin_of[skin] == Skin::none) continue;
        const auto angle = dihedral(of.model, use.edge);
        if (angle && *angle > 0.0) return false;
        concave = concave || angle;
      }
  return concave;
}

/// Handles of the solid where faces of a skin touch along an edge at which the sheet is not bent,
/// as walls do whose corner is notched outside. They are the only ones beyond the sheet's own
/// openings if both skins are alike and only walls of cuts join them. Zero where nothing touches
/// so.
int handles_at_touching_edges(const Recognition& of) {
  std::set<int> sharp;
  for (const SharpEdge& edge : of.skins.sharp)
    sharp.insert(edge.edge);
  const auto touches = [&](int e) {
    const auto& [a, b] = of.model.edges[e].faces;
    return a >= 0 && b >= 0 && a != b && of.skins.skin_of[a] != Skin::none &&
           of.skins.skin_of[a] == of.skins.skin_of[b] && !sharp.contains(e) &&
           !smooth_edge(of.model, e);
  };
  int touching = 0;
  for (int e = 0; e < std::ssize(of.model.edges); ++e)
    touching += touches(e) ? 1 : 0;
  const bool only_walls = std::ranges::all_of(of.rim.parts, [](const RimPart& part) {
    return part.within && !part.first.empty() && !part.second.empty();
  });
  if (touching == 0 || !only_walls || !of.model.genus) return 0;
  const auto shape_of = [&](Skin skin) {
    std::vector<int> faces;
    for (int f = 0; f < std::ssize(of.model.faces); ++f)
      if (of.skins.skin_of[f] == skin) faces.push_back(f);
    return shape_of_patch(of.model, faces, touches);
  };
  const PatchShape shape = shape_of(Skin::first);
  if (shape != shape_of(Skin::second)) return 0;
  // A sheet of that shape, thickened, has 1 − χ handles.
  const int more = *of.model.genus - (1 - shape.euler);
  return more <= touching ? std::max(more, 0) : 0;
}

}  // namespace

int contours_on(const Recognition& of, const RimPart& part, Skin skin) {
  return closed_borders(of.model, part.faces, [&](int edge) {
    const auto& faces = of.model.edges[edge].faces;
    return std::ranges::any_of(faces, [&](int f) { return f >= 0 && of.skins.skin_of[f] == skin; });
  });
}

bool has_several_holes(const Recognition& of, const RimPart& part) {
  const auto in_plane = [&](const LoopRef& ref) { return opening_in_plane(of, ref); };
  const auto& here = loops_here(of, part);
  const auto& there = loops_there(of, part);
  // A loop that is no opening is the outline of a face cut off from its skin.
  return part.openings > 1 && !here.empty() && !there.empty() &&
         std::ranges::all_of(here, in_plane) && std::ranges::all_of(there, in_plane);
}

std::optional<Error> standing_across(const Recognition& of) {
  for (const RimPart& part : of.rim.parts) {
    if (part.first.empty() == part.second.empty()) continue;
    const auto& loops = part.first.empty() ? part.second : part.first;
    const int first = loops.front().face;
    const bool across = std::ranges::any_of(loops, [&](const LoopRef& ref) {
      return ref.face != first &&
             !same_surface(of.model.faces[first], of.model.faces[ref.face], of.model.size);
    });
    if (across && stands_on_skin(of, part))
      return error_of(refuse::beyond_sheet, {{"face", face_place(of.model, part.faces.front())},
                                             {"thickness", of.skins.thickness, unit::mm}});
  }
  return std::nullopt;
}

void add_contacts(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  if (const int handles = handles_at_touching_edges(of); handles > 0) {
    FormedFeature feature = feature_of(
        "contact", FormSide::both, of.rim.parts.front().faces.front(), map.face_id.begin()->second);
    feature.own_openings = handles;
    builder.add_feature(std::move(feature));
    return;
  }
  for (const RimPart& part : of.rim.parts) {
    const bool seen = std::ranges::any_of(loops_here(of, part),
                                          [&](const LoopRef& ref) { return map.is_seen(ref); });
    if (!part.within || part.openings <= 1 || seen || has_several_holes(of, part)) continue;
    const int cut = contours_on(of, part, of.skin);
    if (cut == 0 || contours_on(of, part, other_skin(of.skin)) > cut || part.openings <= cut)
      continue;
    FormedFeature feature = feature_of("contact", FormSide::both, part.faces.front(),
                                       map.face_id.begin()->second);
    feature.own_openings = part.openings - cut;
    builder.add_feature(std::move(feature));
  }
}

}  // namespace planish::brep
