#pragma once

// Whether points in order along a path lie on one line or one circle. Shared by `recognized`
// (points of a spline) and `merged` (points of neighbouring curves).

#include "planar.hpp"

#include <optional>
#include <vector>

namespace planish::planar {

/// A point of a path with the length of path it stands for.
struct Station {
  Vec2 point;
  double weight = 1.0;
};

/// Where the extremes between stations are not solved for, the stations lie so dense that the
/// deviation between them exceeds that at them by less than this share makes up for.
inline constexpr double between_stations = 0.98;

/// Points nearer than this share of a path's size are one point: what rounding leaves of a path
/// of some hundred operations.
inline constexpr double same_point = 1e-12;

/// Largest coordinate difference within the stations and the size of their coordinates.
double size_of(const std::vector<Station>& path);

/// The segment from the first station to the last, if the path keeps within `tolerance` of it and
/// never runs back by more.
std::optional<Segment> line_along(const std::vector<Station>& path, double tolerance);

/// The circle through the first and the last station that fits the others best (least squares),
/// turning as the path does; a full circle through the first when the two are one point. Says
/// nothing about how well it fits; none when the stations do not determine it.
std::optional<Arc> arc_through(const std::vector<Station>& path);

/// Whether the path keeps within `tolerance` of the arc from end to end and never runs back by
/// more.
bool follows(const std::vector<Station>& path, const Arc& arc, double tolerance);

}  // namespace planish::planar
