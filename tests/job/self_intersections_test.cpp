#include "self_intersections.hpp"

#include "support/sheets.hpp"

#include <planish/job/unfold.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace planish::job {
namespace {

namespace fs = std::filesystem;
using namespace planish::test;
using ::testing::HasSubstr;

constexpr double kK = 0.4;

std::string step_of(const Sheet& sheet) {
  auto step = folded_solid_step(sheet, "part");
  EXPECT_TRUE(step) << step.error().message;
  return step.value_or("");
}

std::vector<Finding> found_in(const Sheet& sheet) {
  const auto file = read_step_text(step_of(sheet), "part.step");
  if (!file) {
    ADD_FAILURE() << file.error().message;
    return {};
  }
  auto flat = flat_sheet(sheet, {.allowance = ConstantK{kK, ""}});
  if (!flat) {
    ADD_FAILURE() << flat.error().message;
    return {};
  }
  Report report;
  report.sheet = sheet;
  report.flat = flat->pattern;
  report.layout = flat->layout;
  return self_intersections(report, {file->bodies.front(), sheet});
}

/// `first` long | bend of 250° | 40: the second flange goes through the first.
Sheet folded_through_itself() {
  return strip({Straight{40}, Turn{Angle::degrees(250), 3.0, BendDirection::up}, Straight{40}}, 20,
               1.2);
}

TEST(SelfIntersectionFindings, NameBothFlangesTheDepthAndBothPlaces) {
  const auto found = found_in(folded_through_itself());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "self_intersection");
  EXPECT_EQ(found[0].severity, Severity::error);
  // The plates are 1.2 thick and cross at 70°.
  EXPECT_EQ(found[0].message, "flanges 1 and 2 run through each other when folded, 1.2 mm deep");
  EXPECT_EQ(found[0].about, (std::vector<Place>{place::flange(1), place::flange(2)}));
  ASSERT_EQ(found[0].numbers.size(), 1u);
  EXPECT_EQ(found[0].numbers[0].name, "depth");
  EXPECT_NEAR(found[0].numbers[0].quantity.value, 1.2, 0.05);
  // The middles of the flanges cross a tangent length (r + t/2)(1 − cos α)/sin α before and behind
  // the bend; the ball may lie anywhere within what they share, 1.2 mm wide.
  const double angle = 250 * std::numbers::pi / 180;
  const double tangent = 3.6 * (1 - std::cos(angle)) / std::sin(-angle);
  const double apart = 2 * tangent + angle * (3.0 + kK * 1.2);
  ASSERT_GE(found[0].at.size(), 2u);
  for (std::size_t i = 0; i + 1 < found[0].at.size(); i += 2)
    EXPECT_NEAR((found[0].at[i] - found[0].at[i + 1]).norm(), apart, 1.2);
}

TEST(SelfIntersectionFindings, WarnOfEdgesThatPressWithoutPassingThrough) {
  // A channel whose return ends in its first wall, by three quarters of the thickness.
  const double t = 2.0, r = 3.0, deep = 0.75 * t;
  const Turn right{Angle::degrees(90), r, BendDirection::up};
  const double back = 40 + r + deep;  // to the inner skin and into it
  const auto found = found_in(strip(
      {Straight{60}, right, Straight{40}, right, Straight{30}, right, Straight{back}}, 20, t));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::warning);
  EXPECT_NEAR(found[0].numbers[0].quantity.value, deep, 0.05);
  EXPECT_THAT(found[0].message, HasSubstr("flanges 1 and 4 need the same space when folded"));
}

TEST(SelfIntersectionFindings, NameTheBendsOfATubeRolledOntoItself) {
  const Turn half{Angle::degrees(200), 20, BendDirection::up};
  const auto found = found_in(strip({half, half}, 50, 1.5));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].message, "bends B1 and B2 run through each other when folded, 1.5 mm deep");
}

TEST(SelfIntersectionFindings, NameABendAndAFlange) {
  // Two bends of middle radius m: the second, of 225°, sends the last flange at 45° through the
  // middle of the first, square to it.
  const double m = 10.5;
  const double between = (1 + std::numbers::sqrt2) * m - m;
  const auto found = found_in(
      strip({Straight{30}, Turn{Angle::degrees(90), 10, BendDirection::up}, Straight{between},
             Turn{Angle::degrees(225), 10, BendDirection::up}, Straight{26}},
            15, 1.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].message, "flange 3 and bend B1 run through each other when folded, 1 mm deep");
  EXPECT_EQ(found[0].about, (std::vector<Place>{place::flange(3), place::bend("B1")}));
}

TEST(SelfIntersectionFindings, AreNoneInSheetsThatCanBeMade) {
  for (const Sheet& sheet :
       {l_bracket(), l_bracket_down(), u_channel(), z_profile(), staircase(3), hem(), turn_of_250(),
        two_turns_of_270(), rolled(), box(), box({}, BendDirection::down), cone_joined(),
        truncated_cone(30, 60, 80, Angle::degrees(359.9), 2), lofted_corner(), slot_across_bend(),
        slot_into_bend(), hole_in_bend(6, 0.44), hole_across_bend(20, 0.44),
        strip({Straight{30}, Crease{Angle::degrees(90), BendDirection::down}, Straight{20}}, 20,
              2)}) {
    const auto found = found_in(sheet);
    EXPECT_TRUE(found.empty()) << found.front().message;
  }
}

TEST(SelfIntersectionFindings, AreNoneInTubesRolledUntilTheirEdgesMeet) {
  for (const double degrees : {359.0, 359.99})
    EXPECT_TRUE(
        found_in(strip({Turn{Angle::degrees(degrees), 20, BendDirection::up}}, 50, 1.5)).empty());
}

TEST(SelfIntersectionFindings, CostNothingForAFlatPlate) {
  Report report;
  report.sheet = plate_with_holes();
  const auto file = read_step_text(step_of(l_bracket()), "other.step");
  ASSERT_TRUE(file);
  EXPECT_TRUE(self_intersections(report, {file->bodies.front(), report.sheet}).empty());
}

class UnfoldedSolid : public ::testing::Test {
 protected:
  void SetUp() override { path_ = fs::path(::testing::TempDir()) / "through_itself.step"; }
  void TearDown() override { fs::remove(path_); }
  fs::path path_;
};

TEST_F(UnfoldedSolid, ThatRunsThroughItselfIsRefusedUnlessToldNotTo) {
  std::ofstream(path_) << step_of(folded_through_itself());
  Request request;
  request.input = path_;
  request.rules.enabled = false;
  const auto refused = unfold(request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code.name, "self_intersection");
  request.write_anyway = true;
  const auto report = unfold(request);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->status(), Status::warning);
  ASSERT_EQ(report->findings.size(), 1u);
  EXPECT_EQ(report->findings[0].code, "self_intersection");
  EXPECT_THAT(report->findings[0].message, HasSubstr("1.2 mm deep"));
}

}  // namespace
}  // namespace planish::job
