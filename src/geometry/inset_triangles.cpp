// Triangles of a polygon shrunk by an inset, without others: GEOS overlays and triangulates. Where
// it fails, which it does for many corners in line, the plane is turned and it tries again; the
// hull is the last answer.

#include "geos.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <Eigen/Geometry>

#include <cmath>

// Triangles of a polygon shrunk by an inset, for blocks of collision tests. GEOS does the Boolean
// work and the triangulation; it fails now and then where many corners are in line, so what is
// found must have the area of what was asked for, and otherwise the polygon is turned and tried
// again.

namespace planish {

using namespace geometry_detail;

namespace {

using Triangles = std::vector<std::array<Vec2, 3>>;

Polygon rectangle(const Box2& box, double wider) {
  const Vec2 lo = box.lo - Vec2::Constant(wider), hi = box.hi + Vec2::Constant(wider);
  return {{lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}}, {}};
}

Polygon turned(Polygon polygon, const Eigen::Rotation2Dd& turn) {
  for (Vec2& p : polygon.outer)
    p = turn * p;
  for (auto& hole : polygon.holes)
    for (Vec2& p : hole)
      p = turn * p;
  return polygon;
}

double area_of(const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 u = b - a, v = c - a;
    sum += 0.5 * std::abs(cross(u, v));
  }
  return sum;
}

}  // namespace

Triangles inset_triangles(const Polygon& polygon, double inset, const std::vector<Polygon>& without,
                          const std::optional<Box2>& within) {
  const Geos geos;
  const Box2 box = box_of(polygon.outer);
  const double extent = polygon.outer.empty() ? 0.0 : (box.hi - box.lo).maxCoeff();
  Triangles found;
  // GEOS now and then fails where many corners of openings are in line, which they are in one turn
  // alone. Then its triangles cover the hull.
  for (const double angle : {0.0, 0.7, 1.9}) {  // rad
    const Eigen::Rotation2Dd turn(angle);
    Geos::Geometry rest = geos.area_of(turned(polygon, turn));
    // Cut wide enough for the cut to be shrunk away from `within`.
    if (within)
      rest = geos.intersection(rest, geos.area_of(turned(rectangle(*within, 2.0 * inset), turn)),
                               extent);
    for (const Polygon& part : without)
      rest = geos.difference(rest, geos.area_of(turned(part, turn)), extent);
    const Geos::Geometry left = geos.shrunk(std::move(rest), inset);
    found = geos.triangles(left, extent);
    for (auto& triangle : found)
      for (Vec2& corner : triangle)
        corner = turn.inverse() * corner;
    constexpr double kWhole = 1e-7;  // of the square about it: corners lie on a grid
    if (std::abs(area_of(found) - geos.area(left)) <= kWhole * extent * extent) break;
  }
  return found;
}

}  // namespace planish
