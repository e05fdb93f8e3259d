#include "features.hpp"

#include "borders.hpp"
#include "dihedral.hpp"
#include "form_openings.hpp"
#include "form_side.hpp"
#include "form_volume.hpp"
#include "genus.hpp"
#include "model_places.hpp"
#include "refusals.hpp"
#include "same_surface.hpp"
#include "slanted_cuts.hpp"

#include <planish/geometry/mesh.hpp>

#include <algorithm>
#include <set>

// What the flat pattern only outlines: forms, bosses, pockets, countersinks, chamfers. A part of
// the rim becomes a feature by which skins its loops touch and on which side it leaves the sheet;
// what lies on the other skin alone is drawn as seen through the sheet. Each feature also says what
// it adds to the plain sheet's volume and openings, or the certificate would not close
// (math.md#volume-identity, math.md#openings-and-genus).

namespace planish::brep {
namespace {

const std::vector<CoEdge>& loop_of(const Recognition& of, const LoopRef& ref) {
  return of.model.faces[ref.face].loops[ref.loop];
}

bool is_plane(const Recognition& of, int face) {
  return std::holds_alternative<Frame>(of.model.faces[face].surface);
}

FormedFeature feature_of(const char* kind, FormSide side, int solid_face, FaceId face) {
  FormedFeature feature;
  feature.kind = kind;
  feature.side = side;
  feature.source_face = solid_face + 1;
  feature.face = face;
  return feature;
}

/// A feature whose borders on the reference skin are drawn and not cut.
void add_marked(SheetBuilder& builder, const SheetMap& map, const Recognition& of, int part,
                const char* kind, FormSide side, Error at_rim) {
  const RimPart& row = of.rim.parts[part];
  const auto& loops = loops_here(of, row);
  FormedFeature feature = feature_of(kind, side, row.faces.front(),
                                     map.face_id.at(loops.front().face));
  feature.at_rim = std::move(at_rim);
  if (const auto* plane = std::get_if<Frame>(&builder[feature.face].surface))
    add_form_openings(feature, *plane, of, row);
  else
    feature.lost_openings = row.openings;
  const FeatureId id = builder.add_feature(std::move(feature));
  for (const LoopRef& ref : loops)
    for (const CoEdge& use : loop_of(of, ref)) {
      const int other = face_across(of.model.edges[use.edge], ref.face);
      if (other >= 0 && of.rim.part_of[other] == part)
        builder[map.borders.at({ref.face, use.edge, use.forward})].feature = id;
    }
}

Error recess_at_rim(const SolidModel& model, const RimPart& part) {
  return error_of(refuse::recess_at_rim, {{"face", face_place(model, part.faces.front())}});
}

/// A part's box in space, enlarged by the thickness.
Box3 box_of(const Recognition& of, const RimPart& part) {
  Box3 box;
  for (const int f : part.faces)
    box.extend(of.outlines[f].space);
  return enlarged(box, of.skins.thickness);
}

/// Whether a form that leaves the sheet also appears on the reference skin (an emboss has two
/// sides).
bool formed_here(const Recognition& of, const RimPart& part) {
  const Box3 box = box_of(of, part);
  return std::ranges::any_of(of.rim.parts, [&](const RimPart& other) {
    return &other != &part && !other.within && !loops_here(of, other).empty() &&
           box.intersects(box_of(of, other));
  });
}

/// A loop of the other skin as seen on this one: reversed, a thickness below.
BorderLoop seen_through(const Recognition& of, const LoopRef& ref, const Frame& plane) {
  std::vector<CoEdge> loop = loop_of(of, ref);
  std::ranges::reverse(loop);
  for (CoEdge& use : loop)
    use.forward = !use.forward;
  BorderLoop borders = read_borders(of.model, loop, plane, 0.0, of.tolerance);
  for (Border& border : borders)
    border.edge_depth = of.skins.thickness;
  return borders;
}

/// The face of the reference skin through which a point of a face on the other skin is seen. Boxes
/// reach twice the distance of the skins: just that far the point would be in or out by rounding.
std::optional<int> plane_over(const Recognition& of, int face, const Vec3& point) {
  const double reach = 2.0 * of.skins.thickness;
  for (const int partner : of.skins.partners[face]) {
    const Outline& outline = of.outlines[partner];
    if (enlarged(outline.space, reach).contains(point) && of.skins.skin_of[partner] == of.skin &&
        is_plane(of, partner))
      return partner;
  }
  return {};
}

/// A feature on the other skin: drawn in place, seen through the sheet.
void add_far_outline(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                     const char* kind, const RimPart& part, const LoopRef& ref) {
  if (!is_plane(of, ref.face)) return;
  const Vec3 point = of.outlines[ref.face].rings[ref.loop].front();
  const auto over = plane_over(of, ref.face, point);
  if (!over) return;
  const FaceId face = map.face_id.at(*over);
  FormedFeature feature = feature_of(kind, FormSide::down, part.faces.front(), face);
  feature.outlines.push_back(seen_through(of, ref, std::get<Frame>(builder[face].surface)));
  builder.add_feature(std::move(feature));
}

/// Whether two outlines of a cut are offset from each other, as by a slope over the thickness.
bool is_slanted(const BorderLoop& a, const BorderLoop& b, double thickness) {
  constexpr double kSlope = 0.05;  // 3°: more than draft and rounding cause
  const Box2 first = bounds(a);
  const Box2 second = bounds(b);
  return std::max((first.lo - second.lo).norm(), (first.hi - second.hi).norm()) >
         kSlope * thickness;
}

/// An opening that is wider on one skin (countersink, chamfered hole) is cut to the narrowest
/// section; the wider outlines are drawn, and so is the far one of a slanted cut. Returns whether
/// this accounts for everything that widens the opening. Only openings in planes are examined.
bool add_opening(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                 const RimPart& part, const LoopRef& here, const LoopRef& there) {
  if (!opening_in_plane(of, here) || !opening_in_plane(of, there)) return false;
  const CoEdge& use = loop_of(of, here).front();
  const BorderRef first = map.borders.at({here.face, use.edge, use.forward});
  const auto& frame = std::get<Frame>(builder[first.face].surface);
  BorderLoop& cut = builder[first.face].loops[first.loop];
  const BorderLoop mine = read_borders(of.model, loop_of(of, here), frame, 0.0, of.tolerance);
  const BorderLoop theirs = seen_through(of, there, frame);
  constexpr double kWider = 1.001;  // area ratio beyond the noise of drilled holes
  if (loop_area(theirs) * kWider < loop_area(cut)) cut = theirs;
  FormedFeature feature = feature_of("countersink", wider_side(mine, theirs, kWider),
                                     part.faces.front(), first.face);
  for (const BorderLoop* wider : {&mine, &theirs})
    if (loop_area(*wider) > kWider * loop_area(cut)) feature.outlines.push_back(*wider);
  const bool widens = !feature.outlines.empty();
  if (widens) {
    builder.add_form_volume(opening_volume(of, part, {here, there}, loop_area(cut)));
  } else if (is_slanted(mine, theirs, of.skins.thickness)) {
    feature.kind = "slanted cut";
    feature.side = FormSide::down;
    feature.outlines.push_back(theirs);
  } else {
    return false;
  }
  builder.add_feature(std::move(feature));
  return widens;
}

/// A chamfer or fillet around a contour: the skin's own outline is drawn.
void add_chamfered_rim(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                       const LoopRef& ref) {
  const FaceId face = map.face_id.at(ref.face);
  FormedFeature feature = feature_of("chamfer", FormSide::up, ref.face, face);
  if (const auto* plane = std::get_if<Frame>(&builder[face].surface))
    feature.outlines.push_back(read_borders(of.model, loop_of(of, ref), *plane, 0.0, of.tolerance));
  builder.add_form_volume({});
  builder.add_feature(std::move(feature));
}

/// Chamfers along the other skin, by which the blank stays as it is.
void add_far_chamfers(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                      const RimPart& part) {
  if (!part.within) return;
  for (const LoopRef& ref : loops_there(of, part))
    if (is_chamfered(of, ref)) add_far_outline(builder, map, of, "chamfer", part, ref);
}

/// What lies on the other skin alone may have handles of its own, which no cut of the sheet makes.
void add_hidden_openings(SheetBuilder& builder, const SheetMap& map, const RimPart& part) {
  FormedFeature feature = feature_of("formed", FormSide::down, part.faces.front(),
                                     map.face_id.begin()->second);
  feature.own_openings = part.openings;
  builder.add_feature(std::move(feature));
}

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

/// Whether a recess in planes of the reference skin has more holes in its floor than outlines.
bool has_several_holes(const Recognition& of, const RimPart& part) {
  const auto in_plane = [&](const LoopRef& ref) { return opening_in_plane(of, ref); };
  const auto& here = loops_here(of, part);
  const auto& there = loops_there(of, part);
  // A loop that is no opening is the outline of a face cut off from its skin.
  return part.openings > std::ssize(here) && there.size() > here.size() &&
         std::ranges::all_of(here, in_plane) && std::ranges::all_of(there, in_plane);
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

/// Walls of cuts that hang together although the sheet is cut between them: edges of the sheet that
/// touch, so that the solid has an opening there which no cut makes. All contours along such walls
/// are cut, and the other skin has no more of them, so none has been lost.
void add_contacts(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  if (const int handles = handles_at_touching_edges(of); handles > 0) {
    FormedFeature feature = feature_of(
        "contact", FormSide::both, of.rim.parts.front().faces.front(), map.face_id.begin()->second);
    feature.own_openings = handles;
    builder.add_feature(std::move(feature));
    return;
  }
  for (const RimPart& part : of.rim.parts) {
    if (!part.within || part.openings <= 1 || has_several_holes(of, part)) continue;
    const auto contours_on = [&](Skin skin) {
      return closed_borders(of.model, part.faces, [&](int edge) {
        const auto& faces = of.model.edges[edge].faces;
        return std::ranges::any_of(faces,
                                   [&](int f) { return f >= 0 && of.skins.skin_of[f] == skin; });
      });
    };
    const int cut = contours_on(of.skin);
    if (cut == 0 || contours_on(other_skin(of.skin)) > cut || part.openings <= cut) continue;
    FormedFeature feature = feature_of("contact", FormSide::both, part.faces.front(),
                                       map.face_id.begin()->second);
    feature.own_openings = part.openings - cut;
    builder.add_feature(std::move(feature));
  }
}

}  // namespace

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

void add_features(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  std::set<LoopRef> widened = map.widened;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    const auto& here = loops_here(of, part);
    const auto& there = loops_there(of, part);
    if (part.within && here.size() == 1 && there.size() == 1) {
      if (add_opening(builder, map, of, part, here.front(), there.front()))
        widened.erase(here.front());
      else
        add_far_chamfers(builder, map, of, part);
    } else if (here.empty()) {
      if (part.within || !formed_here(of, part))
        for (const LoopRef& ref : there)
          if (opening_in_plane(of, ref))
            add_far_outline(builder, map, of, part.within ? "pocket" : "formed", part, ref);
      if (part.openings > 0) add_hidden_openings(builder, map, part);
      builder.add_form_volume(form_volume(of, part));
    } else if (!part.within) {
      add_marked(builder, map, of, p, "formed", raised_side(of, part), part.refusal);
      builder.add_form_volume(form_volume(of, part));
    } else if (there.empty() || has_several_holes(of, part)) {
      add_marked(builder, map, of, p, "pocket", FormSide::up, recess_at_rim(of.model, part));
      builder.add_form_volume(form_volume(of, part));
    } else {
      add_far_chamfers(builder, map, of, part);
    }
  }
  add_contacts(builder, map, of);
  add_slanted_cuts(builder, map, of);
  for (const LoopRef& ref : widened)
    add_chamfered_rim(builder, map, of, ref);
}

}  // namespace planish::brep
