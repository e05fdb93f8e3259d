#include "profile_check.hpp"

#include "refusals.hpp"

#include <planish/base/angle.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <string>

// Whether a profile can bound a hull (math.md#lateral-hull): a simple polygon, convex to within
// rounding, or a spline that turns one way, and curved less than the thickness allows where it is
// set off inwards. Corners are told as they were given, also where the profile was reversed.
// Splines are sampled between knots, since their curvature is no closed form.

namespace planish::transition_detail {
namespace {

/// A point of a profile in the request.
Place point_pointer(const std::string& place, int i) {
  return place::pointer(place + "/" + std::to_string(i));
}

Result<void> check_apart(const std::vector<Vec2>& corners, double size, const std::string& place) {
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const double apart = (corners[i] - corners[next]).norm();
    if (apart > 0.0 && apart > kNoCorner * size) continue;
    return fail(refuse::point_repeated, {{"point", i + 1},
                                         {"next", next + 1},
                                         {"x", corners[i].x(), unit::mm},
                                         {"y", corners[i].y(), unit::mm},
                                         {"repeated", point_pointer(place, next)},
                                         {"field", point_pointer(place, i)}});
  }
  return {};
}

}  // namespace

Result<void> check_sizes(std::initializer_list<double> sizes, const std::string& place) {
  for (const double size : sizes)
    if (!(size > 0.0) || !std::isfinite(size))
      return fail(refuse::bad_value, {{"name", "A size of the profile"},
                                      {"value", size, unit::mm},
                                      {"range", "a value above 0"},
                                      {"field", place::pointer(place)}});
  return {};
}

Result<void> check_radius(double tightest, double outwards, const std::string& place) {
  if (tightest + outwards > kNoCorner * tightest) return {};
  return fail(refuse::thicker_than_radius, {{"inwards", -outwards, unit::mm},
                                            {"radius", tightest, unit::mm},
                                            {"field", place::pointer(place)}});
}

Result<void> check_ridge(const std::vector<Vec2>& corners, const std::string& place) {
  double size = 0.0;
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    const Vec2& p = corners[i];
    if (!p.allFinite())
      return fail(refuse::point_not_finite, {{"point", i + 1}, {"field", point_pointer(place, i)}},
                  place);
    size = std::max(size, (p - corners.front()).norm());
  }
  return corners.size() > 1 ? check_apart(corners, size, place) : Result<void>();
}

Result<void> check_polygon(const std::vector<Vec2>& corners, const std::string& place) {
  if (corners.size() < 3)
    return fail(refuse::few_points, {{"points", corners.size()}, {"field", place::pointer(place)}});
  if (auto apart = check_ridge(corners, place); !apart) return apart;
  if (const auto at = self_crossings(corners); !at.empty())
    return fail(refuse::profile_crosses_itself, {{"x", at.front().x(), unit::mm},
                                                 {"y", at.front().y(), unit::mm},
                                                 {"field", place::pointer(place)}});
  const double size = (box_of(corners).hi - box_of(corners).lo).norm();
  if (std::abs(ring_area(corners)) <= kNoCorner * size * size)
    return fail(refuse::no_area, {{"field", place::pointer(place)}});
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
    const double inwards = Angle::radians(std::atan2(-turn.sine(), along)).degrees();
    return fail(refuse::turns_inwards, {{"corner", given(i) + 1},
                                        {"x", corners[i].x(), unit::mm},
                                        {"y", corners[i].y(), unit::mm},
                                        {"angle", inwards, unit::degrees},
                                        {"field", point_pointer(place, given(i))}});
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
      return fail(refuse::spline_turns_inwards,
                  {{"x", at.point.x(), unit::mm},
                   {"y", at.point.y(), unit::mm},
                   {"point", k + 1},
                   {"next", (k + 1) % (knots.size() - 1) + 1},
                   {"field", point_pointer(place, static_cast<int>(k))}});
    }
  return {};
}

}  // namespace planish::transition_detail
