#include "outline.hpp"

#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

TEST(RingArea, IsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(ring_area({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), 12.0);
  EXPECT_DOUBLE_EQ(ring_area({{0, 3}, {4, 3}, {4, 0}, {0, 0}}), -12.0);
}

TEST(Outlines, OfPlanesAndCylindersHaveTheirAreas) {
  const SolidModel bent = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  const auto outlines = outlines_of(bent);
  EXPECT_NEAR(outlines[2].area, 50 * 40, 1e-9);
  EXPECT_NEAR(outlines[3].area, 5 * pi / 2 * 40, 1e-9);
  EXPECT_NEAR(outlines[7].area, 3 * pi / 2 * 40, 1e-9);
  EXPECT_NEAR(outlines[3].u_scale, 5.0, 1e-12);
}

TEST(Outlines, TakeOpeningsOff) {
  const auto outlines = outlines_of(plate(2, {20, 20}, {{{10, 10}, {{3, 2}, {3, 0}}}}));
  const double polygon = 12 * 9 * std::sin(pi / 12);  // of 24 sides
  EXPECT_NEAR(outlines[1].area, 400 - polygon, 1e-9);
}

TEST(Outlines, FollowShallowArcsByTwoChords) {
  const double half = pi / 30, radius = 10 / std::sin(half);  // 12° over a chord of 20
  const Arc arc{{10, 10 - radius * std::cos(half)}, radius, pi / 2 - half, 2 * half};
  const Loop profile{Segment{{0, 0}, {20, 0}}, Segment{{20, 0}, {20, 10}}, arc,
                     Segment{{0, 10}, {0, 0}}};
  const auto outlines = outlines_of(prism({profile}, 5));
  EXPECT_NEAR(outlines[kBottom].area, 200 + 10 * radius * (1 - std::cos(half)), 1e-9);
}

TEST(Outlines, TakeNothingOffForALoopThatIsAPoint) {
  SolidModel model = plate(2, {20, 20});
  model.faces[kTop].loops.emplace_back();
  EXPECT_NEAR(outlines_of(model)[kTop].area, 400, 1e-9);
  std::swap(model.faces[kTop].loops.front(), model.faces[kTop].loops.back());
  EXPECT_EQ(outlines_of(model)[kTop].area, 0.0) << "no point to measure from";
}

TEST(Opposite, MeasuresDepthAndSharedArea) {
  const SolidModel model = plate(2, {100, 60});
  const auto outlines = outlines_of(model);
  const auto seen = opposite(model, outlines, 0, 1);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->depth, 2.0, 1e-12);
  EXPECT_NEAR(seen->spread, 0.0, 1e-12);
  EXPECT_NEAR(seen->overlap, 6000.0, 1e-9);
}

TEST(Opposite, IsSeenThroughMaterialOnly) {
  // The two legs of a U face each other through air at 20 mm, through both legs at 24 mm.
  const SolidModel u = prism({strip_profile(2, {{40, pi / 2, 3}, {14, pi / 2, 3}, {40}})}, 30);
  const auto outlines = outlines_of(u);
  const int outer_a = 2, outer_b = 6, inner_b = 8, inner_a = 12;
  ASSERT_TRUE(opposite(u, outlines, outer_a, outer_b));
  EXPECT_NEAR(opposite(u, outlines, outer_a, outer_b)->depth, 24.0, 1e-9);
  EXPECT_FALSE(opposite(u, outlines, inner_a, inner_b));
  EXPECT_NEAR(opposite(u, outlines, outer_a, inner_a)->depth, 2.0, 1e-9);
}

TEST(Opposite, OfConcentricCylindersIsTheirDistance) {
  const SolidModel bent = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  const auto outlines = outlines_of(bent);
  const auto seen = opposite(bent, outlines, 3, 7);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->depth, 2.0, 1e-9);
  EXPECT_NEAR(seen->spread, 0.0, 1e-9);
  EXPECT_NEAR(seen->overlap, outlines[3].area, 1e-6) << "on the face it is seen from";
}

TEST(Opposite, SpreadTellsFacesThatAreNotParallel) {
  Loop wedge{Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 3}}, Segment{{100, 3}, {0, 2}},
             Segment{{0, 2}, {0, 0}}};
  const SolidModel model = prism({wedge}, 40);
  const auto seen = opposite(model, outlines_of(model), 2, 4);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->depth, 2.5, 1e-9);
  EXPECT_NEAR(seen->spread, 1.0, 1e-9);
}

}  // namespace
}  // namespace planish::brep::test
