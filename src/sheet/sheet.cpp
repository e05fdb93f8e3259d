#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/sheet/sheet.hpp>

namespace planish {

bool Sheet::has(const BorderRef& ref) const {
  if (!faces.has(ref.face)) return false;
  const auto& loops = faces[ref.face].loops;
  return ref.loop >= 0 && ref.loop < std::ssize(loops) && ref.border >= 0 &&
         ref.border < std::ssize(loops[ref.loop]);
}

const Border& Sheet::operator[](const BorderRef& ref) const {
  PLANISH_ASSERT(has(ref));
  return faces[ref.face].loops[ref.loop][ref.border];
}

Border& Sheet::operator[](const BorderRef& ref) {
  PLANISH_ASSERT(has(ref));
  return faces[ref.face].loops[ref.loop][ref.border];
}

const std::vector<FaceId>& Sheet::faces_of(PartId part) const {
  if (const auto* flange = std::get_if<FlangeId>(&part)) return flanges[*flange].faces;
  return bends[std::get<BendId>(part)].faces;
}

FormSide other_side(FormSide side) {
  if (side == FormSide::both) return side;
  return side == FormSide::up ? FormSide::down : FormSide::up;
}

std::string_view side_name(FormSide side) { return word_of(side, {"both", "up", "down"}); }

Bend sharp_bend(double angle) {
  Bend bend;
  bend.kind = BendKind::sharp;
  bend.angle = Angle::radians(std::abs(angle));
  bend.reference_inside = angle < 0.0;
  return bend;
}

Vec3 outward_normal(const Face& face, const Vec2& uv) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->z;
  return face.sense * normal_on(std::get<Developable>(face.surface), uv.x());
}

Vec3 skin_point(const Face& face, const Vec2& uv) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->point(uv);
  return point_on(std::get<Developable>(face.surface), uv);
}

Box2 bounds(const BorderLoop& loop) {
  Box2 box;
  for (const Border& border : loop)
    box.add(bounds(border.curve));
  return box;
}

Box2 parameter_box(const Face& face) { return bounds(face.loops.front()); }

Box2 parameter_box(const Sheet& sheet, const Bend& bend) {
  Box2 box;
  for (const FaceId id : bend.faces)
    box.add(parameter_box(sheet[id]));
  return box;
}

}  // namespace planish
