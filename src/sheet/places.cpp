#include <planish/sheet/places.hpp>

#include <fmt/format.h>

namespace planish {
namespace {

Vec3 border_middle(const Sheet& sheet, const BorderRef& ref) {
  return skin_point(sheet[ref.face], point_at(sheet[ref].curve, 0.5));
}

/// A face of the solid, or a row of the sheet.
Place numbered(const Sheet& sheet, const BorderRef& ref, const std::optional<int>& number) {
  const Place place = number ? place::face(*number) : place::pointer(pointer_to(ref.face));
  return sheet.has(ref) ? place::at(place, border_middle(sheet, ref)) : place;
}

}  // namespace

std::string pointer_to(FaceId face) { return fmt::format("/faces/{}", index_of(face)); }
std::string pointer_to(const BorderRef& border) {
  return fmt::format("{}/loops/{}/borders/{}", pointer_to(border.face), border.loop, border.border);
}
std::string pointer_to(BendId bend) { return fmt::format("/bends/{}", index_of(bend)); }

Place place_of(const Sheet& sheet, FaceId face) {
  return numbered(sheet, {face, 0, 0}, sheet[face].source_face);
}

Place face_at(const Sheet& sheet, const BorderRef& border) {
  const std::optional<int> own = sheet[border].source_face;
  return numbered(sheet, border, own ? own : sheet[border.face].source_face);
}

Place place_of(const Sheet& sheet, BendId bend) {
  const Place place = place::bend(fmt::format("B{}", index_of(bend) + 1));
  if (!sheet.bends.has(bend)) return place;
  if (!sheet[bend].faces.empty()) {
    const Face& face = sheet[sheet[bend].faces.front()];
    const Box2 box = parameter_box(face);
    return place::at(place, skin_point(face, 0.5 * (box.lo + box.hi)));
  }
  for (const Joint& joint : sheet.joints)
    if (joint.sharp == bend) return place::at(place, border_middle(sheet, joint.a));
  return place;
}

Place edge_at(const Sheet& sheet, const Joint& joint, int edge) {
  const auto face_of = [&](const BorderRef& border) {
    const std::optional<int> own = sheet[border].source_face;
    return own ? own : sheet[border.face].source_face;
  };
  const auto a = face_of(joint.a), b = face_of(joint.b);
  const Place place = a && b ? place::edge(edge, {*a, *b}) : place::edge(edge);
  return place::at(place, border_middle(sheet, joint.a));
}

}  // namespace planish
