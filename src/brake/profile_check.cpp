// Whether a polygon is the outline of a body. Edges are held against each other pairwise, which is
// quick for the few corners of a tool; what is nearer than the digits in which profiles are
// written counts as touching.
#include "profile_check.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish::brake_detail {
namespace {

constexpr double kSameCorner = tolerance::kWrittenDigits;

const Vec2& cyclic(const ToolProfile& profile, std::size_t i) {
  return profile[i % profile.size()];
}

std::string row(std::size_t corner) { return "/" + std::to_string(corner); }

/// A place in the plane of the profile.
Facts at_corner(const Vec2& p) { return {{"x", p.x(), unit::mm}, {"z", p.y(), unit::mm}}; }

std::optional<ProfileFault> bad_corner(const ToolProfile& profile) {
  if (profile.size() < 3)
    return ProfileFault{"", refuse::few_profile_corners, {{"corners", profile.size()}}};
  for (std::size_t i = 0; i < profile.size(); ++i)
    if (!profile[i].allFinite() || profile[i].cwiseAbs().maxCoeff() > kFarthest)
      return ProfileFault{row(i), refuse::corner_nowhere, {}};
  const double near = corner_tolerance(profile);
  for (std::size_t i = 0; i < profile.size(); ++i)
    if ((cyclic(profile, i + 1) - profile[i]).norm() <= near) {
      const std::size_t again = i + 1 == profile.size() ? i : i + 1;
      return ProfileFault{row(again), refuse::corner_again, at_corner(profile[i])};
    }
  return std::nullopt;
}

/// At a corner whose edges run back over each other the body has no thickness.
bool is_spike(const ToolProfile& profile, std::size_t i, double near) {
  const std::size_t n = profile.size();
  const Vec2 &before = cyclic(profile, i + n - 1), &after = cyclic(profile, i + 1);
  return distance(before, Segment{profile[i], after}) < near ||
         distance(after, Segment{before, profile[i]}) < near;
}

std::optional<ProfileFault> bad_outline(const ToolProfile& profile) {
  const std::size_t n = profile.size();
  const double near = corner_tolerance(profile);
  const auto edges = sides_of(profile);
  const auto crossing = [&](std::size_t i) {
    return ProfileFault{row(i), refuse::profile_crosses, at_corner(profile[i])};
  };
  for (std::size_t i = 0; i < n; ++i)
    if (is_spike(profile, i, near)) return crossing(i);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool neighbours = i == 0 && j + 1 == n;
      if (!neighbours && distance(edges[i], edges[j]) < near) return crossing(j);
    }
  return std::nullopt;
}

}  // namespace

double corner_tolerance(const ToolProfile& profile) {
  double extent = 0.0;
  for (const Vec2& corner : profile)
    extent = std::max(extent, corner.cwiseAbs().maxCoeff());
  return kSameCorner * extent;
}

std::optional<ProfileFault> fault_of(const ToolProfile& profile) {
  if (const auto fault = bad_corner(profile)) return fault;
  if (const auto fault = bad_outline(profile)) return fault;
  if (ring_area(profile) < 0.0) return ProfileFault{"", refuse::runs_clockwise, {}};
  return std::nullopt;
}

std::optional<std::size_t> corner_at(const ToolProfile& profile, const Vec2& place) {
  const auto found = std::ranges::find_if(profile, [&](const Vec2& corner) {
    return (corner - place).norm() <= corner_tolerance(profile);
  });
  if (found == profile.end()) return std::nullopt;
  return static_cast<std::size_t>(found - profile.begin());
}

bool on_outline(const ToolProfile& profile, const Vec2& place) {
  return distance_to_ring(profile, place) <= corner_tolerance(profile);
}

double angle_within(const ToolProfile& profile, std::size_t corner) {
  const Vec2 in = profile[corner] - cyclic(profile, corner + profile.size() - 1);
  const Vec2 out = cyclic(profile, corner + 1) - profile[corner];
  return std::numbers::pi - std::atan2(cross(in, out), in.dot(out));
}

std::optional<ProfileFault> fault_of_rounding(const ToolProfile& profile, std::size_t corner,
                                              double radius) {
  const double turned = std::abs(std::numbers::pi - angle_within(profile, corner));
  const double taken = radius * std::tan(0.5 * turned);
  const Vec2& at = profile[corner];
  const double edge = std::min((cyclic(profile, corner + 1) - at).norm(),
                               (at - cyclic(profile, corner + profile.size() - 1)).norm());
  if (taken <= edge + corner_tolerance(profile)) return std::nullopt;
  return ProfileFault{
      "",
      refuse::radius_takes_edges,
      {{"radius", radius, unit::mm}, {"taken", taken, unit::mm}, {"edge", edge, unit::mm}}};
}

}  // namespace planish::brake_detail
