#include "form_volume.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;

std::optional<double> volume_of_form(const Recognised& seen, int face) {
  return form_volume(seen.view(), seen.rim.parts.at(seen.rim.part_of.at(face)));
}

TEST(FormVolume, OfAPocketIsWhatItTakes) {
  const Recognised seen = recognised(
      plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 1.2}, {0, 1.2}}}}), 2, 1);
  EXPECT_NEAR(volume_of_form(seen, 6).value(), -pi * 64 * 0.8, 1e-8);
}

TEST(FormVolume, OfABossIsWhatItAdds) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{8, 2}, {8, 6}, {0, 6}}}}), 2,
                                     1);
  EXPECT_NEAR(volume_of_form(seen, 6).value(), pi * 64 * 4, 1e-8);
}

TEST(FormVolume, IsUnknownAtTheOuterContour) {
  const Recognised seen = recognised(plate(2, {100, 60}), 2, 1);
  EXPECT_FALSE(volume_of_form(seen, 2));
}

TEST(OpeningVolume, OfACountersinkIsTheRingRoundItsBore) {
  const Recognised seen = recognised(
      plate(2, {100, 60}, {{{30, 30}, {{4, 2}, {2.5, 0.5}, {2.5, 0}}}}), 2, 1);
  const RimPart& part = seen.rim.parts.at(seen.rim.part_of.at(6));
  const double bore = pi * 6.25;
  const double cone = pi / 3 * 1.5 * (16 + 10 + 6.25);
  EXPECT_NEAR(opening_volume(seen.view(), part, {part.first.front(), part.second.front()}, bore),
              -(cone - bore * 1.5), 1e-8);
}

TEST(OpeningVolume, OfAStraightHoleIsNothing) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  const RimPart& part = seen.rim.parts.at(seen.rim.part_of.at(6));
  EXPECT_NEAR(opening_volume(seen.view(), part, {part.first.front(), part.second.front()}, pi * 25),
              0.0, 1e-8);
}

TEST(OpeningInPlane, IsAnInnerLoopOfAPlane) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  EXPECT_TRUE(opening_in_plane(seen.view(), {1, 1}));
  EXPECT_FALSE(opening_in_plane(seen.view(), {1, 0}));
  EXPECT_FALSE(opening_in_plane(seen.view(), {6, 0}));
}

}  // namespace
}  // namespace planish::brep::test
