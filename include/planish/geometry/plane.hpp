#pragma once

#include <planish/geometry/curve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ranges>
#include <vector>

// Vectors, segments and boxes of the plane. Everything is exact up to rounding and takes constant
// time, or time in proportion to the points given.

namespace planish {

/// |a| |b| sin of the angle from a to b: above 0 if b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

inline double angle_of(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// Where the point of a segment nearest to p lies: 0 at its start, 1 at its end. 0 of a segment
/// without length.
inline double nearest_share(const Segment& segment, const Vec2& p) {
  const Vec2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  return square > 0.0 ? std::clamp(along.dot(p - segment.a) / square, 0.0, 1.0) : 0.0;
}

/// The point of a segment nearest to p.
inline Vec2 nearest_on(const Segment& segment, const Vec2& p) {
  return segment.a + nearest_share(segment, p) * (segment.b - segment.a);
}

inline double distance(const Vec2& p, const Segment& segment) {
  return (p - segment.a - nearest_share(segment, p) * (segment.b - segment.a)).norm();
}

/// Whether segments cross: the ends of each lie on both sides of the other. Touching is none.
bool properly_cross(const Segment& a, const Segment& b);

/// Of two segments: 0 if they meet.
double distance(const Segment& a, const Segment& b);

/// The smallest box that holds the points.
Box2 box_of(const std::vector<Vec2>& points);

/// The sides of a ring, each from a corner to the next: a view, which the ring must outlive.
inline auto sides_of(const std::vector<Vec2>& ring) {
  return std::views::iota(std::size_t{0}, ring.size()) |
         std::views::transform([&ring](std::size_t i) {
           return Segment{ring[i], ring[(i + 1) % ring.size()]};
         });
}
void sides_of(std::vector<Vec2>&& ring) = delete;

/// Of a point from the nearest side of a ring, inside as outside; infinite without corners.
double distance_to_ring(const std::vector<Vec2>& ring, const Vec2& p);

/// The part of a convex polygon where normal·p ≤ offset; empty if nothing remains.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& normal, double offset);

/// Convex hull, counter-clockwise, without points on its edges (Andrew's chains).
std::vector<Vec2> hull_of(std::vector<Vec2> points);

}  // namespace planish
