#include "rim_volume.hpp"

#include "recognised.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace planish::brep::test {
namespace {

TEST(ClosedRim, GoesRoundBendsOnBothSkins) {
  const Recognised seen = recognised(
      prism({strip_profile(2, {{40, std::numbers::pi / 2, 3}, {30, 0, 0}})}, 50), 2, 2);
  ASSERT_EQ(seen.rim.parts.size(), 1u);
  const auto rim = closed_rim(seen.view(), 0);
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->parts.size(), 1u);
  EXPECT_EQ(rim->loops.size(), 6u) << "two flanges and a bend, each on either skin";
}

TEST(ClosedRim, OfAnOpeningIsItsOwn) {
  const Recognised seen = recognised(plate(2, {100, 60}, {{{30, 30}, {{5, 2}, {5, 0}}}}), 2, 1);
  const int hole = seen.rim.part_of.at(6);
  const auto rim = closed_rim(seen.view(), hole);
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->parts, std::set<int>{hole});
  EXPECT_EQ(rim->loops, (std::set<LoopRef>{{kBottom, 1}, {kTop, 1}}));
}

}  // namespace
}  // namespace planish::brep::test
