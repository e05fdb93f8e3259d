#include <planish/schema/json_parts.hpp>

#include <cmath>

namespace planish::schema {

Json number_json(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value == 0.0 ? 0.0 : value;  // no "-0.0"
}

Json number_json(const std::optional<double>& value) {
  return value ? number_json(*value) : Json(nullptr);
}

Json point_json(const Vec2& p, const Units& units) {
  return Json::array({number_json(units.length(p.x())), number_json(units.length(p.y()))});
}

Json space_point_json(const Vec3& p, const Units& units) {
  return Json::array({number_json(units.length(p.x())), number_json(units.length(p.y())),
                      number_json(units.length(p.z()))});
}

std::string text_of(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planish::schema
