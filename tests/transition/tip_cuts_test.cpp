#include "tip_cuts.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

TransitionSpec thick(double thickness) {
  TransitionSpec spec;
  spec.thickness = thickness;
  spec.k_factor = 0.5;
  return spec;
}

TipCuts cuts(const Ring& ring, double thickness) { return {ring, {whole(ring)}, thick(thickness)}; }

double largest(const RuledPatch::Tips& tips) {
  return std::max({tips.at_from[0], tips.at_from[1], tips.at_to[0], tips.at_to[1]});
}

TEST(TipCuts, LeaveCornersWholeInWhichOneFoldEnds) {
  const Ring ring = pyramid();
  const TipCuts tips = cuts(ring, 2.0);
  for (const RuledPatch& patch : ring.patches)
    EXPECT_EQ(largest(tips.of(patch, 0.0, 1.0)), 0.0);
}

TEST(TipCuts, AreMadeWhereSeveralFoldsMeet) {
  const Ring ring = antiprism();
  const TipCuts tips = cuts(ring, 2.0);
  for (const RuledPatch& patch : ring.patches)
    if (patch.stands(0)) {
      EXPECT_GT(largest(tips.of(patch, 0.0, 1.0)), 0.0);
    }
}

TEST(TipCuts, GrowWithTheThickness) {
  for (const Ring& ring : {antiprism(), square_to_circle()}) {
    const TipCuts thin = cuts(ring, 1.0), twice = cuts(ring, 2.0);
    for (const RuledPatch& patch : ring.patches)
      EXPECT_NEAR(largest(twice.of(patch, 0.0, 1.0)), 2 * largest(thin.of(patch, 0.0, 1.0)), 1e-9);
  }
}

TEST(TipCuts, CutConesWhereTheirInsideRadiusIsATenthOfTheThickness) {
  const double t = 2.0;
  const Ring ring = square_to_circle();
  const TipCuts tips = cuts(ring, t);
  for (const RuledPatch& patch : ring.patches) {
    if (patch.plane()) continue;
    const double cut = tips.of(patch, 0.0, 1.0).at_from[0];
    EXPECT_NEAR(cut, patch.distance_of_radius(0.5 * t + 0.1 * t), 1e-12);
  }
}

TEST(TipCuts, RefuseASheetOfWhichTheyLeaveNothing) {
  const Ring ring = square_to_circle();
  const auto room = [&](double thickness) {
    const TipCuts tips = cuts(ring, thickness);
    for (const RuledPatch& patch : ring.patches)
      if (auto enough = tips.leave_room(patch, 0.0, 1.0); !enough) return enough;
    return Result<void>{};
  };
  EXPECT_TRUE(room(2.0));
  const auto refused = room(60.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::radius_too_small);
  EXPECT_EQ(refused.error().where, "/thickness");
}

TEST(TipCuts, LeaveTheInsideOfAPanelWideEnoughBetweenTwoFolds) {
  // Each fold moves the inside of the panel away by inside · tan(fold / 2); between the two at
  // least the arcs of a tenth of the thickness that both turn must be left.
  const double t = 2.0, inside = 0.5 * t, radius = 0.1 * t;
  const Ring ring = antiprism();
  const TipCuts tips = cuts(ring, t);
  for (int i = 1; i + 1 < ring.count(); ++i) {
    const RuledPatch& patch = ring.patch(i);
    const std::size_t side = patch.stands(0) ? 0 : 1;
    const Vec3 corner = patch.ruling(0.0)[side];
    const Vec3 one = (patch.ruling(0.0)[1 - side] - corner).normalized(),
               other = (patch.ruling(1.0)[1 - side] - corner).normalized();
    const auto fold_to = [&](int neighbour) {
      return std::acos(patch.normal(0.5).dot(ring.patch(neighbour).normal(0.5)));
    };
    const double before = fold_to(i - 1), after = fold_to(i + 1);
    const double cut = tips.of(patch, 0.0, 1.0).at_from[side];
    // In the panel, from where each side is cut, square to it.
    const Vec3 normal = one.cross(other).normalized();
    const Vec3 from = cut * one + inside * std::tan(before / 2) * normal.cross(one),
               to = cut * other - inside * std::tan(after / 2) * normal.cross(other);
    const double width = (to - from).dot((other - one).normalized());
    EXPECT_GE(width, 0.5 * radius * (before + after) - 1e-9) << i;
  }
}

}  // namespace
}  // namespace planish::test
