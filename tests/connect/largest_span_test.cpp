#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

/// Two plates 200 × 100 at a right angle: their bend is an arc of radius `gap`.
double reach_of(double gap) { return pi / 2 * gap; }

TEST(LargestSpan, LeavesPlatesAtTheirDistanceUnjoined) {
  PlateStructure s = angle_pair(30.0);
  s.largest_span = reach_of(30.0) - 0.5;
  const auto apart = connect(s);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::too_far_apart);
  EXPECT_EQ(apart.error().where, "/plates/1");
  // The span is that of the thesis, with the arc linearised at a slope of 0.3.
  EXPECT_THAT(apart.error().message, HasSubstr("at most 46.62 mm is bridged"));
  s.largest_span = 1.02 * reach_of(30.0);
  EXPECT_TRUE(connect(s));
}

TEST(LargestSpan, IsTwiceTheDiagonalsOfBothPlates) {
  const double diagonals = 2.0 * std::hypot(200.0, 100.0);
  const double limit = 2.0 * diagonals / (pi / 2);  // as a gap
  EXPECT_TRUE(connect(angle_pair(0.95 * limit)));
  const auto apart = connect(angle_pair(1.05 * limit));
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::too_far_apart);
  EXPECT_THAT(apart.error().message, HasSubstr("at most 894.4 mm is bridged"));
}

TEST(LargestSpan, HoldsABendThatIsGivenOnlyIfItIsGivenToo) {
  PlateStructure s = angle_pair(2000.0);
  s.bends = {{.between = {"A", "B"}}};
  EXPECT_TRUE(connect(s));
  s.largest_span = 1000.0;
  const auto apart = connect(s);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::too_far_apart);
  EXPECT_EQ(apart.error().where, "/bends/0");
}

TEST(LargestSpan, DoesNotCountTheShiftOfTheEnds) {
  // A wall of 40 on a floor of 2000.
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("floor", {0, 0, 0}, {2000, 0, 0}, {0, 100, 0}),
              rectangle_plate("wall", {0, 110, 10}, {40, 0, 0}, {0, 0, 50})};
  s.largest_span = 1.05 * reach_of(10.0);
  const auto c = connect(s);
  ASSERT_TRUE(c) << c.error().message;
  EXPECT_NEAR(c->bends[0].reach, reach_of(10.0), 0.02 * reach_of(10.0));
  EXPECT_NEAR(c->bends[0].joined, 40.0, 1e-9);
}

TEST(LargestSpan, KeepsFarPartsOfAStructureApart) {
  // Two right angles, each joined in itself, 5 m from each other.
  PlateStructure s = angle_pair(14.0);
  for (Plate plate : angle_pair(14.0).plates) {
    plate.id += "2";
    for (Vec3& p : plate.outline)
      p += Vec3(0, 5000, 300);
    s.plates.push_back(plate);
  }
  const auto apart = connect(s);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::too_far_apart);
}

}  // namespace
}  // namespace planish::test
