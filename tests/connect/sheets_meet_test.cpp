#include "sheets_meet.hpp"

#include "bend_frame.hpp"
#include "sample_fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace connect_detail;

std::optional<SheetsMeet> meeting_of(const Plate& first, const Plate& second, double thickness) {
  const PlacedPlate a = laid(first), b = laid(second);
  std::optional<SheetsMeet> found;
  for (const BendFrame& frame : bend_frames(a, b, PlanePair::crossing))
    if (const auto meet = sheets_meet(a, b, frame, thickness)) found = meet;
  return found;
}

/// A plate in z = 0 up to y = −gap, and one that leans by `degrees` from its plane, as far from the
/// line where they meet.
std::optional<SheetsMeet> hinged(double degrees, double gap, double thickness,
                                 double other_from = 0.0) {
  const double a = degrees * std::numbers::pi / 180;
  const Vec3 up(0, -std::cos(a), std::sin(a));
  return meeting_of(rectangle_plate("A", {0, -gap, 0}, {200, 0, 0}, {0, -100, 0}),
                    rectangle_plate("B", Vec3(other_from, 0, 0) + gap * up, {200, 0, 0}, 80 * up),
                    thickness);
}

TEST(SheetsMeet, AtTheCornersOfTheirSectionsNearTheLine) {
  // Inner corners of two sheets at an angle β touch at t / (2 tan(β/2)) from the line.
  for (const double degrees : {40.0, 90.0, 130.0}) {
    const double touch = 2.0 / (2 * std::tan(degrees * std::numbers::pi / 360));
    EXPECT_TRUE(hinged(degrees, touch - 0.05, 2.0)) << degrees;
    EXPECT_FALSE(hinged(degrees, touch + 0.05, 2.0)) << degrees;
  }
}

TEST(SheetsMeet, OnlyWhereBothAre) {
  EXPECT_TRUE(hinged(90, 0.2, 2.0, 190.0));
  EXPECT_FALSE(hinged(90, 0.2, 2.0, 201.0)) << "beside each other along the line";
  const auto at = hinged(90, 0.2, 2.0, 190.0);
  EXPECT_GE(at->at.x(), 190.0);
  EXPECT_LE(at->at.x(), 200.0);
  EXPECT_NEAR(at->at.z(), 0.0, 1e-9) << "on the first sheet";
}

TEST(SheetsMeet, WhereOnePassesThroughTheOther) {
  const Plate floor = rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0});
  EXPECT_TRUE(meeting_of(floor, rectangle_plate("B", {50, 50, -30}, {60, 0, 0}, {0, 0, 60}), 2.0));
  // Through a hole it passes.
  Plate holed = floor;
  holed.holes = {{{40, 40, 0}, {120, 40, 0}, {120, 60, 0}, {40, 60, 0}}};
  EXPECT_FALSE(meeting_of(holed, rectangle_plate("B", {50, 50, -30}, {60, 0, 0}, {0, 0, 60}), 2.0));
  EXPECT_TRUE(meeting_of(holed, rectangle_plate("B", {50, 59.5, -30}, {60, 0, 0}, {0, 0, 60}), 2.0))
      << "half of its thickness is in the border of the hole";
  EXPECT_TRUE(meeting_of(holed, rectangle_plate("B", {50, 50, -30}, {90, 0, 0}, {0, 0, 60}), 2.0))
      << "it is longer than the hole";
}

TEST(SheetsMeet, AtANarrowTooth) {
  // A tooth 0.5 wide that reaches the other sheet: between even sections, but beside its corners.
  const Plate toothed{"A",
                      {{0, -9, 0},
                       {0, -100, 0},
                       {200, -100, 0},
                       {200, -9, 0},
                       {101.3, -9, 0},
                       {101.3, -0.2, 0},
                       {100.8, -0.2, 0},
                       {100.8, -9, 0}},
                      {}};
  EXPECT_TRUE(meeting_of(toothed, rectangle_plate("B", {0, 0, 0.2}, {200, 0, 0}, {0, 0, 80}), 2.0));
}

TEST(SheetsMeet, NotWhereTheyAreParallel) {
  const PlacedPlate a = laid(rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}));
  const PlacedPlate b = laid(rectangle_plate("B", {0, 0, 1}, {200, 0, 0}, {0, 100, 0}));
  for (const BendFrame& frame : bend_frames(a, b, PlanePair::parallel))
    EXPECT_FALSE(sheets_meet(a, b, frame, 2.0));
}

}  // namespace
}  // namespace planish::test
