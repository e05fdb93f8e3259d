#include "rim_volume.hpp"

#include "face_volume.hpp"
#include "form_volume.hpp"
#include "silhouette_features.hpp"
#include "skin_outlines.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>

// What rounding and chamfering take off a rim that runs over bends. The rim and the faces of both
// skins, openings filled, enclose a body; its volume is exact by the divergence theorem. The sheet
// that is cut has there the area half-way between its skins, times the thickness
// (math.md#volume-identity).

namespace planish::brep {
namespace {

/// The loop of a face that has this edge.
int loop_with(const SolidModel& model, int face, int edge) {
  const auto& loops = model.faces[face].loops;
  const auto found = std::ranges::find_if(
      loops, [&](const auto& loop) { return std::ranges::count(loop, edge, &CoEdge::edge) > 0; });
  return static_cast<int>(found - loops.begin());
}

/// ⅓∫(x − c)·n dA inside these loops of a face. Empty where a part of a face is not known.
std::optional<double> volume_inside(const Recognition& of, int f, const std::set<LoopRef>& loops) {
  const SolidFace& face = of.model.faces[f];
  SolidFace filled = face;
  filled.loops.clear();
  for (int l = 0; l < std::ssize(face.loops); ++l)
    if (loops.contains({f, l})) filled.loops.push_back(face.loops[l]);
  if (filled.loops.size() == face.loops.size()) return face.volume;
  if (!has_border_volume(face)) return {};
  return volume_under(filled, of.model);
}

std::optional<double> volume_enclosed(const Recognition& of, const ClosedRim& rim) {
  double volume = 0.0;
  for (const int p : rim.parts)
    volume += sum_of(of.rim.parts[p].faces, [&](int f) { return of.model.faces[f].volume; });
  std::set<int> faces;
  for (const LoopRef& ref : rim.loops)
    faces.insert(ref.face);
  for (const int f : faces) {
    const auto inside = volume_inside(of, f, rim.loops);
    if (!inside) return {};
    volume += *inside;
  }
  return volume;
}

/// Half-way between the skins, the area inside what is cut along a loop of the reference skin,
/// below 0 for openings.
double area_cut_along(const Sheet& sheet, const SheetMap& map, const Recognition& of,
                      const LoopRef& ref) {
  const int leader = of.groups.rows[of.groups.of_face[ref.face]].leader;
  const Face& face = sheet[map.face_id.at(ref.face)];
  if (of.outlines[ref.face].outer == ref.loop)
    return std::abs(signed_middle_area(of, leader, face.loops.front()));
  return -std::abs(signed_middle_area(of, leader, face.loops[map.cut_loops.at(ref).loop]));
}

/// The same of the silhouettes of faces along a rim, with what they account for. Empty where they
/// hold more than the rim.
std::optional<double> volume_of_silhouettes(const Sheet& sheet, const SheetMap& map,
                                            const Recognition& of, const ClosedRim& rim) {
  std::set<int> faces;
  for (const LoopRef& ref : rim.loops)
    if (map.is_seen(ref)) faces.insert(ref.face);
  double volume = 0.0;
  for (const int f : faces) {
    const Silhouette& silhouette = map.silhouettes.at(f);
    const bool alone = std::ranges::all_of(silhouette.parts,
                                           [&](int p) { return rim.parts.contains(p); }) &&
                       std::ranges::all_of(silhouette.skin_loops, [&](int l) {
                         return rim.loops.contains({f, l});
                       });
    const auto beyond = silhouette.over_bend ? 0.0 : volume_beyond_silhouette(sheet, map, of, f);
    if (!alone || !beyond) return {};
    volume += silhouette_area(sheet, map, of, f) * of.skins.thickness + *beyond;
  }
  return volume;
}

/// The volume of the sheet as it is cut along a rim, and of what its tangent openings account for.
std::optional<double> volume_as_cut(const Sheet& sheet, const SheetMap& map, const Recognition& of,
                                    const ClosedRim& rim) {
  double area = 0.0, machined = 0.0;
  for (const LoopRef& ref : rim.loops) {
    if (of.skins.skin_of[ref.face] != of.skin || map.is_seen(ref)) continue;
    area += area_cut_along(sheet, map, of, ref);
  }
  const auto seen = volume_of_silhouettes(sheet, map, of, rim);
  if (!seen) return {};
  for (int i = 0; i < std::ssize(of.tangent_openings); ++i) {
    const TangentOpening& opening = of.tangent_openings[i];
    if (!rim.parts.contains(opening.part)) continue;
    machined += volume_beyond_cut(of, opening).value_or(0.0);
    if (opening.leads_over() && opening.cut_of_bend.empty()) area -= loop_area(opening.cut);
  }
  return area * of.skins.thickness + *seen + machined;
}

/// Of a plate by its own outlines, of others by the body that their rim encloses.
std::optional<double> rim_volume(const Sheet& sheet, const SheetMap& map, const Recognition& of,
                                 const ClosedRim& rim) {
  if (rim.parts.size() == 1) {
    const RimPart& part = of.rim.parts[*rim.parts.begin()];
    if (const auto& here = loops_here(of, part); !here.empty()) {
      const Face& face = sheet[map.face_id.at(here.front().face)];
      if (const auto volume = plate_rim_volume(of, part, loop_area(face.loops.front())))
        return volume;
    }
  }
  const bool known = of.skins.sharp.empty() && std::ranges::all_of(rim.parts, [&](int p) {
                       const RimPart& part = of.rim.parts[p];
                       return part.within && !part.first.empty() && !part.second.empty();
                     });
  if (!known) return {};
  const auto solid = volume_enclosed(of, rim);
  const auto cut = volume_as_cut(sheet, map, of, rim);
  if (!solid || !cut) return {};
  return *solid - *cut;
}

}  // namespace

std::optional<ClosedRim> closed_rim(const Recognition& of, const std::set<int>& parts) {
  ClosedRim rim;
  std::vector<LoopRef> open;
  const auto add = [&](int p) {
    if (!rim.parts.insert(p).second) return;
    for (const auto* loops : {&of.rim.parts[p].first, &of.rim.parts[p].second})
      open.insert(open.end(), loops->begin(), loops->end());
  };
  std::ranges::for_each(parts, add);
  while (!open.empty()) {
    const LoopRef ref = open.back();
    open.pop_back();
    if (!rim.loops.insert(ref).second) continue;
    for (const CoEdge& use : loop_of(of, ref)) {
      const int next = face_across(of.model.edges[use.edge], ref.face);
      if (next < 0) return {};
      if (const int p = of.rim.part_of[next]; p >= 0)
        add(p);
      else if (next != ref.face)
        open.push_back({next, loop_with(of.model, next, use.edge)});
    }
  }
  return rim;
}

namespace {

/// The rim with a part and, where that reaches over bends from what is seen of a flange, with all
/// that is seen there: what is beyond a cut is measured together.
std::optional<ClosedRim> rim_with(const Recognition& of, const SheetMap& map, int part) {
  std::set<int> parts{part};
  auto rim = closed_rim(of, parts);
  for (size_t known = 0; rim && known != rim->parts.size();) {
    known = rim->parts.size();
    for (const auto& [face, silhouette] : map.silhouettes)
      if (silhouette.over_bend &&
          std::ranges::any_of(silhouette.parts, [&](int p) { return rim->parts.contains(p); }))
        parts.insert(silhouette.parts.begin(), silhouette.parts.end());
    rim = closed_rim(of, parts);
  }
  return rim;
}

}  // namespace

std::set<int> add_rim_volumes(SheetBuilder& builder, const SheetMap& map, const Recognition& of,
                              const std::set<int>& widened, const std::set<int>& far) {
  std::set<int> measured;
  for (const auto* parts : {&widened, &far})
    for (const int p : *parts) {
      if (measured.contains(p)) continue;
      const auto rim = rim_with(of, map, p);
      const auto volume = rim ? rim_volume(builder.sheet(), map, of, *rim) : std::nullopt;
      if (volume || parts == &widened) builder.add_form_volume(volume);
      if (volume) measured.insert(rim->parts.begin(), rim->parts.end());
    }
  return measured;
}

}  // namespace planish::brep
