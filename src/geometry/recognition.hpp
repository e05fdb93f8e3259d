#pragma once

// Whether points in order along a path lie on one line or one circle. Shared by `recognized`
// (points of a spline) and `merged` (points of neighbouring curves).

#include "planar.hpp"

#include <planish/base/tolerance.hpp>

#include <optional>
#include <vector>

namespace planish::geometry_detail {

/// A point of a path, with the length of path that it represents.
struct Station {
  Vec2 point;
  double weight = 1.0;
};

/// Share of a tolerance that stations may use if the extremes between them are not computed: they
/// are so dense that the rest covers what is missed.
inline constexpr double kBetweenStations = 0.98;

/// Points closer than this share of a path's size are one point: the rounding error of a path after
/// some hundred operations.
inline constexpr double kSamePoint = tolerance::kRounding;

/// Largest coordinate difference within the stations and the size of their coordinates.
double size_of(const std::vector<Station>& path);

/// The segment from the first station to the last, if the path stays within `tolerance` of it and
/// never runs back by more.
std::optional<Segment> line_along(const std::vector<Station>& path, double tolerance);

/// The circle through the first and the last station that fits the others best (least squares),
/// turning as the path does; a full circle if the two are one point. The quality of the fit is not
/// checked. Empty if the stations do not determine a circle.
std::optional<Arc> arc_through(const std::vector<Station>& path);

/// Whether the path stays within `tolerance` of the arc from end to end and never runs back by
/// more.
bool follows(const std::vector<Station>& path, const Arc& arc, double tolerance);

}  // namespace planish::geometry_detail
