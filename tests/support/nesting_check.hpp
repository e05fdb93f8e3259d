#pragma once

#include <planish/nest/nest.hpp>

#include <geos_c.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

/// Judges a nesting by GEOS alone: exact contours, finely flattened.
namespace planish::test {

/// Contours as GEOS has them, each with its box.
class GeosContours {
 public:
  GeosContours() : context_(GEOS_init_r()) {}
  ~GeosContours() {
    for (GEOSGeometry* polygon : polygons_)
      GEOSGeom_destroy_r(context_, polygon);
    GEOS_finish_r(context_);
  }
  GeosContours(const GeosContours&) = delete;
  GeosContours& operator=(const GeosContours&) = delete;

  void add(const Loop& contour) {
    constexpr double kChord = 1e-4;  // mm
    const std::vector<Vec2> ring = sampled(contour, kChord);
    GEOSCoordSequence* points = GEOSCoordSeq_create_r(context_,
                                                      static_cast<unsigned>(ring.size()) + 1, 2);
    for (unsigned i = 0; i <= ring.size(); ++i) {
      const Vec2& p = ring[i % ring.size()];
      GEOSCoordSeq_setXY_r(context_, points, i, p.x(), p.y());
    }
    polygons_.push_back(GEOSGeom_createPolygon_r(
        context_, GEOSGeom_createLinearRing_r(context_, points), nullptr, 0));
    boxes_.push_back(bounds(contour));
  }

  std::size_t size() const { return polygons_.size(); }
  const Box2& box(std::size_t i) const { return boxes_[i]; }

  double distance(std::size_t i, std::size_t k) const {
    double distance = -1.0;
    GEOSDistance_r(context_, polygons_[i], polygons_[k], &distance);
    return distance;
  }
  double common_area(std::size_t i, std::size_t k) const {
    GEOSGeometry* common = GEOSIntersection_r(context_, polygons_[i], polygons_[k]);
    double area = -1.0;
    GEOSArea_r(context_, common, &area);
    GEOSGeom_destroy_r(context_, common);
    return area;
  }

 private:
  GEOSContextHandle_t context_;
  std::vector<GEOSGeometry*> polygons_;
  std::vector<Box2> boxes_;
};

constexpr double kNestMicrometre = 1e-3;

/// Two contours keep the gap and have no area in common but a seam of a micrometre.
inline void expect_apart(const GeosContours& contours, std::size_t i, std::size_t k, double gap) {
  Box2 reach = contours.box(i);
  reach.lo.array() -= gap + kNestMicrometre;
  reach.hi.array() += gap + kNestMicrometre;
  if (!reach.overlaps(contours.box(k))) return;
  EXPECT_GE(contours.distance(i, k), gap - kNestMicrometre) << i << " and " << k;
  const Vec2 size = contours.box(i).size();
  EXPECT_LE(contours.common_area(i, k), kNestMicrometre * (size.x() + size.y()))
      << i << " and " << k;
}

inline void expect_on_sheet(const Box2& box, const NestOptions& options) {
  const double margin = options.margin.value_or(options.gap) - kNestMicrometre;
  EXPECT_GE(box.lo.x(), margin);
  EXPECT_GE(box.lo.y(), margin);
  EXPECT_LE(box.hi.x(), options.length - margin);
  EXPECT_LE(box.hi.y(), options.width - margin);
}

inline double material_of(const FlatPattern& flat) {
  double area = signed_area(flat.outer.loop);
  for (const Contour& opening : flat.openings)
    area += signed_area(opening.loop);
  return area;
}

/// Everything a nesting promises: each copy once or its part too large, gap and margin kept, no
/// reflection, the grain kept, the use as the areas say.
inline void expect_sound(const Nesting& nesting, const std::vector<NestPart>& parts,
                         const NestOptions& options) {
  std::set<std::pair<int, int>> seen;
  for (const NestedSheet& sheet : nesting.sheets) {
    GeosContours contours;
    double area = 0.0;
    EXPECT_FALSE(sheet.placed.empty());
    for (const Placed& placed : sheet.placed) {
      ASSERT_TRUE(seen.emplace(placed.part, placed.copy).second) << "placed twice";
      const FlatPattern& flat = *parts[placed.part].flat;
      const auto motion = placed.placement.linear();
      EXPECT_NEAR(motion.determinant(), 1.0, 1e-12);
      EXPECT_NEAR((motion.transpose() * motion - Eigen::Matrix2d::Identity()).norm(), 0.0, 1e-12);
      if (options.grain) {
        EXPECT_EQ(std::abs(motion(0, 0)), 1.0);
      }
      contours.add(transformed(flat.outer.loop, placed.placement));
      expect_on_sheet(contours.box(contours.size() - 1), options);
      area += material_of(flat);
    }
    for (std::size_t i = 0; i < contours.size(); ++i)
      for (std::size_t k = i + 1; k < contours.size(); ++k)
        expect_apart(contours, i, k, options.gap);
    EXPECT_NEAR(sheet.use, area / (options.length * options.width), 1e-9);
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    int placed = 0;
    for (const auto& copy : seen)
      placed += copy.first == static_cast<int>(part) ? 1 : 0;
    const bool too_large = std::ranges::any_of(nesting.too_large, [&](const TooLarge& large) {
      return large.part == static_cast<int>(part);
    });
    EXPECT_EQ(placed, too_large ? 0 : parts[part].quantity) << "part " << part;
    for (int copy = 0; copy < placed; ++copy)
      EXPECT_TRUE(seen.contains({static_cast<int>(part), copy}));
  }
}

}  // namespace planish::test
