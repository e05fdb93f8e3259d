// Pairs of polygons that share area: boxes swept along the longer side of all, then GEOS for what
// is left. Each is shrunk by the clearance first, so that neighbours that touch share nothing.

#include "geos.hpp"

#include <planish/geometry/region.hpp>

// Which polygons cover each other, by more than a clearance and an area. A sweep along the longer
// side of all boxes leaves pairs whose boxes share area; only these are shrunk by the clearance,
// each polygon once, and intersected by GEOS.

namespace planish {
namespace {

using namespace geometry_detail;

/// Pairs of boxes that share area, found by sweeping along the longer side of all boxes together.
std::vector<std::pair<std::size_t, std::size_t>> overlapping_boxes(const std::vector<Box2>& boxes) {
  Box2 all;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].empty()) continue;
    all.add(boxes[i]);
    order.push_back(i);
  }
  const int axis = !all.empty() && all.size().y() > all.size().x() ? 1 : 0;
  std::ranges::sort(order, {}, [&](std::size_t i) { return boxes[i].lo[axis]; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<std::size_t> open;
  for (const std::size_t i : order) {
    std::erase_if(open, [&](std::size_t k) { return boxes[k].hi[axis] <= boxes[i].lo[axis]; });
    for (const std::size_t k : open) {
      if (boxes[k].overlaps(boxes[i])) pairs.emplace_back(std::min(i, k), std::max(i, k));
    }
    open.push_back(i);
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

std::vector<Overlap> overlaps(const std::vector<Polygon>& polygons, double clearance,
                              double smallest_area) {
  std::vector<Box2> boxes(polygons.size());
  Box2 all;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    for (const Vec2& p : polygons[i].outer)
      boxes[i].add(p);
    all.add(boxes[i]);
    boxes[i].lo.array() += clearance;
    boxes[i].hi.array() -= clearance;
    if ((boxes[i].lo.array() > boxes[i].hi.array()).any()) boxes[i] = Box2{};
  }
  const double reach = all.empty() ? 0.0 : all.lo.cwiseAbs().cwiseMax(all.hi.cwiseAbs()).maxCoeff();
  const Geos geos;
  // Only polygons that may meet another are passed to GEOS.
  std::vector<Geos::Geometry> shrunk(polygons.size());
  const auto area_of = [&](std::size_t i) -> const Geos::Geometry& {
    if (!shrunk[i]) shrunk[i] = geos.shrunk(geos.area_of(polygons[i]), clearance);
    return shrunk[i];
  };
  std::vector<Overlap> found;
  for (const auto& [first, second] : overlapping_boxes(boxes)) {
    const Geos::Geometry& a = area_of(first);
    const Geos::Geometry& b = area_of(second);
    if (!geos.intersect(a, b)) continue;
    const Geos::Geometry common = geos.intersection(a, b, reach);
    const double shared = geos.area(common);
    if (!(shared > smallest_area)) continue;
    found.push_back(
        {static_cast<int>(first), static_cast<int>(second), shared, geos.rings(common)});
  }
  return found;
}

}  // namespace planish
