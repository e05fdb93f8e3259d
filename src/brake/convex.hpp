#pragma once

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <vector>

namespace planish::brake_detail {

/// Corners of a convex polygon, counter-clockwise; two for a segment, one for a point.
using Convex = std::vector<Vec2>;

/// Convex polygons that together cover the polygon shrunk by `inset`, and nothing else; they meet
/// in sides and corners.
std::vector<Convex> convex_pieces(const Polygon& polygon, double inset = 0.0);

/// Whether the polygon is narrower than that, or nothing.
bool is_thin(const Convex& polygon, double width);

/// Above 0: the polygons are apart, by at least so much. At most 0: they meet, and moving one by
/// so much parts them.
double separation(const Convex& a, const Convex& b);

/// Distance of polygons that are apart; 0 if they meet.
double distance(const Convex& a, const Convex& b);

Convex moved(Convex polygon, const Vec2& by);

/// Seen in a mirror: x of each corner is negated.
Convex mirrored(const Convex& polygon);

}  // namespace planish::brake_detail
