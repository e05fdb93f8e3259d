#include <planish/geometry/plane.hpp>
#include <planish/sheet/material_places.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

// Which material of the sheet lies near a point when folded: on each face the point's foot along
// the normal, one for every turn of a bend, and if that is outside the face the nearest point
// within its contours. A place counts by its distance in space, so a point between two skins finds
// both.

namespace planish {
namespace {

constexpr double kChord = 0.01;  // mm, of outlines: places are shown, not cut

std::vector<std::vector<Vec2>> rings_of(const Region& region) {
  std::vector<std::vector<Vec2>> rings{sampled(region.outer, kChord)};
  for (const Loop& opening : region.openings)
    rings.push_back(sampled(opening, kChord));
  return rings;
}

Vec2 nearest_within(const std::vector<std::vector<Vec2>>& rings, const Vec2& p) {
  if (inside(rings, p)) return p;
  Vec2 nearest = rings.front().front();
  for (const auto& ring : rings)
    for (const Segment& side : sides_of(ring)) {
      const Vec2 q = nearest_on(side, p);
      if ((q - p).norm() < (nearest - p).norm()) nearest = q;
    }
  return nearest;
}

/// The (u, v) of points of a face on the normal of which p lies: one, or one for each turn.
std::vector<Vec2> feet_of(const Face& face, const Vec3& p) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return {plane->local2(p)};
  const auto& surface = std::get<Developable>(face.surface);
  const Box2 box = parameter_box(face);
  const double middle = 0.5 * (box.lo.x() + box.hi.x());
  const Vec2 foot = parameters_of(surface, p, middle);
  if (std::holds_alternative<Ruled>(surface)) return {foot};
  std::vector<Vec2> feet;
  const double turn = 2.0 * std::numbers::pi;
  const double half = std::ceil(0.5 * (box.hi.x() - box.lo.x()) / turn);
  for (double k = -half; k <= half; ++k)
    feet.emplace_back(foot.x() + k * turn, foot.y());
  return feet;
}

}  // namespace

std::vector<MaterialPlace> material_places(const Sheet& sheet, const Layout& layout, const Vec3& p,
                                           double reach) {
  std::vector<MaterialPlace> places;
  for (const FaceId id : sheet.faces.ids()) {
    const Face& face = sheet[id];
    for (const Vec2& foot : feet_of(face, p)) {
      const double below = sheet.reference_depth -
                           outward_normal(face, foot).dot(p - skin_point(face, foot));
      const double across = std::max({0.0, -below, below - sheet.thickness});
      if (across > reach) continue;
      const Vec2 flat = layout.develop(sheet, id, foot);
      const Vec2 at = nearest_within(rings_of(layout.region(id)), flat);
      const double away = std::hypot(across, (at - flat).norm());
      if (away <= reach) places.push_back({face.part_of, at, away});
    }
  }
  std::ranges::stable_sort(places, {}, &MaterialPlace::away);
  return places;
}

}  // namespace planish
