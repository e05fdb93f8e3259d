#include "ruled_patch.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace transition_detail;

Ring oblique_cylinder() {
  return ring_between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, {30, 0, 80});
}

TEST(RuledPatch, OfAnObliqueCylinderHasParallelRulings) {
  const RuledPatch patch = oblique_cylinder().patch(0);
  EXPECT_EQ(patch.kind(), PatchKind::cylinder);
  EXPECT_EQ(patch.bend_kind(), BendKind::general);
  for (const double at : {0.0, 0.1, 0.37, 0.5, 1.0}) {
    const auto [p, q] = patch.ruling(at);
    EXPECT_LT((q - p - Vec3(30, 0, 80)).norm(), 1e-9) << at;
  }
}

TEST(RuledPatch, HasANormalThatIsSquareToRulingAndProfilesAndPointsOut) {
  for (const Ring& ring : {oblique_cylinder(), square_to_circle(), frustum(), antiprism()})
    for (const RuledPatch& patch : ring.patches)
      for (const double at : {0.01, 0.4, 0.99}) {
        const auto [p, q] = patch.ruling(at);
        const Vec3 n = patch.normal(at);
        EXPECT_NEAR(n.norm(), 1.0, 1e-12);
        EXPECT_NEAR(n.dot((q - p).normalized()), 0.0, 1e-9);
        EXPECT_GT(n.dot(p), 0.0) << "away from the axis";
        for (int side = 0; side < 2; ++side) {
          if (patch.stands(side)) continue;
          const Vec3 step = patch.ruling(at + 1e-6)[side] - patch.ruling(at - 1e-6)[side];
          EXPECT_NEAR(n.dot(step.normalized()), 0.0, 1e-7);
        }
      }
}

TEST(RuledPatch, NumbersItsRulingsBothWays) {
  for (const Ring& ring : {oblique_cylinder(), ring_between(EllipseProfile{50, 30},
                                                            EllipseProfile{20, 40}, {10, 5, 80})})
    for (int side = 0; side < 2; ++side)
      for (const double at : {0.1, 0.45, 0.8}) {
        const RuledPatch& patch = ring.patch(0);
        EXPECT_NEAR(patch.ruling_at(side, patch.parameter(side, at)), at, 1e-11);
      }
}

TEST(RuledPatch, OfARingKnowsWhatItIs) {
  EXPECT_EQ(frustum().patch(0).kind(), PatchKind::cone);
  EXPECT_EQ(frustum().patch(0).bend_kind(), BendKind::cone);
  for (const RuledPatch& patch : square_to_circle().patches) {
    EXPECT_EQ(patch.kind(), patch.plane() ? PatchKind::plane : PatchKind::cone);
    // Triangles stand on the square, cones have their apices in its corners.
    EXPECT_EQ(patch.stands(0), !patch.plane());
    EXPECT_EQ(patch.stands(1), patch.plane());
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
