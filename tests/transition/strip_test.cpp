#include "strip.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

Ring oblique_cylinder() {
  return ring_between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, {30, 0, 80});
}

TEST(Strip, OfAnObliqueCylinderHasParallelRulings) {
  const Strip strip = oblique_cylinder().strip(0);
  EXPECT_EQ(strip.kind(), PatchKind::general);
  EXPECT_EQ(strip.bend_kind(), BendKind::general);
  for (const double at : {0.0, 0.1, 0.37, 0.5, 1.0}) {
    const auto [p, q] = strip.ruling(at);
    EXPECT_LT((q - p - Vec3(30, 0, 80)).norm(), 1e-9) << at;
  }
}

TEST(Strip, HasANormalThatIsSquareToRulingAndProfilesAndPointsOut) {
  for (const Ring& ring : {oblique_cylinder(), square_to_circle(), frustum(), antiprism()})
    for (const Strip& strip : ring.strips)
      for (const double at : {0.01, 0.4, 0.99}) {
        const auto [p, q] = strip.ruling(at);
        const Vec3 n = strip.normal(at);
        EXPECT_NEAR(n.norm(), 1.0, 1e-12);
        EXPECT_NEAR(n.dot((q - p).normalized()), 0.0, 1e-9);
        EXPECT_GT(n.dot(p), 0.0) << "away from the axis";
        for (int side = 0; side < 2; ++side) {
          if (strip.stands(side)) continue;
          const Vec3 step = strip.ruling(at + 1e-6)[side] - strip.ruling(at - 1e-6)[side];
          EXPECT_NEAR(n.dot(step.normalized()), 0.0, 1e-7);
        }
      }
}

TEST(Strip, NumbersItsRulingsBothWays) {
  for (const Ring& ring : {oblique_cylinder(), ring_between(EllipseProfile{50, 30},
                                                            EllipseProfile{20, 40}, {10, 5, 80})})
    for (int side = 0; side < 2; ++side)
      for (const double at : {0.1, 0.45, 0.8}) {
        const Strip& strip = ring.strip(0);
        EXPECT_NEAR(strip.ruling_at(side, strip.parameter(side, at)), at, 1e-11);
      }
}

TEST(Strip, OfARingKnowsWhatItIs) {
  EXPECT_EQ(frustum().strip(0).kind(), PatchKind::cone);
  EXPECT_EQ(frustum().strip(0).bend_kind(), BendKind::cone);
  for (const Strip& strip : square_to_circle().strips) {
    EXPECT_EQ(strip.kind(), strip.plane() ? PatchKind::plane : PatchKind::cone);
    // Triangles stand on the square, cones have their apices in its corners.
    EXPECT_EQ(strip.stands(0), !strip.plane());
    EXPECT_EQ(strip.stands(1), strip.plane());
  }
}

TEST(ArcLength, IsThatOfAnEllipseBackwardsToo) {
  const Ring ring = ring_between(EllipseProfile{50, 30}, EllipseProfile{20, 20}, {0, 0, 80});
  const Element& quarter = ring.hull->boundaries[0].element(0);
  const double exact = 0.25 * ellipse_perimeter(50, 30);
  EXPECT_NEAR(arc_length(quarter, quarter.t0, quarter.t1), exact, 1e-10);
  EXPECT_NEAR(arc_length(quarter, quarter.t1, quarter.t0), -exact, 1e-10);
}

}  // namespace
}  // namespace planish::test
