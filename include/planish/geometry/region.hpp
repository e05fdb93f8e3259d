#pragma once

#include <planish/geometry/curve.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish {

/// A plane region: one outer loop (counter-clockwise) and openings (clockwise).
struct Region {
  Loop outer;
  std::vector<Loop> openings;
};

/// A polygon with holes, for overlay; its rings are closed implicitly.
struct Polygon {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};
Polygon polygon_of(const Region& region, double chord);

/// Signed area of a closed ring.
double ring_area(const std::vector<Vec2>& ring);
/// Even-odd test of a point against rings.
bool inside(const std::vector<std::vector<Vec2>>& rings, const Vec2& p);

/// A place where two of the polygons cover the same area.
struct Overlap {
  int first = 0;
  int second = 0;
  double area = 0.0;
  std::vector<std::vector<Vec2>> outline;
};
/// Pairs of polygons whose interiors share more than `smallest_area` once each is shrunk by
/// `clearance`. Bounding boxes are sorted first: near-linear when little overlaps.
/// Rings that cross themselves count by the even-odd rule; `clearance` is at least 0.
std::vector<Overlap> overlaps(const std::vector<Polygon>& polygons, double clearance,
                              double smallest_area);

/// Triangles that together cover what remains of a polygon without others, shrunk by `inset`. They
/// meet in sides and corners and cover nothing else, to within 1e-9 of the extent; of a remainder
/// that cannot be triangulated they cover the convex hull. Rings that cross themselves count by the
/// even-odd rule. What does not meet `within` may be missing. Requires inset ≥ 0. O(n log n) for n
/// corners.
std::vector<std::array<Vec2, 3>> inset_triangles(const Polygon& polygon, double inset,
                                                 const std::vector<Polygon>& without = {},
                                                 const std::optional<Box2>& within = {});

/// Places where a closed ring crosses itself. Only proper crossings count: touching, and crossing
/// exactly at a corner, do not. Near-linear for outlines of ordinary parts.
std::vector<Vec2> self_crossings(const std::vector<Vec2>& ring);

/// Smallest enclosing rectangle: sizes (longer first), and the angle of its long side to the x
/// axis, in (−π/2, π/2]. Zero for fewer than two points. O(n log n).
struct EnclosingRectangle {
  Vec2 size;
  double angle = 0.0;
};
EnclosingRectangle smallest_rectangle(const std::vector<Vec2>& points);

}  // namespace planish
