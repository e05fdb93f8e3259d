#include "assembly.hpp"

#include "bend_measure.hpp"
#include "borders.hpp"
#include "contacts.hpp"
#include "dihedral.hpp"
#include "drawn_forms.hpp"
#include "face_reader.hpp"
#include "face_volume.hpp"
#include "features.hpp"
#include "joint_line.hpp"
#include "model_places.hpp"
#include "refusals.hpp"
#include "wide_cuts.hpp"

#include <planish/sheet/codes.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// What was recognised becomes a Sheet: faces group by group, then joints, then features. A cylinder
// or cone may be read at any turn of its azimuth, so faces of a bend are brought to one turn first,
// from a leader outwards along their seams. A joint between different surfaces is a ruling; one
// that the file's rounding has bent a little is straightened, and one that is curved for good means
// a surface that no development keeps.

namespace planish::brep {
namespace {

PartId add_part(SheetBuilder& builder, const Group& group) {
  if (group.flange) return builder.add_flange();
  return builder.add_bend();
}

/// Adds flanges, bends and their faces, group by group.
SheetMap add_faces(SheetBuilder& builder, const Recognition& of) {
  const auto parts = mapped(of.groups.rows,
                            [&](const Group& group) { return add_part(builder, group); });
  SheetMap map;
  for (size_t g = 0; g < parts.size(); ++g)
    for (const int f : of.groups.rows[g].faces) {
      ReadFace read = read_face(of, f, of.groups.rows[g].leader);
      read.face.part_of = parts[g];
      const FaceId id = builder.add_face(std::move(read.face));
      map.face_id.emplace(f, id);
      for (int l = 0; l < std::ssize(read.loops); ++l) {
        const ReadFace::Loop& loop = read.loops[l];
        map.cut_loops[{f, l}] = {id, loop.place, 0};
        const auto& uses = of.model.faces[f].loops[l];
        for (size_t i = 0; i < uses.size(); ++i)
          if (loop.borders[i] >= 0)
            map.borders[{f, uses[i].edge, uses[i].forward}] = {id, loop.place_of(i),
                                                               loop.borders[i]};
        if (loop.widened) map.widened.insert({f, l});
      }
      for (const auto& [opening, borders] : read.bridges)
        map.bridges[opening].push_back(mapped(borders, [&](int border) {
          return BorderRef{id, 0, border};
        }));
      for (const auto& [opening, at] : read.openings)
        map.tangent_cuts[opening] = {id, at.first, at.second};
      if (read.silhouette) map.silhouettes.emplace(f, std::move(*read.silhouette));
    }
  return map;
}

/// The borders on both sides of an edge.
std::pair<BorderRef, BorderRef> borders_of(const SheetMap& map, const SolidModel& model, int e) {
  const SolidEdge& edge = model.edges[e];
  return {map.borders.at({edge.faces[0], e, edge.forward[0]}),
          map.borders.at({edge.faces[1], e, edge.forward[1]})};
}

/// Moves a face by the number of whole turns nearest to this shift of u.
void turn_face(SheetBuilder& builder, FaceId id, double by) {
  builder[id] = turned_by(std::move(builder[id]), by);
}

/// Moves the faces of a bend joined along seams to the turn of their neighbours, starting at the
/// leader. Returns the faces met.
std::set<int> align_neighbours(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                               const Group& group) {
  std::set<int> settled{group.leader};
  for (bool moved = true; moved;) {
    moved = false;
    for (const GroupJoint& joint : of.groups.joints) {
      if (joint.a != joint.b || of.groups.of_face[group.leader] != joint.a) continue;
      const SolidEdge& edge = of.model.edges[joint.edge];
      const bool first_known = settled.count(edge.faces[0]) > 0;
      if (first_known == (settled.count(edge.faces[1]) > 0)) continue;
      auto [known, loose] = borders_of(map, of.model, joint.edge);
      if (!first_known) std::swap(known, loose);
      turn_face(builder, loose.face,
                start_of(builder[known].curve).x() - end_of(builder[loose].curve).x());
      settled.insert(first_known ? edge.faces[1] : edge.faces[0]);
      moved = true;
    }
  }
  return settled;
}

/// Brings all faces of each bend to one turn of its cylinder or cone.
void align_turns(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  for (const Group& group : of.groups.rows) {
    if (group.flange || group.faces.size() < 2) continue;
    const FaceId leader = map.face_id.at(group.leader);
    if (std::holds_alternative<Ruled>(std::get<Developable>(builder[leader].surface))) continue;
    const std::set<int> settled = align_neighbours(builder, map, of, group);
    for (const int f : group.faces)
      if (const FaceId id = map.face_id.at(f); !settled.count(f))
        turn_face(builder, id, middle_u(builder[leader]) - middle_u(builder[id]));
  }
}

/// A joint between different surfaces runs along a ruling; straightens a joint slightly bent by the
/// file's rounding.
Result<void> straighten(SheetBuilder& builder, const SolidModel& model, int e, const BorderRef& a,
                        const BorderRef& b) {
  constexpr double kCurved = 0.02;  // mm: twice what surfaces may be off
                                    // (RecognizeOptions::surface_tolerance)
  const double off = std::max(off_ruling(builder[a.face], builder[a].curve),
                              off_ruling(builder[b.face], builder[b].curve));
  if (off > kCurved) {
    const int first = face_as_read(model.edges[e], 0) + 1,
              second = face_as_read(model.edges[e], 1) + 1;
    return fail(refuse::curved_joint,
                {{"face", place::face(first)},
                 {"face", place::face(second)},
                 {"edge", edge_place(model, e)},
                 {"off", off, unit::mm}},
                fmt::format("faces {} and {}", first, second));
  }
  for (const BorderRef& ref : {a, b})
    builder[ref].curve = as_ruling(builder[ref.face], builder[ref].curve);
  return {};
}

/// A mitred corner holds more than the arc of material that bends to it: per length
/// T² (tan α/2 − α/2).
double mitre_volume(const Recognition& of, int e) {
  const bool rounded = std::ranges::any_of(
      of.skins.sharp, [&](const SharpEdge& sharp) { return sharp.edge == e && sharp.rounded; });
  if (rounded) return 0.0;
  const double half = std::abs(*dihedral(of.model, e)) / 2;
  const double t = of.skins.thickness;
  return of.model.edges[e].curve.length() * t * t * (std::tan(half) - half);
}

Result<void> add_joints(SheetBuilder& builder, const SheetMap& map, const Recognition& of) {
  std::map<std::pair<int, int>, BendId> sharp_bends;  // by the groups that they join
  for (const GroupJoint& joint : of.groups.joints) {
    const auto [a, b] = borders_of(map, of.model, joint.edge);
    std::optional<BendId> sharp;
    if (joint.sharp) {
      const auto key = std::minmax(joint.a, joint.b);
      const auto found = sharp_bends.find(key);
      sharp = found != sharp_bends.end()
                  ? found->second
                  : builder.add_bend(sharp_bend(*dihedral(of.model, joint.edge)));
      sharp_bends.emplace(key, *sharp);
    } else if (joint.a != joint.b) {
      if (auto done = straighten(builder, of.model, joint.edge, a, b); !done) return done;
    }
    builder.join(a, b, sharp, sharp ? mitre_volume(of, joint.edge) : 0.0);
  }
  for (const auto& [opening, faces] : map.bridges) {
    for (const auto& borders : faces)
      for (const BorderRef& ref : borders)
        builder[ref].curve = as_ruling(builder[ref.face], builder[ref].curve);
    const auto &first = faces.front(), &second = faces.back();
    for (size_t i = 0; i < first.size(); ++i)
      builder.join(first[i], second[first.size() - 1 - i]);
  }
  return {};
}

/// Where the solid's faces of a bend lie on its surface, if one of them is cut wider than its own
/// outline.
std::optional<Interval> own_u(const SheetBuilder& builder, const SheetMap& map,
                              const Recognition& of, const Group& group) {
  const auto is_widened = [&](const LoopRef& ref) {
    return std::ranges::count(group.faces, ref.face) > 0;
  };
  if (std::ranges::none_of(map.widened, is_widened)) return {};
  constexpr double kTurn = 2 * std::numbers::pi;
  const SolidSurface& surface = of.model.faces[group.leader].surface;
  const bool turns = !std::holds_alternative<Ruled>(std::get<Developable>(surface));
  std::vector<Interval> faces;
  for (const int f : group.faces) {
    const auto& loop = of.model.faces[f].loops[of.outlines[f].outer];
    const double near = middle_u(builder.sheet()[map.face_id.at(f)]);
    const Box2 box = bounds(read_borders(of.model, loop, surface, near, of.tolerance));
    const double middle = (box.lo.x() + box.hi.x()) / 2;
    const double shift = turns ? kTurn * std::round((near - middle) / kTurn) : 0.0;
    faces.push_back({box.lo.x() + shift, box.hi.x() + shift});
  }
  return Interval{std::ranges::min(faces, {}, &Interval::lo).lo,
                  std::ranges::max(faces, {}, &Interval::hi).hi};
}

}  // namespace

const std::vector<LoopRef>& loops_here(const Recognition& of, const RimPart& part) {
  return of.skin == Skin::first ? part.first : part.second;
}

const std::vector<LoopRef>& loops_there(const Recognition& of, const RimPart& part) {
  return of.skin == Skin::first ? part.second : part.first;
}

Result<Sheet> assemble_sheet(const Recognition& recognition) {
  if (auto other = standing_across(recognition)) return tl::unexpected(std::move(*other));
  Recognition of = recognition;
  of.tangent_openings = tangent_openings(recognition);
  of.bend_openings = bend_openings(recognition);
  of.far_runs = far_runs(of);
  SheetBuilder builder(of.skins.thickness);
  builder.set_thickness_spread(of.skins.spread);
  const SheetMap map = add_faces(builder, of);
  align_turns(builder, map, of);
  if (auto done = add_joints(builder, map, of); !done) return pass_on(done);
  for (const Group& group : of.groups.rows) {
    if (group.flange) continue;
    const auto bend = std::get<BendId>(builder[map.face_id.at(group.leader)].part_of);
    builder[bend] = measured_bend(builder.sheet(), bend, own_u(builder, map, of, group));
  }
  add_features(builder, map, of);
  measure_wide_cuts(builder, map, of);
  builder.set_volume(volume_of(of.model));
  builder.set_pressed_volume(of.skins.pressed_volume + drawn_volume(of));
  builder.set_genus(of.model.genus);
  auto sheet = std::move(builder).build();
  if (!sheet && sheet.error().code == code::invalid_sheet) {
    Facts facts{{"rule", sheet.error().message}};
    for (const Place& place : sheet.error().places)
      if (place.kind == PlaceKind::face) facts.emplace_back("face", place);
    return fail(refuse::unfit_borders, facts, sheet.error().where);
  }
  return sheet;
}

}  // namespace planish::brep
