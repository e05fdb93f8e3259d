#include <planish/sheet/slots.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// A plate of 300 × 200 with slits of no width: closed ones are openings run there and back, open
// ones stretches of the outer contour.

namespace planish::test {
namespace {

using std::numbers::pi;
constexpr double kPlate = 300.0 * 200.0;

Contour contour_of(const std::vector<Vec2>& corners) {
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i)
    contour.loop.emplace_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  contour.origins.resize(corners.size());
  return contour;
}

FlatPattern plate(const std::vector<Vec2>& outer = {{0, 0}, {300, 0}, {300, 200}, {0, 200}}) {
  FlatPattern pattern;
  pattern.thickness = 2.0;
  pattern.outer = contour_of(outer);
  return pattern;
}

/// A slit from (100, 80) to (200, 80), its banks in pieces of their own.
FlatPattern closed_slit() {
  FlatPattern pattern = plate();
  pattern.openings.push_back(contour_of({{130, 80}, {200, 80}, {170, 80}, {150, 80}, {100, 80}}));
  return pattern;
}

/// A slit from the right side inwards to (180, 80).
FlatPattern open_slit() {
  return plate({{0, 0}, {300, 0}, {300, 80}, {180, 80}, {300, 80}, {300, 200}, {0, 200}});
}

FlatPattern cut(const FlatPattern& pattern, const SlotOptions& options) {
  auto result = cut_slits(pattern, options);
  if (!result) throw std::runtime_error(result.error().message);
  EXPECT_EQ(result->outer.loop.size(), result->outer.origins.size());
  for (const Contour& contour : result->openings)
    EXPECT_EQ(contour.loop.size(), contour.origins.size());
  return *result;
}

void expect_meeting(const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    EXPECT_LT((end_of(loop[i]) - start_of(loop[(i + 1) % loop.size()])).norm(), 1e-9) << i;
}

/// Length and area of the arc beyond the banks of a hole: what it adds to the slot's axis end.
double hole_angle(double half_width, double radius) { return std::asin(half_width / radius); }

TEST(Slots, ClosedSlitIsOneLine) {
  const FlatPattern pattern = cut(closed_slit(), {});
  EXPECT_TRUE(pattern.openings.empty());
  ASSERT_EQ(pattern.slits.size(), 1u);
  EXPECT_NEAR(length(pattern.slits[0]), 100.0, 1e-12);
  EXPECT_NEAR(pattern.area, kPlate, 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 + 100.0, 1e-9);
}

TEST(Slots, OpenSlitLeavesAPlainContour) {
  const FlatPattern pattern = cut(open_slit(), {});
  EXPECT_EQ(pattern.outer.loop.size(), 4u);
  ASSERT_EQ(pattern.slits.size(), 1u);
  EXPECT_NEAR(pattern.area, kPlate, 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 + 120.0, 1e-9);
}

TEST(Slots, KerfMakesARoundEndedSlot) {
  const FlatPattern pattern = cut(closed_slit(), {.kerf = 3.0});
  EXPECT_TRUE(pattern.slits.empty());
  ASSERT_EQ(pattern.openings.size(), 1u);
  EXPECT_EQ(pattern.openings[0].loop.size(), 4u);
  expect_meeting(pattern.openings[0].loop);
  EXPECT_NEAR(pattern.area, kPlate - (100 * 3 + pi * 1.5 * 1.5), 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 + 200.0 + 3 * pi, 1e-9);
}

TEST(Slots, StopHolesAreAddedAtBothEnds) {
  const FlatPattern pattern = cut(closed_slit(), {.kerf = 3.0, .stop_hole = 8.0});
  const double angle = hole_angle(1.5, 4.0), banks = 100 - 2 * std::sqrt(16 - 2.25);
  // Of each hole the circle less the segment cut off by the bank's chord.
  const double hole = pi * 16 - 0.5 * 16 * (2 * angle - std::sin(2 * angle));
  ASSERT_EQ(pattern.openings.size(), 1u);
  expect_meeting(pattern.openings[0].loop);
  EXPECT_NEAR(pattern.area, kPlate - (banks * 3 + 2 * hole), 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 + 2 * banks + 2 * 4.0 * (2 * pi - 2 * angle), 1e-9);
}

TEST(Slots, LinesEndAtTheirStopHoles) {
  const FlatPattern pattern = cut(closed_slit(), {.stop_hole = 8.0});
  EXPECT_EQ(pattern.openings.size(), 2u);
  ASSERT_EQ(pattern.slits.size(), 1u);
  EXPECT_NEAR(pattern.area, kPlate - 2 * 16 * pi, 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 + 92.0 + 2 * 8 * pi, 1e-9);
}

TEST(Slots, OpenSlotBelongsToTheOuterContour) {
  const FlatPattern pattern = cut(open_slit(), {.kerf = 4.0});
  EXPECT_TRUE(pattern.openings.empty());
  EXPECT_EQ(pattern.outer.loop.size(), 8u);
  expect_meeting(pattern.outer.loop);
  EXPECT_NEAR(pattern.area, kPlate - (120 * 4 + 0.5 * pi * 4), 1e-9);
  EXPECT_NEAR(pattern.perimeter, 1000.0 - 4 + 240 + 2 * pi, 1e-9);
}

TEST(Slots, OpenSlotHasOneStopHole) {
  const FlatPattern pattern = cut(open_slit(), {.kerf = 4.0, .stop_hole = 10.0});
  const double angle = hole_angle(2, 5), banks = 120 - std::sqrt(21.0);
  EXPECT_NEAR(pattern.area,
              kPlate - (banks * 4 + pi * 25 - 0.5 * 25 * (2 * angle - std::sin(2 * angle))), 1e-9);
}

TEST(Slots, SlitBesideAShorterStripEndsInAQuarterOfItsRoundEnd) {
  // The lower strip ends at 250, the upper one at 300.
  const FlatPattern pattern = cut(
      plate({{0, 0}, {250, 0}, {250, 80}, {180, 80}, {300, 80}, {300, 200}, {0, 200}}),
      {.kerf = 4.0});
  expect_meeting(pattern.outer.loop);
  EXPECT_NEAR(pattern.area, kPlate - 50 * 80 - (70 * 4 + 0.5 * pi * 4 + 0.25 * pi * 4), 1e-9);
}

TEST(Slots, SlantedMouthIsCutToTheSlantedSide) {
  // The right side leans: from (300, 0) to (320, 200), the slit leaves it at (308, 80).
  const FlatPattern pattern = cut(
      plate({{0, 0}, {300, 0}, {308, 80}, {180, 80}, {308, 80}, {320, 200}, {0, 200}}),
      {.kerf = 4.0});
  expect_meeting(pattern.outer.loop);
  // One bank meets the side; beyond the mouth's perpendicular the other one ends in its round end,
  // from there to the side.
  const double lean = std::atan(0.1);
  const double whole = 300 * 200 + 0.5 * 20 * 200;
  EXPECT_NEAR(pattern.area,
              whole - (128 * 4 + 0.5 * pi * 4 + 0.5 * 4 * lean - 0.5 * 2 * 2 * std::tan(lean)),
              1e-9);
}

TEST(Slots, OpeningsWithAWidthStayAndLoseTheirSlits) {
  FlatPattern pattern = plate();
  // Clockwise: an opening of 20 × 10 with a slit of 30 at its corner.
  pattern.openings.push_back(
      contour_of({{100, 80}, {100, 90}, {120, 90}, {120, 80}, {150, 80}, {120, 80}}));
  const FlatPattern lines = cut(pattern, {});
  ASSERT_EQ(lines.openings.size(), 1u);
  EXPECT_EQ(lines.openings[0].loop.size(), 4u);
  EXPECT_EQ(lines.slits.size(), 1u);
  EXPECT_NEAR(lines.area, kPlate - 200, 1e-9);
  const FlatPattern slots = cut(pattern, {.kerf = 2.0});
  expect_meeting(slots.openings[0].loop);
  // Beyond the mouth at the corner only half of the band and a quarter of the round end are in
  // material.
  EXPECT_NEAR(slots.area, kPlate - 200 - (30 * 2 + 0.5 * pi + 0.25 * pi), 1e-9);
}

TEST(Slots, BendLinesEndAtTheSlotsSides) {
  FlatPattern pattern = closed_slit();
  FlatBend bend;
  bend.lines = {{{150, 0}, {150, 200}}, {{200, 80}, {300, 80}}, {{60, 40}, {140, 120}}};
  bend.line_angles.resize(3);
  bend.tangent_lines = {{{150, 80}, {150, 200}}};
  bend.length = 200 + 100 + 80 * std::sqrt(2.0);
  pattern.bends = {bend};
  const FlatBend trimmed = cut(pattern, {.kerf = 4.0, .stop_hole = 10.0}).bends.front();
  ASSERT_EQ(trimmed.lines.size(), 5u);
  EXPECT_EQ(trimmed.line_angles.size(), 5u);
  EXPECT_NEAR(trimmed.lines[0].b.y(), 78.0, 1e-9);
  EXPECT_NEAR(trimmed.lines[1].a.y(), 82.0, 1e-9);
  EXPECT_NEAR(trimmed.lines[2].a.x(), 205.0, 1e-9);
  EXPECT_NEAR((trimmed.lines[4].a - trimmed.lines[3].b).norm(), 10.0, 1e-9)
      << "through the middle of the hole";
  EXPECT_NEAR(trimmed.tangent_lines[0].a.y(), 82.0, 1e-9);
  double sum = 0.0;
  for (const Segment& line : trimmed.lines)
    sum += (line.b - line.a).norm();
  EXPECT_NEAR(trimmed.length, sum, 1e-9);
}

TEST(Slots, PatternsWithoutSlitsStayAsTheyAre) {
  FlatPattern pattern = plate();
  pattern.openings.push_back(contour_of({{100, 80}, {100, 90}, {120, 90}, {120, 80}}));
  const FlatPattern same = cut(pattern, {.kerf = 2.0});
  EXPECT_EQ(same.openings.size(), 1u);
  EXPECT_EQ(same.outer.loop.size(), 4u);
}

TEST(Slots, RefusesOptionsThatAreNone) {
  for (const SlotOptions& options :
       {SlotOptions{.kerf = -1.0}, SlotOptions{.stop_hole = -1.0},
        SlotOptions{.kerf = 4.0, .stop_hole = 3.0}, SlotOptions{.kerf = std::nan("")},
        SlotOptions{.tolerance = 0.0}}) {
    const auto result = cut_slits(closed_slit(), options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
  }
}

TEST(Slots, RefusesAKerfWiderThanAStrip) {
  FlatPattern pattern = closed_slit();
  pattern.openings.push_back(contour_of({{100, 90}, {200, 90}}));
  EXPECT_TRUE(cut_slits(pattern, {.kerf = 9.9}));
  for (const SlotOptions& options :
       {SlotOptions{.kerf = 10.0}, SlotOptions{.kerf = 4.0, .stop_hole = 10.0}}) {
    const auto result = cut_slits(pattern, options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
  }
  // 80 mm to the lower side.
  EXPECT_TRUE(cut_slits(closed_slit(), {.kerf = 159.0}));
  EXPECT_FALSE(cut_slits(closed_slit(), {.kerf = 160.0}));
  EXPECT_FALSE(cut_slits(open_slit(), {.kerf = 160.0}));
}

TEST(Slots, RefusesASlitThatIsOpenAtACurve) {
  FlatPattern pattern = open_slit();
  pattern.outer.loop[1] = Arc{{300, 40}, 40, -pi / 2, pi};
  const auto result = cut_slits(pattern, {.kerf = 1.0});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, code::unsupported_shape);
}

}  // namespace
}  // namespace planish::test
