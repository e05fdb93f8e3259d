#include "ring.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace transition_detail;

TEST(RingOf, ClosesFromPatchToPatch) {
  for (const Ring& ring : {square_to_circle(), antiprism(), pyramid(), frustum()})
    for (int i = 0; i < ring.count(); ++i) {
      const auto end = ring.patch(i).ruling(1.0), begin = ring.patch(i + 1).ruling(0.0);
      EXPECT_LT((end[0] - begin[0]).norm(), 1e-8);
      EXPECT_LT((end[1] - begin[1]).norm(), 1e-8);
    }
}

TEST(RingOf, KnowsTheExtentOfBothProfiles) {
  EXPECT_NEAR(pyramid().size, std::hypot(100, 100, 80), 1e-10);
}

TEST(RingOf, LiesOnTheNeutralSurface) {
  // A circle of radius 50 given for the inside, the middle or the outside of 4 mm at k = 0.4.
  for (const auto& [given, off] : {std::pair{SizesAre::inside, 0.4 * 4},
                                   {SizesAre::mid, -0.1 * 4},
                                   {SizesAre::outside, -0.6 * 4}}) {
    TransitionSpec spec = between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {0, 0, 80});
    spec.thickness = 4.0;
    spec.k_factor = 0.4;
    spec.sizes_are = given;
    const auto ring = ring_of(spec, {});
    ASSERT_TRUE(ring);
    EXPECT_NEAR(ring->patch(0).ruling(0.3)[0].norm(), 50.0 + off, 1e-12);
  }
}

TEST(RingOf, RefusesAThicknessThatTheRadiusDoesNotHold) {
  // The neutral surface of a tube of 2.4 mm about its middle, 5 mm thick: 2.5 mm lie inside it.
  TransitionSpec spec = between(EllipseProfile{2.4, 2.4}, EllipseProfile{2.4, 2.4}, {0, 0, 50});
  spec.thickness = 5.0;
  const auto refused = ring_of(spec, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::radius_too_small);
  spec.thickness = 4.79;
  EXPECT_TRUE(ring_of(spec, {}));
}

}  // namespace
}  // namespace planish::test
