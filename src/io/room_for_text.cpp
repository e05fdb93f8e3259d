#include "room_for_text.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <limits>

namespace planish::io_detail {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// From a point to the nearest side of any ring.
double clearance(const Rings& rings, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& ring : rings)
    least = std::min(least, distance_to_ring(ring, p));
  return least;
}

/// The roomiest point of a grid over the box.
RoomForText roomiest(const Rings& rings, const Box2& box) {
  constexpr int kPoints = 16;  // each way
  RoomForText best{0.5 * (box.lo + box.hi)};
  for (int i = 0; i <= kPoints; ++i) {
    for (int k = 0; k <= kPoints; ++k) {
      const Vec2 share(static_cast<double>(i) / kPoints, static_cast<double>(k) / kPoints);
      const Vec2 p = box.lo + share.cwiseProduct(box.size());
      if (!inside(rings, p)) continue;
      const double radius = clearance(rings, p);
      if (radius > best.radius) best = {p, radius};
    }
  }
  return best;
}

}  // namespace

RoomForText room_for_text(const FlatPattern& pattern) {
  constexpr double kChord = 0.5;  // mm
  Rings rings{sampled(pattern.outer.loop, kChord)};
  for (const Contour& opening : pattern.openings)
    rings.push_back(sampled(opening.loop, kChord));
  return roomiest(rings, bounds(pattern.outer.loop));
}

}  // namespace planish::io_detail
