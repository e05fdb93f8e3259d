#include "hull.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

struct Counts {
  int quadrilaterals = 0, triangles = 0, cones = 0, general = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const Hull& hull) {
  Counts counts;
  for (const HullPatch& patch : hull.patches) {
    const bool both = patch.sides[0].moves() && patch.sides[1].moves();
    ++(patch.plane ? (both ? counts.quadrilaterals : counts.triangles)
                   : (both ? counts.general : counts.cones));
  }
  return counts;
}

/// No point of either profile lies outside a tangent plane.
void expect_supported(const Ring& ring) {
  std::vector<Vec3> points;
  for (const Boundary& boundary : ring.hull->boundaries)
    for (const Element& e : boundary.elements)
      for (int i = 0; i <= 20; ++i)
        points.push_back(e.curve(std::lerp(e.t0, e.t1, i / 20.0)).point);
  for (const RuledPatch& patch : ring.patches)
    for (const double at : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const Vec3 n = patch.normal(at), p = patch.ruling(at)[0];
      for (const Vec3& x : points)
        EXPECT_LT(n.dot(x - p), 1e-7 * ring.size);
    }
}

TEST(LateralHull, OfParallelSquaresIsFourQuadrilaterals) {
  EXPECT_EQ(counts_of(*pyramid().hull), (Counts{.quadrilaterals = 4}));
  expect_supported(pyramid());
}

TEST(LateralHull, OfTurnedSquaresIsATriangleOnEachEdge) {
  EXPECT_EQ(counts_of(*antiprism().hull), (Counts{.triangles = 8}));
  expect_supported(antiprism());
}

TEST(LateralHull, OfASquareAndACircleIsATriangleOnEachEdgeAndAConeInEachCorner) {
  EXPECT_EQ(counts_of(*square_to_circle().hull), (Counts{.triangles = 4, .cones = 4}));
  expect_supported(square_to_circle());
}

TEST(LateralHull, OfTwoCurvesIsOnePatchThatCloses) {
  const Ring ring = ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80});
  ASSERT_EQ(ring.hull->patches.size(), 1u);
  expect_supported(ring);
  const HullPatch& patch = ring.hull->patches[0];
  EXPECT_NEAR(patch.sides[0].t1 - patch.sides[0].t0, 2 * kPi, 1e-9);
  EXPECT_NEAR(patch.sides[1].t1 - patch.sides[1].t0, 2 * kPi, 1e-9);
}

TEST(LateralHull, HasRulingsBetweenTangentsThatLieInOnePlane) {
  const Ring ring = ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 40}, {10, 5, 80});
  for (const HullPatch& patch : ring.hull->patches)
    for (const auto& stop : patch.stops) {
      const SpaceCurvePoint p = ring.hull->element(0, patch.sides[0]).curve(stop[0]),
                            q = ring.hull->element(1, patch.sides[1]).curve(stop[1]);
      const double scale = p.derivative.norm() * q.derivative.norm() * (q.point - p.point).norm();
      EXPECT_LT(std::abs(ahead(p, q)), 1e-12 * scale);
    }
}

TEST(LateralHull, OfARectangleAndARidgeIsARoofOfAnySize) {
  // Two trapezia and two triangles at the hips; of the smallest the ridge is 0.8 long.
  for (const double scale : {1.0, 0.1, 0.005})
    for (const Vec2& end : {Vec2(80, 0), Vec2(-80, 0), Vec2(0, 80), Vec2(0, -80)}) {
      const Ring ring = ring_between(rectangle(400 * scale, 240 * scale),
                                     PolygonProfile{{-scale * end, scale * end}},
                                     {0, 0, 150 * scale});
      EXPECT_EQ(counts_of(*ring.hull), (Counts{.quadrilaterals = 2, .triangles = 2})) << scale;
      expect_supported(ring);
      double area = 0.0;
      for (const RuledPatch& patch : ring.patches)
        area += patch.area(0.0, 1.0);
      // Slopes under the ridge, on the sides along it, and hips on the other two.
      const bool across = end.x() == 0.0;
      const double along = across ? 240 : 400, wide = across ? 400 : 240,
                   half = 0.5 * (along - 160);
      const double roof = (along + 160) * std::hypot(0.5 * wide, 150) +
                          wide * std::hypot(half, 150);
      EXPECT_NEAR(area / (scale * scale), roof, 1e-6);
    }
}

TEST(LateralHull, OfTiltedProfilesIsSupportedEverywhere) {
  TransitionSpec spec = between(RoundedRectangleProfile{120, 80, 15}, ObroundProfile{70, 30},
                                {20, -10, 90});
  spec.to.frame = frame_at({20, -10, 90}, 0.4, 0.9);
  const auto ring = ring_of(spec, {});
  ASSERT_TRUE(ring) << ring.error().message;
  expect_supported(*ring);
}

TEST(Ahead, IsPositiveBeyondTheTangentPlaneAndZeroInIt) {
  const SpaceCurvePoint p{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(ahead(p, {{0, 0, 5}, {3, 0, 0}, {0, 0, 0}}), 0.0) << "parallel tangents";
  EXPECT_EQ(ahead(p, {{7, 0, 5}, {0, 0, 1}, {0, 0, 0}}), 0.0) << "tangents that meet";
  EXPECT_EQ(ahead(p, {{0, 0, 5}, {0, 2, 0}, {0, 0, 0}}), 10.0);
}

}  // namespace
}  // namespace planish::test
