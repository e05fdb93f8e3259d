#include "profile_check.hpp"

#include <planish/base/angle.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {
namespace {

Result<void> check_apart(const std::vector<Vec2>& corners, double size, const std::string& place) {
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    if ((corners[i] - corners[next]).norm() > kNoCorner * size) continue;
    return fail(ErrorCode::repeated_corner,
                fmt::format("points {} and {} lie at the same place, ({:.6g}, {:.6g})", i, next,
                            corners[i].x(), corners[i].y()),
                fmt::format("{}/{}", place, next));
  }
  return {};
}

}  // namespace

Result<void> check_sizes(std::initializer_list<double> sizes, const std::string& place) {
  for (const double size : sizes)
    if (!(size > 0.0) || !std::isfinite(size))
      return fail(ErrorCode::invalid_input,
                  fmt::format("a size is {:.6g} mm; it must be above 0", size), place);
  return {};
}

Result<void> check_radius(double tightest, double outwards, const std::string& place) {
  if (tightest + outwards > kNoCorner * tightest) return {};
  return fail(ErrorCode::radius_too_small,
              fmt::format("the thickness is too large: the neutral surface lies {:.4g} mm within "
                          "the profile that is given, whose smallest radius is {:.4g} mm",
                          -outwards, tightest),
              place);
}

Result<void> check_polygon(const std::vector<Vec2>& corners, const std::string& place) {
  if (corners.size() < 3)
    return fail(
        ErrorCode::too_few_corners,
        fmt::format("a profile needs at least three points; this one has {}", corners.size()),
        place);
  double size = 0.0;
  for (const Vec2& p : corners) {
    if (!p.allFinite())
      return fail(ErrorCode::invalid_input, "a coordinate is not a finite number", place);
    size = std::max(size, (p - corners.front()).norm());
  }
  if (auto apart = check_apart(corners, size, place); !apart) return apart;
  if (const auto at = self_crossings(corners); !at.empty())
    return fail(ErrorCode::self_crossing,
                fmt::format("the profile crosses itself at ({:.6g}, {:.6g})", at.front().x(),
                            at.front().y()),
                place);
  if (std::abs(ring_area(corners)) <= kNoCorner * size * size)
    return fail(ErrorCode::invalid_input, "the profile encloses no area", place);
  return {};
}

Turn turn_at(const std::vector<Vec2>& corners, int i) {
  const int n = static_cast<int>(corners.size());
  return {(corners[i] - corners[(i + n - 1) % n]).normalized(),
          (corners[(i + 1) % n] - corners[i]).normalized()};
}

Result<void> check_convex(const std::vector<Vec2>& corners, const std::function<int(int)>& given,
                          const std::string& place) {
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    const Turn turn = turn_at(corners, i);
    const double along = turn.in.dot(turn.out);
    if (turn.sine() >= -kNoCorner && along > -1.0 + kNoCorner) continue;
    return fail(
        ErrorCode::profile_not_convex,
        fmt::format("the profile is not convex at corner {}, ({:.6g}, {:.6g}), where it turns "
                    "inwards by {:.4g}°: divide it into convex ones",
                    given(i), corners[i].x(), corners[i].y(),
                    Angle::radians(std::atan2(-turn.sine(), along)).degrees()),
        fmt::format("{}/{}", place, given(i)));
  }
  return {};
}

Result<void> check_convex(const PeriodicSpline& spline, double outwards, const std::string& place) {
  const auto& knots = spline.knots();
  constexpr int kSamples = 32;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int i = 0; i <= kSamples; ++i) {
      const PlanePoint at = spline(std::lerp(knots[k], knots[k + 1], i / double(kSamples)));
      const double turning = cross(at.first, at.second), speed = at.first.norm();
      if (speed > 0.0 && turning > kNoCorner * speed * speed * speed / knots.back()) {
        if (turning / (speed * speed * speed) * -outwards < 1.0 - kNoCorner) continue;
        return check_radius(speed * speed * speed / turning, outwards, place);
      }
      return fail(ErrorCode::profile_not_convex,
                  fmt::format("the spline is not convex at ({:.6g}, {:.6g}), between points {} and "
                              "{}: move or add points",
                              at.point.x(), at.point.y(), k, (k + 1) % (knots.size() - 1)),
                  fmt::format("{}/{}", place, k));
    }
  return {};
}

}  // namespace planish::transition_detail
