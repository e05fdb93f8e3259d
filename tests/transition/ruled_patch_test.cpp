#include "ruled_patch.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

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

/// The slowest that a ruling's end goes along a side; 1: as fast as the rulings are numbered.
double slowest(const RuledPatch& patch, int side) {
  constexpr int kSteps = 500;
  const double whole = patch.parameter(side, 1.0) - patch.parameter(side, 0.0);
  double least = 1.0;
  for (int i = 0; i < kSteps; ++i) {
    const double from = i / double(kSteps), to = (i + 1) / double(kSteps);
    const double way = patch.parameter(side, to) - patch.parameter(side, from);
    least = std::min(least, way / whole * kSteps);
  }
  return least;
}

/// Through points of an ellipse.
SplineProfile spline_round(const Vec2& radii) {
  SplineProfile spline;
  for (int i = 0; i < 32; ++i) {
    const double t = 2.0 * kPi * i / 32;
    spline.points.emplace_back(radii.x() * std::cos(t), radii.y() * std::sin(t));
  }
  return spline;
}

/// Round the tight ends of a narrow ellipse rulings go slowly, more so than on a circle beside its
/// flat sides; its spline counts millimetres, the circle radians.
TEST(RuledPatch, IsWrittenAboutTheSideThatMovesMostEverywhere) {
  const EllipseProfile circle{30, 30};
  for (const Vec2& radii : {Vec2(80, 20), Vec2(20, 80)})
    for (const int round : {0, 1}) {  // the circle's side
      const SplineProfile narrow = spline_round(radii);
      const Ring ring = round == 0 ? ring_between(circle, narrow, {5, 3, 80})
                                   : ring_between(narrow, circle, {5, 3, 80});
      ASSERT_EQ(ring.count(), 1);
      const RuledPatch& patch = ring.patch(0);
      EXPECT_GT(slowest(patch, round), 1.2 * slowest(patch, 1 - round));
      const RuledPatch::Part part = patch.part(0.1, 0.9, {});
      const auto& surface = std::get<Developable>(part.face.surface);
      for (const double at : {0.1, 0.3, 0.6, 0.8}) {
        const Vec3 base = point_on(surface, {part.u(at), 0.0});
        EXPECT_LT((base - patch.ruling(at)[round]).norm(), 1e-6) << round;
      }
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
