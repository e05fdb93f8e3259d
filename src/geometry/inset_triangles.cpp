#include "geos.hpp"

#include <planish/geometry/region.hpp>

namespace planish {

using namespace geometry_detail;

namespace {

Polygon rectangle(const Box2& box, double wider) {
  const Vec2 lo = box.lo - Vec2::Constant(wider), hi = box.hi + Vec2::Constant(wider);
  return {{lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}}, {}};
}

}  // namespace

std::vector<std::array<Vec2, 3>> inset_triangles(const Polygon& polygon, double inset,
                                                 const std::vector<Polygon>& without,
                                                 const std::optional<Box2>& within) {
  const Geos geos;
  Geos::Geometry rest = geos.area_of(polygon);
  Box2 box;
  for (const Vec2& p : polygon.outer)
    box.add(p);
  const double extent = polygon.outer.empty() ? 0.0 : (box.hi - box.lo).maxCoeff();
  // Cut wide enough for the cut to be shrunk away from `within`.
  if (within) rest = geos.intersection(rest, geos.area_of(rectangle(*within, 2.0 * inset)), extent);
  for (const Polygon& part : without)
    rest = geos.difference(rest, geos.area_of(part), extent);
  return geos.triangles(geos.shrunk(std::move(rest), inset), extent);
}

}  // namespace planish
