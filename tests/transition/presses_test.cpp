#include "presses.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace transition_detail;

Ring tube() { return ring_between(EllipseProfile{50, 50}, EllipseProfile{50, 50}, {0, 0, 80}); }

std::size_t lines(const Pressing& pressing, double from = 0.0, double to = 1.0) {
  const Ring ring = tube();
  return presses_of(ring.patch(0), from, to, pressing).size();
}

TEST(PressesOf, ARolledBendAreNone) { EXPECT_EQ(lines({}), 0u); }

TEST(PressesOf, ACountAreSoManySharedByWhatASeamDivides) {
  EXPECT_EQ(lines(PressCount{7}), 7u);
  EXPECT_EQ(lines(PressCount{7}, 0.0, 0.5) + lines(PressCount{7}, 0.5, 1.0), 7u);
  EXPECT_EQ(lines(PressCount{1}, 0.0, 0.1), 1u) << "at least one";
}

TEST(PressesOf, ALargestAngleAreAsFewAsCanBe) {
  EXPECT_EQ(lines(PressAngle{Angle::degrees(10)}), 36u) << "360° by 10°, whatever rounding says";
  EXPECT_EQ(lines(PressAngle{Angle::degrees(11)}), 33u);
  EXPECT_EQ(lines(PressAngle{Angle::degrees(10)}, 0.0, 0.25), 9u);
}

TEST(PressesOf, ALargestChordAreAlongTheWiderProfile) {
  // 2π · 50 = 314.16 mm below, 125.7 mm above.
  const Ring ring = frustum();
  EXPECT_EQ(presses_of(ring.patch(0), 0.0, 1.0, PressChord{10.0}).size(), 32u);
}

TEST(CheckPresses, RefusesMoreLinesThanAnybodyPresses) {
  const Ring ring = tube();
  EXPECT_TRUE(check_presses(ring, {whole(ring)}, PressCount{2000}));
  const auto refused = check_presses(ring, {whole(ring)}, PressCount{2001});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::invalid_input);
  EXPECT_EQ(refused.error().where, "/press_lines");
  EXPECT_TRUE(check_presses(pyramid(), {whole(pyramid())}, PressCount{2001})) << "planes only";
}

}  // namespace
}  // namespace planish::test
