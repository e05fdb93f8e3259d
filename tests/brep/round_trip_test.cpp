#include "support/round_trip.hpp"

#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/geometry/region.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <string>

// Sheet → solid → STEP → recognise → flatten must give what flattening the sheet gives.

namespace planish::test {
namespace {

TEST(RoundTrip, GivesBackBentStrips) {
  for (const Sheet& sheet : {l_bracket(), u_channel(), z_profile(), staircase(5), hem()})
    expect_round_trip(sheet);
}

TEST(RoundTrip, GivesBackClosedAndTeardropHems) {
  expect_round_trip(
      strip({Straight{40}, Turn{Angle::degrees(180), 0.005, BendDirection::up}, Straight{12}}, 20.0,
            1.0));
  expect_round_trip(strip(
      {Straight{40}, Turn{Angle::degrees(210), 1.5, BendDirection::up}, Straight{5}}, 20.0, 1.0));
}

TEST(RoundTrip, GivesBackBendsBeyondHalfATurn) {
  expect_round_trip(strip(
      {Straight{40}, Turn{Angle::degrees(250), 8.0, BendDirection::up}, Straight{4}}, 20.0, 1.0));
  expect_round_trip(strip({Turn{Angle::degrees(340), 12.0, BendDirection::up}}, 30.0, 1.0));
}

TEST(RoundTrip, GivesBackBoxesConesAndPlates) {
  for (const Sheet& sheet :
       {box(), cone_joined(), truncated_cone(30, 50, 40, Angle::degrees(300), 1.5),
        plate_with_holes(), ring(40, 15, 3)})
    expect_round_trip(sheet);
}

TEST(RoundTrip, GivesBackOpeningsInBends) {
  const std::map<std::string, Sheet> sheets{{"slot across", slot_across_bend()},
                                            {"slot into", slot_into_bend()},
                                            {"hole in", hole_in_bend(6.0, 0.44)},
                                            {"hole across", hole_across_bend(30.0, 0.44)}};
  for (const auto& [name, sheet] : sheets) {
    SCOPED_TRACE(name);
    expect_round_trip(sheet, 1e-5);
  }
}

TEST(RoundTrip, RecognisesSplineSurfacesAsWhatTheyAre) {
  for (const Sheet& sheet : {l_bracket(), cone_joined()}) {
    const Recognized again = recognized_again(as_ruled(sheet, Angle::degrees(3)));
    ASSERT_FALSE(again.sheet.bends.empty());
    EXPECT_NE(again.sheet.bends.front().kind, BendKind::general);
  }
}

/// Flat area and size as before, and a general bend of the same angle between the plates.
void expect_lofted_round_trip(const LoftedCorner& corner) {
  const Sheet sheet = lofted_corner(corner);
  const FlattenOptions options{.allowance = ConstantK{0.44, "test"}};
  const auto before = flatten(sheet, options);
  ASSERT_TRUE(before);
  const Recognized again = recognized_again(sheet);
  ASSERT_EQ(again.sheet.bends.size(), 1u);
  EXPECT_EQ(again.sheet.bends.front().kind, BendKind::general);
  EXPECT_NEAR(again.sheet.bends.front().angle.degrees(), sheet.bends.front().angle.degrees(), 1e-3);
  const auto after = flatten(again.sheet, options);
  ASSERT_TRUE(after) << after.error().message;
  const Traits a = traits_of(*before);
  const Traits b = traits_of(*after);
  EXPECT_NEAR(b.area, a.area, 1e-6 * a.area);
  EXPECT_NEAR(b.perimeter, a.perimeter, 1e-5 * a.perimeter);
  EXPECT_LT((b.size - a.size).norm(), 1e-5 * a.size.norm());
  const auto certificate = certify(again.sheet, *after, again.distance);
  ASSERT_TRUE(certificate);
  EXPECT_NEAR(*certificate->volume_ratio, 1.0, 1e-6);
  EXPECT_LT(*certificate->refold_deviation, 1e-4);
  EXPECT_LT(certificate->length_error, 1e-4);
}

TEST(RoundTrip, GivesBackPlatesJoinedByObliqueCones) {
  expect_lofted_round_trip({});
  expect_lofted_round_trip(other_side({}));
}

TEST(RoundTrip, GivesBackObliqueConesWhoseRectangleOfParametersHoldsTheApex) {
  LoftedCorner leaning;
  leaning.apex = {60, -10, 60};
  for (double near : {0.3, 0.1}) {
    leaning.near = near;
    expect_lofted_round_trip(leaning);
    expect_lofted_round_trip(other_side(leaning));
  }
}

TEST(RoundTrip, DoesNotDependOnPlaceOrScale) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.7, Vec3(3, -1, 2).normalized()))
      .pretranslate(Vec3(1000, -500, 70));
  expect_round_trip(moved(box(), motion));
  expect_round_trip(scaled(z_profile(), 10.0));
}

RC_GTEST_PROP(RoundTrip, GivesBackRandomSheets, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const int bends = *rc::gen::inRange(0, 6);
  expect_round_trip(random_sheet(random, bends));
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace planish::test
