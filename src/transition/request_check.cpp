#include "request_check.hpp"

#include "refusals.hpp"

#include <cmath>

namespace planish::transition_detail {
namespace {

Result<void> check_numbers(const TransitionSpec& spec) {
  if (!(spec.thickness > 0.0) || !std::isfinite(spec.thickness))
    return fail(refuse::bad_value, {{"name", "The thickness"},
                                    {"value", spec.thickness, unit::mm},
                                    {"range", "a value above 0"},
                                    {"field", place::pointer("/thickness")}});
  if (!(spec.k_factor >= 0.0 && spec.k_factor <= 1.0))
    return fail(refuse::bad_value, {{"name", "The K-factor"},
                                    {"value", spec.k_factor, unit::none},
                                    {"range", "a value from 0 to 1"},
                                    {"field", place::pointer("/k_factor")}});
  const auto* count = std::get_if<PressCount>(&spec.pressing);
  const auto* angle = std::get_if<PressAngle>(&spec.pressing);
  const auto* chord = std::get_if<PressChord>(&spec.pressing);
  if ((count && count->count < 1) || (angle && !(angle->largest > Angle())) ||
      (chord && !(chord->largest > 0.0)))
    return fail(refuse::bad_press_lines, {{"field", place::pointer("/press_lines")}});
  return {};
}

Result<void> check_frame(const Frame& frame, const char* where) {
  for (const Vec3& v : {frame.origin, frame.x, frame.y, frame.z})
    if (!v.allFinite()) return fail(refuse::frame_not_finite, {{"field", place::pointer(where)}});
  return {};
}

}  // namespace

Result<void> check_request(const TransitionSpec& spec) {
  if (auto sound = check_numbers(spec); !sound) return sound;
  if (auto sound = check_frame(spec.from.frame, "/from/frame"); !sound) return sound;
  const auto* polygon = std::get_if<PolygonProfile>(&spec.from.profile);
  if (polygon && (polygon->corners.size() == 1 || polygon->corners.size() == 2))
    return fail(refuse::ridge_first, {{"points", polygon->corners.size()},
                                      {"field", place::pointer("/from/profile/polygon")}});
  return check_frame(spec.to.frame, "/to/frame");
}

}  // namespace planish::transition_detail
