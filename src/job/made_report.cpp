#include "made_report.hpp"

#include <cmath>

namespace planish::job {

using namespace schema;

Json page_point(const Vec3& p) {
  return Json::array({std::isfinite(p.x()) ? Json(p.x()) : Json(nullptr),
                      std::isfinite(p.y()) ? Json(p.y()) : Json(nullptr),
                      std::isfinite(p.z()) ? Json(p.z()) : Json(nullptr)});
}

Json page_points(const std::vector<Vec3>& points) {
  return json_array(points, [&](const Vec3& p) { return page_point(p); });
}

std::string page_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace planish::job
