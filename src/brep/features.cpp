#include "features.hpp"

#include "borders.hpp"
#include "contacts.hpp"
#include "form_openings.hpp"
#include "form_side.hpp"
#include "form_volume.hpp"
#include "model_places.hpp"
#include "narrowest.hpp"
#include "plane_opening.hpp"
#include "refusals.hpp"
#include "rim_volume.hpp"
#include "silhouette_features.hpp"
#include "skin_outlines.hpp"
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

FormedFeature feature_of(const char* kind, FormSide side, int solid_face, FaceId face) {
  FormedFeature feature;
  feature.kind = kind;
  feature.side = side;
  feature.source_face = solid_face + 1;
  feature.face = face;
  return feature;
}

namespace {

/// A feature whose borders on the reference skin are drawn and not cut.
void add_marked(SheetBuilder& builder, const SheetMap& map, const Recognition& of, int part,
                const char* kind, FormSide side, Error at_rim) {
  const RimPart& row = of.rim.parts[part];
  const auto& loops = loops_here(of, row);
  const auto flange = std::ranges::find_if(loops, [&](const LoopRef& ref) {
    return std::holds_alternative<Frame>(of.model.faces[ref.face].surface);
  });
  FormedFeature feature = feature_of(
      kind, side, row.faces.front(),
      map.face_id.at((flange == loops.end() ? loops.front() : *flange).face));
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

/// Parts that are forms, by part: they leave the sheet, or are the hollow across from one that
/// does.
std::vector<bool> formed_parts(const Recognition& of) {
  const auto is_across = [&](const RimPart& form, const RimPart& hollow) {
    const bool here = loops_here(of, hollow).empty();
    if (form.within || (here ? loops_here(of, form) : loops_there(of, form)).empty()) return false;
    const Box3 near = enlarged(box_of(of, form), of.skins.thickness);
    return std::ranges::all_of(hollow.faces,
                               [&](int f) { return near.contains(of.outlines[f].space); });
  };
  return mapped(of.rim.parts, [&](const RimPart& part) {
    if (!part.within) return true;
    if (!loops_here(of, part).empty() && !loops_there(of, part).empty()) return false;
    return std::ranges::any_of(of.rim.parts,
                               [&](const RimPart& form) { return is_across(form, part); });
  });
}

/// Whether a form also appears on the reference skin (an emboss has two sides).
bool formed_here(const Recognition& of, const std::vector<bool>& formed, const RimPart& part) {
  const Box3 box = box_of(of, part);
  for (std::size_t p = 0; p < formed.size(); ++p)
    if (const RimPart& other = of.rim.parts[p]; formed[p] && &other != &part &&
                                                !loops_here(of, other).empty() &&
                                                box.intersects(box_of(of, other)))
      return true;
  return false;
}

/// Whether two outlines of a cut are offset from each other, as by a slope over the thickness.
bool is_slanted(const BorderLoop& a, const BorderLoop& b, double thickness) {
  constexpr double kSlope = 0.05;  // 3°: more than draft and rounding cause
  const Box2 first = bounds(a);
  const Box2 second = bounds(b);
  return std::max((first.lo - second.lo).norm(), (first.hi - second.hi).norm()) >
         kSlope * thickness;
}

/// How far an outline lies inside another at most, on one side of it.
double reach_inside(const BorderLoop& outer, const BorderLoop& inner) {
  const Box2 a = bounds(outer), b = bounds(inner);
  return std::max((b.lo - a.lo).maxCoeff(), (a.hi - b.hi).maxCoeff());
}

/// How far a loop of the other skin lies below the plane of this one.
double seen_depth(const Recognition& of, const LoopRef& ref, const Frame& plane) {
  return -plane.local(of.outlines[ref.face].rings[ref.loop].front()).z();
}

/// What the solid lacks at an opening, against which the certificate holds what is cut.
MeasuredOpening measured(const Recognition& of, const PlaneOpening& opening, const BorderRef& first,
                         const Frame& frame, const BorderLoop& cut) {
  MeasuredOpening measured{first.face, first.loop};
  // Skins may lie closer here than on average.
  const double share = of.skins.thickness / seen_depth(of, opening.there, frame);
  measured.lacking = -share * opening_volume(of, opening.part, {opening.here, opening.there}, 0.0);
  measured.beyond = std::max(0.0, measured.lacking - loop_area(cut) * of.skins.thickness);
  measured.intrusion = intrusion_into(of, opening.part, frame, cut);
  return measured;
}

/// An opening is cut to its narrowest section; the wider outlines are drawn, and so is the far one
/// of a slanted cut. One that widens within the sheet only (a groove) has no outline. Returns
/// whether this accounts for everything that widens the opening. Only openings in planes are
/// examined.
bool add_opening(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                 const RimPart& part, const LoopRef& here, const LoopRef& there) {
  if (!goes_round(of, part, here) || !goes_round(of, part, there)) return false;
  const CoEdge& use = loop_of(of, here).front();
  const BorderRef first = map.borders.at({here.face, use.edge, use.forward});
  const auto& frame = std::get<Frame>(builder[first.face].surface);
  const PlaneOpening opening = opening_between(of, part, here, there, frame);
  BorderLoop& cut = builder[first.face].loops[first.loop];
  const auto narrower = narrower_cut(of, opening, frame);
  const bool widened = narrower || map.widened.contains(here);
  if (widened) cut = narrower.value_or(opening.mine);
  MeasuredOpening balance = measured(of, opening, first, frame, cut);
  std::vector<FormedFeature> found = machined_round(of, opening, frame, first, cut);
  if (!widened && found.empty() && is_slanted(opening.mine, opening.theirs, of.skins.thickness)) {
    balance.intrusion = 0.0;
    found = {drawn_opening("slanted cut", FormSide::down, opening, first, {opening.theirs})};
    found.front().beyond_cut = reach_inside(opening.mine, opening.theirs);
  } else if (const double width = balance.beyond / (of.skins.thickness * perimeter(cut));
             widened || width > kSameOutline) {
    builder.add_form_volume(opening_volume(of, part, {here, there}, loop_area(cut)));
    if (found.empty() && width > kWiderOutline) {
      found = {drawn_opening("pocket", FormSide::both, opening, first, {})};
      found.front().along = {first};
    }
  }
  builder.add_opening(balance);
  const bool drawn = std::ranges::any_of(
      found, [](const FormedFeature& feature) { return feature.kind != "slanted cut"; });
  for (FormedFeature& feature : found)
    builder.add_feature(std::move(feature));
  return widened || drawn;
}

/// The same of an opening in a plane that is machined over the tangent line beside it.
void add_tangent_opening(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                         int number) {
  const TangentOpening& at = of.tangent_openings[number];
  const RimPart& part = of.rim.parts[at.part];
  const LoopRun& run = at.here.on_plane;
  const CoEdge& use = loop_of(of, run.loop)[run.first];
  const BorderRef first = at.leads_over() ? map.tangent_cuts.at(number)
                                          : map.borders.at({run.loop.face, use.edge, use.forward});
  const bool across = !at.cut_of_bend.empty();
  if (!across) builder[first.face].loops[first.loop] = at.cut;
  const PlaneOpening opening{part, at.here.on_plane.loop, at.there.on_plane.loop, seen_here(of, at),
                             seen_there(of, at)};
  for (FormedFeature& feature : widenings(opening, first, at.cut_seen))
    builder.add_feature(std::move(feature));
  const double depth = depth_of(of, at);
  const auto beyond = volume_beyond_cut(of, at);
  if (beyond) builder.add_form_volume(beyond);
  if (across) return;
  MeasuredOpening measured{first.face, first.loop};
  const double area = cut_area(of, at);
  measured.lacking = (area - beyond.value_or(0.0) / depth) * of.skins.thickness;
  measured.beyond = std::max(0.0, measured.lacking - loop_area(at.cut) * of.skins.thickness);
  measured.intrusion = intrusion_into(of, part, at.plane, at.cut);
  builder.add_opening(measured);
}

/// All of them; returns their parts. Their loops are not widened otherwise.
std::set<int> add_tangent_openings(SheetBuilder& builder, const SheetMap& map,
                                   const Recognition& of, std::set<LoopRef>& widened) {
  std::set<int> parts;
  for (int i = 0; i < std::ssize(of.tangent_openings); ++i) {
    const TangentOpening& opening = of.tangent_openings[i];
    add_tangent_opening(builder, map, of, i);
    parts.insert(opening.part);
    if (!opening.here.on_bend) widened.erase(opening.here.on_plane.loop);
  }
  return parts;
}

/// The same of openings within bends, where no outlines are drawn.
std::set<int> add_bend_openings(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                                std::set<LoopRef>& widened) {
  std::set<int> parts;
  for (const BendOpening& opening : of.bend_openings) {
    const BorderRef first = map.cut_loops.at(opening.here);
    if (opening.up || opening.down) {
      const FormSide side = !opening.down ? FormSide::up
                            : opening.up  ? FormSide::both
                                          : FormSide::down;
      FormedFeature feature = feature_of("countersink", side,
                                         of.rim.parts[opening.part].faces.front(), first.face);
      feature.along = {first};
      builder.add_feature(std::move(feature));
    }
    widened.erase(opening.here);
    parts.insert(opening.part);
  }
  return parts;
}

std::set<int> add_openings_at_bends(SheetBuilder& builder, const SheetMap& map,
                                    const Recognition& of, std::set<LoopRef>& widened) {
  std::set<int> parts = add_tangent_openings(builder, map, of, widened);
  parts.merge(add_bend_openings(builder, map, of, widened));
  return parts;
}

/// The part of the rim along a loop of a skin.
std::optional<int> part_along(const Recognition& of, const LoopRef& ref) {
  for (const CoEdge& use : loop_of(of, ref))
    if (const int wall = face_across(of.model.edges[use.edge], ref.face);
        wall >= 0 && of.rim.part_of[wall] >= 0)
      return of.rim.part_of[wall];
  return {};
}

/// The parts along loops that are cut wider than the skin, and openings over tangent lines that are
/// not measured yet.
std::set<int> chamfered_here(const Recognition& of, const std::set<LoopRef>& widened) {
  std::set<int> parts;
  for (const LoopRef& ref : widened)
    if (const auto part = part_along(of, ref)) parts.insert(*part);
  for (const TangentOpening& opening : of.tangent_openings)
    if (!volume_beyond_cut(of, opening)) parts.insert(opening.part);
  for (const BendOpening& opening : of.bend_openings)
    parts.insert(opening.part);
  return parts;
}

/// Chamfers and fillets around contours: the skin's own outlines are drawn.
void add_chamfered_rims(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                        const std::set<LoopRef>& widened) {
  for (const LoopRef& ref : widened) {
    const FaceId face = map.face_id.at(ref.face);
    FormedFeature feature = feature_of("chamfer", FormSide::up, ref.face, face);
    if (const auto* plane = std::get_if<Frame>(&builder[face].surface))
      feature.outlines.push_back(
          read_borders(of.model, loop_of(of, ref), *plane, 0.0, of.tolerance));
    builder.add_feature(std::move(feature));
  }
}

/// Chamfers along the other skin, by which the blank stays as it is. Returns whether there are any.
bool add_far_chamfers(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                      const RimPart& part) {
  if (!part.within) return false;
  bool found = false;
  for (const LoopRef& ref : loops_there(of, part))
    if (is_chamfered(of, part, ref)) {
      add_far_outline(builder, map, of, "chamfer", part, ref);
      found = true;
    }
  const auto& here = loops_here(of, part);
  return found && !here.empty() && !map.widened.contains(here.front());
}

/// Whether all that is cut along these loops is taken from silhouettes.
bool is_all_seen(const SheetMap& map, const std::vector<LoopRef>& loops) {
  return !loops.empty() &&
         std::ranges::all_of(loops, [&](const LoopRef& ref) { return map.is_seen(ref); });
}

/// What lies on the other skin alone may have handles of its own, which no cut of the sheet makes.
void add_hidden_openings(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                         const RimPart& part) {
  const int openings = hidden_openings(of, part);
  if (openings <= 0) return;
  FormedFeature feature = feature_of("formed", FormSide::down, part.faces.front(),
                                     map.face_id.begin()->second);
  feature.own_openings = openings;
  builder.add_feature(std::move(feature));
}

/// Adds all of them; returns the parts that run on over bends beside what is seen.
std::set<int> add_silhouettes(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  std::set<int> parts;
  for (const auto& [face, silhouette] : map.silhouettes) {
    add_silhouette(builder, map, of, face);
    for (const int p : silhouette.parts)
      if (silhouette.over_bend || !is_all_seen(map, loops_here(of, of.rim.parts[p])))
        parts.insert(p);
  }
  return parts;
}

}  // namespace

void add_features(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  std::set<LoopRef> widened = map.widened;
  const std::set<int> at_bends = add_openings_at_bends(builder, map, of, widened);
  const std::vector<bool> formed = formed_parts(of);
  std::set<int> chamfered_there;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    const auto& here = loops_here(of, part);
    const auto& there = loops_there(of, part);
    if (at_bends.contains(p) || is_all_seen(map, here)) continue;
    const bool several = part.within && has_several_holes(of, part);
    if (part.within && !several && here.size() == 1 && there.size() == 1) {
      if (add_opening(builder, map, of, part, here.front(), there.front()))
        widened.erase(here.front());
      else if (add_far_chamfers(builder, map, of, part))
        chamfered_there.insert(p);
    } else if (here.empty()) {
      if (!formed[p] || !formed_here(of, formed, part))
        for (const LoopRef& ref : there)
          if (opening_in_plane(of, ref))
            add_far_outline(builder, map, of, formed[p] ? "formed" : "pocket", part, ref);
      add_hidden_openings(builder, map, of, part);
      builder.add_form_volume(form_volume(of, part));
    } else if (formed[p] || there.empty() || several) {
      const char* kind = formed[p] ? "formed" : "pocket";
      add_marked(builder, map, of, p, kind, formed[p] ? raised_side(of, part) : FormSide::up,
                 part.within ? recess_at_rim(of.model, part) : part.refusal);
      builder.add_form_volume(form_volume(of, part));
    } else if (add_far_chamfers(builder, map, of, part)) {
      chamfered_there.insert(p);
    }
  }
  chamfered_there.merge(add_silhouettes(builder, map, of));
  measure_outlines(builder, map, of);
  add_contacts(builder, map, of);
  add_slanted_cuts(builder, map, of,
                   add_rim_volumes(builder, map, of, chamfered_here(of, widened), chamfered_there));
  add_chamfered_rims(builder, map, of, widened);
}

}  // namespace planish::brep
