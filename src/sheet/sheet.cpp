#include <planish/sheet/sheet.hpp>

namespace planish {

Vec3 outward_normal(const Face& face, const Vec2& uv) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->z;
  return face.sense * normal_on(std::get<Developable>(face.surface), uv.x());
}

Vec3 skin_point(const Face& face, const Vec2& uv) {
  if (const auto* plane = std::get_if<Frame>(&face.surface)) return plane->point(uv);
  return point_on(std::get<Developable>(face.surface), uv);
}

}  // namespace planish
