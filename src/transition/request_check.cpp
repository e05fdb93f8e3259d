#include "request_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace planish::transition_detail {
namespace {

Result<void> check_numbers(const TransitionSpec& spec) {
  if (!(spec.thickness > 0.0) || !std::isfinite(spec.thickness))
    return fail(code::invalid_input,
                fmt::format("the thickness is {} mm; it must be above 0", spec.thickness),
                "/thickness");
  if (!(spec.k_factor >= 0.0 && spec.k_factor <= 1.0))
    return fail(code::invalid_input,
                fmt::format("the K-factor is {}; it must be from 0 to 1", spec.k_factor),
                "/k_factor");
  const auto* count = std::get_if<PressCount>(&spec.pressing);
  const auto* angle = std::get_if<PressAngle>(&spec.pressing);
  const auto* chord = std::get_if<PressChord>(&spec.pressing);
  if ((count && count->count < 1) || (angle && !(angle->largest > Angle())) ||
      (chord && !(chord->largest > 0.0)))
    return fail(code::invalid_input, "press lines need a count, a largest angle or a chord above 0",
                "/press_lines");
  return {};
}

Result<void> check_frame(const Frame& frame, const char* where) {
  for (const Vec3& v : {frame.origin, frame.x, frame.y, frame.z})
    if (!v.allFinite())
      return fail(code::invalid_input, "a coordinate of the frame is not a finite number", where);
  return {};
}

}  // namespace

Result<void> check_request(const TransitionSpec& spec) {
  if (auto sound = check_numbers(spec); !sound) return sound;
  if (auto sound = check_frame(spec.from.frame, "/from/frame"); !sound) return sound;
  return check_frame(spec.to.frame, "/to/frame");
}

}  // namespace planish::transition_detail
