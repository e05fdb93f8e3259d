#include "geos.hpp"

#include <planish/geometry/region.hpp>

namespace planish {

using namespace geometry_detail;

std::vector<std::array<Vec2, 3>> inset_triangles(const Polygon& polygon, double inset,
                                                 const std::vector<Polygon>& without) {
  const Geos geos;
  Geos::Geometry rest = geos.area_of(polygon);
  Box2 box;
  for (const Vec2& p : polygon.outer)
    box.add(p);
  const double extent = polygon.outer.empty() ? 0.0 : (box.hi - box.lo).maxCoeff();
  for (const Polygon& part : without)
    rest = geos.difference(rest, geos.area_of(part), extent);
  return geos.triangles(geos.shrunk(std::move(rest), inset), extent);
}

}  // namespace planish
