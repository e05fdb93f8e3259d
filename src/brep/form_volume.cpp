#include "form_volume.hpp"

#include "borders.hpp"
#include "tangent_runs.hpp"

#include <algorithm>
#include <cmath>

// The volume that a form adds to the plain sheet, by the divergence theorem: each face has its
// integral of x·n/3, and each outline in the plane of a skin is closed by a cover that counts a
// third of its area times its height; islands in it have one already. The sum is exact where the
// faces' volumes are. A form whose outline lies elsewhere has no such cover, so its volume stays
// unknown (math.md#volume-identity).

namespace planish::brep {
namespace {

/// Of the thickness: as high as the skin round it.
constexpr double kLevel = 1e-3;

/// The region enclosed by a loop in the plane of a skin.
struct Cover {
  double height = 0.0;  ///< of the plane over the model's centre
  double area = 0.0;
};
Cover cover_of(const Recognition& of, const LoopRef& ref) {
  const SolidFace& face = of.model.faces[ref.face];
  const auto& plane = std::get<Frame>(face.surface);
  return {(plane.origin - of.model.centre).dot(plane.z),
          loop_area(read_borders(of.model, face.loops[ref.loop], plane, 0.0, of.tolerance))};
}

/// That of a form that ends at a tangent line.
std::optional<Cover> cover_beside_bend(const Recognition& of, const RimPart& part, Skin skin) {
  const auto outline = outline_beside_bend(of, number_of(of, part), skin);
  if (!outline) return {};
  const auto& plane = std::get<Frame>(of.model.faces[outline->on_plane.loop.face].surface);
  return Cover{(plane.origin - of.model.centre).dot(plane.z),
               loop_area(seen_outline(of, *outline, plane, skin))};
}

double volume_under(const Recognition& of, const RimPart& part) {
  return sum_of(part.faces, [&](int f) { return of.model.faces[f].volume; });
}

/// Whether a loop goes round a plane that a pocket leaves standing within an opening of that plane.
bool is_island(const Recognition& of, const RimPart& part, const LoopRef& ref,
               const std::vector<LoopRef>& loops) {
  const SolidFace& face = of.model.faces[ref.face];
  const auto* plane = std::get_if<Frame>(&face.surface);
  if (!part.within || !plane || opening_in_plane(of, ref)) return false;
  const bool alone = std::ranges::all_of(face.loops[ref.loop], [&](const CoEdge& use) {
    const int wall = face_across(of.model.edges[use.edge], ref.face);
    return wall >= 0 && std::ranges::count(part.faces, wall) > 0;
  });
  const auto is_round = [&](const LoopRef& other) {
    const auto* level = std::get_if<Frame>(&of.model.faces[other.face].surface);
    return opening_in_plane(of, other) && level && plane->z.dot(level->z) > 0.0 &&
           std::abs(plane->local(level->origin).z()) <= of.skins.thickness * kLevel;
  };
  return alone && std::ranges::any_of(loops, is_round);
}

/// Whether a part goes round one plane on either skin, as the rim of a plate, and nothing else.
bool is_plate_rim(const Recognition& of, const RimPart& part) {
  const auto alone = [&](const LoopRef& ref) {
    const SolidFace& face = of.model.faces[ref.face];
    return std::holds_alternative<Frame>(face.surface) && !opening_in_plane(of, ref) &&
           std::ranges::all_of(face.loops[ref.loop], [&](const CoEdge& use) {
             const int wall = face_across(of.model.edges[use.edge], ref.face);
             return wall >= 0 && of.rim.part_of[wall] >= 0;
           });
  };
  return part.first.size() == 1 && part.second.size() == 1 && alone(part.first.front()) &&
         alone(part.second.front());
}

}  // namespace

double signed_loop_area(const BorderLoop& borders) {
  return sum_of(borders, [](const Border& border) { return green_area(border.curve); });
}

double loop_area(const BorderLoop& borders) { return std::abs(signed_loop_area(borders)); }

double signed_middle_area(const Recognition& of, int face, const BorderLoop& borders) {
  const auto* surface = std::get_if<Developable>(&of.model.faces[face].surface);
  if (!surface) return signed_loop_area(borders);
  const Development middle(*surface, -of.model.faces[face].sense * of.skins.thickness / 2,
                           of.outlines[face].u_middle);
  return sum_of(borders, [&](const Border& border) {
    return green_area(middle.develop(border.curve, of.tolerance));
  });
}

bool opening_in_plane(const Recognition& of, const LoopRef& ref) {
  return std::holds_alternative<Frame>(of.model.faces[ref.face].surface) &&
         of.outlines[ref.face].outer != ref.loop;
}

std::optional<double> form_volume(const Recognition& of, const RimPart& part) {
  double excess = volume_under(of, part);
  for (const Skin skin : {Skin::first, Skin::second}) {
    const auto* loops = skin == Skin::first ? &part.first : &part.second;
    if (const auto beside = cover_beside_bend(of, part, skin)) {
      excess -= beside->area * beside->height / 3;
      continue;
    }
    for (const LoopRef& ref : *loops) {
      const bool island = is_island(of, part, ref, *loops);
      if (!island && !opening_in_plane(of, ref)) return {};
      const Cover over = cover_of(of, ref);
      excess -= (island ? -over.area : over.area) * over.height / 3;
    }
  }
  return excess;
}

double opening_volume(const Recognition& of, const RimPart& part,
                      const std::array<LoopRef, 2>& openings, double cut) {
  // Covers are the rings around the cut. The wall of a straight opening contributes 2/3 of its
  // volume; the plug's caps contribute the other third.
  double excess = volume_under(of, part);
  double depth = 0.0;
  for (const LoopRef& ref : openings) {
    const Cover over = cover_of(of, ref);
    excess -= (over.area - cut) * over.height / 3;
    depth += over.height;
  }
  return excess + cut * depth * 2 / 3;
}

std::optional<double> plate_rim_volume(const Recognition& of, const RimPart& part, double cut) {
  if (!is_plate_rim(of, part)) return {};
  double excess = volume_under(of, part);
  for (const LoopRef& ref : {part.first.front(), part.second.front()}) {
    const Cover over = cover_of(of, ref);
    excess += over.area * over.height / 3 - cut * over.height;
  }
  return excess;
}

}  // namespace planish::brep
