#include "skin_outlines.hpp"

#include "borders.hpp"
#include "divided_skin.hpp"
#include "form_volume.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>

// Outlines of both skins as they lie on the reference skin, and whether one is wider than another:
// what is drawn of it and not cut.

namespace planish::brep {
namespace {

bool is_plane(const Recognition& of, int face) {
  return std::holds_alternative<Frame>(of.model.faces[face].surface);
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

/// The faces of a part that lie along a skin.
std::set<int> walls_along(const Recognition& of, const RimPart& part, Skin skin) {
  std::set<int> walls;
  for (const LoopRef& ref : skin == Skin::first ? part.first : part.second)
    for (const CoEdge& use : loop_of(of, ref))
      if (const int wall = face_across(of.model.edges[use.edge], ref.face);
          std::ranges::count(part.faces, wall) > 0)
        walls.insert(wall);
  return walls;
}

/// Cosine between the outward normal of a face and a direction; empty where it is not a plane.
std::optional<double> cosine_of(const Recognition& of, int face, const Vec3& direction) {
  if (!is_plane(of, face)) return {};
  return outward_normal_at(of.model.faces[face], of.outlines[face].inner_point).dot(direction);
}

}  // namespace

std::set<int> faces_along(const Recognition& of, int face, const Frame& flange) {
  constexpr double kAlong = 0.95;  // cosine
  std::set<int> beside = faces_beside(of.model, face);
  const double depth = -flange.local(of.outlines[face].inner_point).z();
  const bool within = depth < of.skins.thickness - of.skins.spread - of.tolerance;
  if (within && cosine_of(of, face, flange.z).value_or(0.0) > kAlong)
    std::erase_if(beside, [&](int other) {
      return other >= 0 && of.skins.skin_of[other] != Skin::none &&
             std::abs(cosine_of(of, other, flange.z).value_or(1.0)) < kAlong;
    });
  return beside;
}

const std::vector<CoEdge>& loop_of(const Recognition& of, const LoopRef& ref) {
  return of.model.faces[ref.face].loops[ref.loop];
}

std::set<int> wall_edges(const Recognition& of, const RimPart& part) {
  std::set<int> edges;
  for (const int wall : part.faces)
    for (const auto& loop : of.model.faces[wall].loops)
      for (const CoEdge& use : loop)
        edges.insert(use.edge);
  return edges;
}

double perimeter(const BorderLoop& borders) { return length(mapped(borders, &Border::curve)); }

bool is_wider(const BorderLoop& outline, const BorderLoop& than) {
  return loop_area(outline) - loop_area(than) > kWiderOutline * perimeter(than);
}

bool is_machined(const Recognition& of, const RimPart& part, Skin skin) {
  const std::set<int> beyond = walls_along(of, part, other_skin(skin));
  return std::ranges::none_of(walls_along(of, part, skin),
                              [&](int wall) { return beyond.contains(wall); });
}

bool reaches(const Recognition& of, int wall, Skin skin) {
  for (const auto& loop : of.model.faces[wall].loops)
    for (const CoEdge& use : loop)
      if (const int next = face_across(of.model.edges[use.edge], wall);
          next >= 0 && of.skins.skin_of[next] == skin)
        return true;
  return false;
}

bool is_slanted(const Recognition& of, const RimPart& part, const Vec3& from) {
  constexpr double kDrilled = 1e-4;  // sine: to the digits of a STEP file
  double up = 0.0, down = 0.0;
  for (const int wall : part.faces) {
    const SolidFace& face = of.model.faces[wall];
    if (!reaches(of, wall, of.skin) || !reaches(of, wall, other_skin(of.skin))) continue;
    if (std::holds_alternative<DoublyCurved>(face.surface)) return true;
    for (const auto& ring : of.outlines[wall].rings)
      for (const Vec3& point : ring) {
        const double lean = outward_normal_at(face, point).dot(from);
        up = std::max(up, lean);
        down = std::max(down, -lean);
      }
  }
  return std::min(up, down) > kDrilled;
}

bool lies_opposite(const Recognition& of, int face, int other) {
  const auto& partners = of.skins.partners;
  if (std::ranges::count(partners[face], other) > 0) return true;
  const bool beside = std::ranges::any_of(partners[other],
                                          [&](int f) { return of.skins.skin_of[f] == of.skin; });
  return !beside && std::ranges::any_of(partners[face], [&](int f) {
    return in_plane_of(of.model, other, f, of.skins.spread);
  });
}

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

}  // namespace planish::brep
