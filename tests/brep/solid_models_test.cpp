#include "solid_models.hpp"

#include "face_volume.hpp"

#include <gtest/gtest.h>

#include <numbers>

// The models that the other tests rest on hold what their makers say: volumes by closed forms.

namespace planish::brep::test {
namespace {

using std::numbers::pi;

TEST(SolidModels, PlateHasItsVolume) { EXPECT_NEAR(volume_of(plate(2, {100, 60})), 12000.0, 1e-8); }

TEST(SolidModels, PrismOfABentStripHasItsVolume) {
  const SolidModel model = prism({strip_profile(2, {{50, pi / 2, 3}, {30}})}, 40);
  EXPECT_NEAR(volume_of(model), 40 * (2 * 80 + pi / 4 * (25 - 9)), 1e-8);
}

TEST(SolidModels, TurnedSurfacesTakeAndGiveTheirVolume) {
  const Turned countersink{{20, 20}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}};
  const Turned boss{{60, 20}, {{8, 2}, {8, 6}, {0, 6}}};
  const Turned pocket_below{{60, 45}, {{0, 0.8}, {5, 0.8}, {5, 0}}};
  const double cone = pi / 3 * 1.5 * (16 + 10 + 6.25);
  EXPECT_NEAR(volume_of(plate(2, {100, 60}, {countersink, boss, pocket_below})),
              12000 - cone - pi * 6.25 * 0.5 + pi * 64 * 4 - pi * 25 * 0.8, 1e-7);
}

TEST(SolidModels, LoftedContoursHaveTheirVolume) {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inset = rectangle_at({0.5, 0.5}, {99.5, 59.5});
  const auto low = clockwise(rectangle_at({40, 20}, {60, 40}));
  const auto high = clockwise(rectangle_at({41, 20}, {61, 40}));
  const SolidModel model = plate(2, {{{outer, outer, inset}, {0, 1.5, 2}}, {{low, high}, {0, 2}}});
  // ∫ (100 − 2z)(60 − 2z) dz over 0 … ½
  const double chamfered = 6000 * 0.5 - 160 * 2 * 0.125 + 4.0 / 3 * 0.125;
  EXPECT_NEAR(volume_of(model), 9000 + chamfered - 800, 1e-8);
}

}  // namespace
}  // namespace planish::brep::test
