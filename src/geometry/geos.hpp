#pragma once

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/region.hpp>

#include <geos_c.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <memory>
#include <vector>

namespace planish::geometry_detail {

/// Segments per quarter turn of the arcs with which shrinking rounds notches.
inline constexpr int kQuadrantSegments = 8;
/// Overlays are made on a grid of this share of the largest coordinate. In doubles GEOS 3.11 loses,
/// without a word, one in a thousand intersections of polygons whose borders coincide to within
/// rounding.
inline constexpr double kOverlayGrid = 1e-13;
/// Far below what is cut, far above the rounding of corners.
inline constexpr double kTriangleGrid = tolerance::kComputed;

/// A power of two, so that numbers of few digits lie on it.
inline double overlay_grid(double reach) {
  return reach > 0.0 ? std::exp2(std::floor(std::log2(kOverlayGrid * reach))) : 0.0;
}

inline void ignore_notice(const char*, ...) {}

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
    return areas_in(std::move(valid));
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

  Geometry intersection(const Geometry& a, const Geometry& b, double reach) const {
    Geometry common = own(GEOSIntersectionPrec_r(handle_, a.get(), b.get(), overlay_grid(reach)));
    PLANISH_ASSERT(common);
    return common;
  }

  Geometry difference(const Geometry& a, const Geometry& b, double reach) const {
    Geometry rest = own(GEOSDifferencePrec_r(handle_, a.get(), b.get(), overlay_grid(reach)));
    PLANISH_ASSERT(rest);
    return rest;
  }

  /// Triangles that cover g, with its corners moved to a grid of kTriangleGrid of the extent: on
  /// corners of arbitrary doubles GEOS sometimes fails. Where it does all the same, they cover the
  /// convex hull of g.
  std::vector<std::array<Vec2, 3>> triangles(const Geometry& g, double extent) const {
    std::vector<std::array<Vec2, 3>> found;
    const Geometry even = own(GEOSGeom_setPrecision_r(handle_, g.get(), kTriangleGrid * extent, 0));
    const Geometry all = even ? own(GEOSConstrainedDelaunayTriangulation_r(handle_, even.get()))
                              : own(nullptr);
    if (all) {
      for (const std::vector<Vec2>& ring : rings(all))
        found.push_back({ring[0], ring[1], ring[2]});
      return found;
    }
    const Geometry hull = own(GEOSConvexHull_r(handle_, g.get()));
    PLANISH_ASSERT(hull);
    for (const std::vector<Vec2>& ring : rings(hull))
      for (std::size_t i = 2; i < ring.size(); ++i)
        found.push_back({ring[0], ring[i - 1], ring[i]});
    return found;
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
  /// Its polygons: where a ring runs there and back, what is valid has lines as well, which
  /// overlays refuse beside areas.
  Geometry areas_in(Geometry g) const {
    if (GEOSGeomTypeId_r(handle_, g.get()) != GEOS_GEOMETRYCOLLECTION) return g;
    std::vector<GEOSGeometry*> polygons;
    const auto take = [&](const auto& self, const GEOSGeometry* from) -> void {
      if (GEOSGeomTypeId_r(handle_, from) == GEOS_POLYGON)
        return polygons.push_back(GEOSGeom_clone_r(handle_, from));
      if (GEOSGeomTypeId_r(handle_, from) < GEOS_MULTIPOINT) return;
      for (int i = 0; i < GEOSGetNumGeometries_r(handle_, from); ++i)
        self(self, GEOSGetGeometryN_r(handle_, from, i));
    };
    take(take, g.get());
    return own(GEOSGeom_createCollection_r(handle_, GEOS_MULTIPOLYGON, polygons.data(),
                                           static_cast<unsigned>(polygons.size())));
  }

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

}  // namespace planish::geometry_detail
