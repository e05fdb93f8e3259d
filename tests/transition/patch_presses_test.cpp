#include "ruled_patch.hpp"
#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

TEST(EvenlyTurned, DividesARightConeIntoEqualParts) {
  const Ring ring = frustum();
  const auto presses = ring.patch(0).evenly_turned(0.0, 1.0, 4);
  ASSERT_EQ(presses.size(), 4u);
  const double whole = 2 * kPi * 80 / std::hypot(80, 30);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(presses[i].at, (i + 0.5) / 4, 1e-9);
    EXPECT_NEAR(presses[i].turn, whole / 4, 1e-8);
  }
}

TEST(EvenlyTurned, PressesInTheMiddleOfWhatTurns) {
  const Ring ring = square_to_circle();
  const RuledPatch& patch = first_cone(ring);
  const double whole = patch.turn(0.0, 1.0);
  const auto presses = patch.evenly_turned(0.0, 1.0, 5);
  ASSERT_EQ(presses.size(), 5u);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(patch.turn(0.0, presses[i].at), (i + 0.5) / 5 * whole, 1e-8);
}

TEST(EvenlyAlong, PressesAtEqualDistancesByWhatTurnsThere) {
  const Ring ring = square_to_circle();
  const RuledPatch& patch = first_cone(ring);
  const auto presses = patch.evenly_along(1, 0.1, 0.9, 6);
  ASSERT_EQ(presses.size(), 6u);
  const double border = patch.border_length(1, 0.1, 0.9);
  double turned = 0.0;
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(patch.border_length(1, 0.1, presses[i].at), (i + 0.5) / 6 * border, 1e-6);
    turned += presses[i].turn;
  }
  EXPECT_NEAR(turned, patch.turn(0.1, 0.9), 1e-8);
  // By symmetry of the whole cone the outer lines press equally.
  const auto all = patch.evenly_along(1, 0.0, 1.0, 6);
  EXPECT_NEAR(all.front().turn, all.back().turn, 1e-8);
  EXPECT_GT(std::abs(all[0].turn - all[2].turn), 1e-4) << "an oblique cone turns unevenly";
}

}  // namespace
}  // namespace planish::test
