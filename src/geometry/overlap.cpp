#include "planar.hpp"

#include <planish/geometry/region.hpp>

#include <geos_c.h>

#include <cstdarg>
#include <memory>
#include <numeric>

namespace planish {
namespace {

using namespace geometry_detail;

/// Segments per quarter turn of the arcs with which shrinking rounds notches.
constexpr int kQuadrantSegments = 8;
/// An overlay that fails in doubles is repeated on a grid of this share of the extent, on which
/// GEOS never fails.
constexpr double kRescueGrid = 1e-11;

void ignore_notice(const char*, ...) {}

/// GEOS with its own state, so that calls from several threads are independent.
class Geos {
 public:
  struct Release {
    GEOSContextHandle_t handle;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Release>;

  Geos() : handle_(GEOS_init_r()) {
    GEOSContext_setNoticeHandler_r(handle_, ignore_notice);
    GEOSContext_setErrorHandler_r(handle_, ignore_notice);
  }
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  /// The area covered by a polygon, by the even-odd rule if its rings cross.
  Geometry area_of(const Polygon& polygon) const {
    Geometry outer = ring(polygon.outer);
    if (!outer) return own(GEOSGeom_createEmptyPolygon_r(handle_));
    std::vector<GEOSGeometry*> holes;
    for (const std::vector<Vec2>& hole : polygon.holes) {
      if (Geometry g = ring(hole)) holes.push_back(g.release());
    }
    Geometry made = own(GEOSGeom_createPolygon_r(handle_, outer.release(), holes.data(),
                                                 static_cast<unsigned>(holes.size())));
    PLANISH_ASSERT(made);
    if (GEOSisValid_r(handle_, made.get()) == 1) return made;
    Geometry valid = own(GEOSMakeValid_r(handle_, made.get()));
    PLANISH_ASSERT(valid);
    return valid;
  }

  Geometry shrunk(Geometry g, double by) const {
    if (by <= 0.0) return g;
    Geometry smaller = own(GEOSBuffer_r(handle_, g.get(), -by, kQuadrantSegments));
    PLANISH_ASSERT(smaller);
    return smaller;
  }

  bool intersect(const Geometry& a, const Geometry& b) const {
    return GEOSIntersects_r(handle_, a.get(), b.get()) != 0;  // 2 means "cannot tell": look closer
  }

  Geometry intersection(const Geometry& a, const Geometry& b, double extent) const {
    Geometry common = own(GEOSIntersection_r(handle_, a.get(), b.get()));
    if (!common)
      common = own(GEOSIntersectionPrec_r(handle_, a.get(), b.get(), kRescueGrid * extent));
    PLANISH_ASSERT(common);
    return common;
  }

  double area(const Geometry& g) const {
    double value = 0.0;
    GEOSArea_r(handle_, g.get(), &value);
    return value;
  }

  /// All rings of all polygons in g, outer ones and holes.
  std::vector<std::vector<Vec2>> rings(const Geometry& g) const {
    std::vector<std::vector<Vec2>> found;
    for (int i = 0; i < GEOSGetNumGeometries_r(handle_, g.get()); ++i) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(handle_, g.get(), i);
      // An overlay may also contain points and lines where boundaries touch.
      if (GEOSGeomTypeId_r(handle_, part) != GEOS_POLYGON || GEOSisEmpty_r(handle_, part) == 1)
        continue;
      found.push_back(corners(GEOSGetExteriorRing_r(handle_, part)));
      for (int k = 0; k < GEOSGetNumInteriorRings_r(handle_, part); ++k) {
        found.push_back(corners(GEOSGetInteriorRingN_r(handle_, part, k)));
      }
    }
    return found;
  }

 private:
  Geometry own(GEOSGeometry* g) const { return Geometry(g, Release{handle_}); }

  /// Closed ring; null for fewer than three corners.
  Geometry ring(const std::vector<Vec2>& points) const {
    if (points.size() < 3) return own(nullptr);
    const auto n = static_cast<unsigned>(points.size());
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle_, n + 1, 2);
    for (unsigned i = 0; i <= n; ++i) {
      const Vec2& p = points[i % n];
      GEOSCoordSeq_setXY_r(handle_, sequence, i, p.x(), p.y());
    }
    return own(GEOSGeom_createLinearRing_r(handle_, sequence));
  }

  std::vector<Vec2> corners(const GEOSGeometry* ring) const {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(handle_, ring);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(handle_, sequence, &n);
    std::vector<Vec2> points;
    for (unsigned i = 0; i + 1 < n; ++i) {
      double x = 0.0;
      double y = 0.0;
      GEOSCoordSeq_getXY_r(handle_, sequence, i, &x, &y);
      points.emplace_back(x, y);
    }
    return points;
  }

  GEOSContextHandle_t handle_;
};

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
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t k) { return boxes[i].lo[axis] < boxes[k].lo[axis]; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<std::size_t> open;
  for (const std::size_t i : order) {
    std::erase_if(open, [&](std::size_t k) { return boxes[k].hi[axis] <= boxes[i].lo[axis]; });
    for (const std::size_t k : open) {
      if (boxes[k].overlaps(boxes[i])) pairs.emplace_back(std::min(i, k), std::max(i, k));
    }
    open.push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
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
    const Geos::Geometry common = geos.intersection(a, b, largest(all.size()));
    const double shared = geos.area(common);
    if (!(shared > smallest_area)) continue;
    found.push_back(
        {static_cast<int>(first), static_cast<int>(second), shared, geos.rings(common)});
  }
  return found;
}

}  // namespace planish
